import pytest

from vpr_bench.errors import DataError
from vpr_datasets.layouts.inside import inside


@pytest.mark.parametrize("name", ["GT.npz", "more/GT.npz", "./GT.npz", "..GT.npz", "größe.txt"])
def test_a_name_leads_into_the_folder(tmp_path, name):
    assert inside(tmp_path, name).resolve().is_relative_to(tmp_path)


@pytest.mark.parametrize(
    "name", ["", ".", "..", "../GT.npz", "a/../../GT.npz", "/etc/passwd", "C:\\x", "..\\x", "a\0b", None, 3, ["x"]]
)
def test_no_name_leads_out_of_it(tmp_path, name):
    with pytest.raises(DataError, match="is no file in"):
        inside(tmp_path, name)
