"""The JavaScript that others ship: whole, packed and unpacked the same, and named by its digest."""

import gzip
import hashlib
from base64 import b64decode, b64encode

import pytest

from vpr_bench.errors import DataError
from vpr_bench.page import libraries
from vpr_bench.page.libraries import chart_library, script_digest, table_library


@pytest.mark.parametrize("library", [chart_library, table_library])
def test_what_is_packed_is_the_script_that_the_digest_names(library):
    one = library()
    unpacked = gzip.decompress(b64decode(one.packed))
    assert unpacked.decode() == one.source
    assert one.digest == "sha256-" + b64encode(hashlib.sha256(unpacked).digest()).decode()
    assert "MIT" in one.about


def test_a_module_becomes_a_script_that_names_its_default_export():
    script = libraries._as_script("var vh=1,x=2;export{x as Other,vh as default};\n/*! licence */\n", "Table")
    assert script == "(()=>{var vh=1,x=2;\nglobalThis.Table=vh;\n/*! licence */\n})();"


@pytest.mark.parametrize("module", ["var a=1;", "export{a as b};", "export{a as default};more();export{b};\n"])
def test_a_module_of_another_kind_is_refused(module):
    with pytest.raises(DataError, match="another version"):
        libraries._as_script(module, "Table")


def test_a_package_without_its_script_is_named():
    with pytest.raises(DataError, match=r"package plotly has no nothing\.js: install it again"):
        libraries._shipped("plotly", "nothing.js")
    with pytest.raises(DataError, match="package nowhere_at_all"):
        libraries._shipped("nowhere_at_all", "nothing.js")


def test_a_digest_is_that_of_the_bytes_in_utf_8():
    assert script_digest("é") == "sha256-" + b64encode(hashlib.sha256("é".encode()).digest()).decode()
