import sys

import pytest

from vpr_bench.method.build import build_method

METHOD = "{imports}\nclass Mine:\n    def fit(self, r): ...\n    def match(self, i, k): ...\n"


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.setattr(sys, "path", sys.path.copy())
    before = set(sys.modules)
    yield tmp_path
    for name in set(sys.modules) - before:
        del sys.modules[name]


def write(folder, name, source):
    path = folder / name
    path.parent.mkdir(exist_ok=True)
    path.write_text(source, "utf-8")
    return path


def test_a_method_in_a_file_has_the_digest_of_its_source(folder):
    path = write(folder, "mine.py", METHOD.format(imports=""))
    first = build_method(f"{path}:Mine")
    assert (first.id, first.label) == ("mine.py:Mine", "mine.py:Mine")
    moved = build_method(f"{write(folder, 'elsewhere/mine.py', path.read_text())}:Mine")
    assert (moved.id, moved.version) == (first.id, first.version)
    write(folder, "mine.py", path.read_text() + "    size = 3\n")
    assert build_method(f"{path}:Mine").version != first.version


def test_helpers_beside_it_count_however_they_are_imported(folder):
    imports = "import helper_one\nfrom helping.parts import x\nimport numpy"
    write(folder, "helper_one.py", "import helper_two")
    write(folder, "helper_two.py", "import helper_one")  # in a circle
    write(folder, "helping/__init__.py", "")
    write(folder, "helping/parts.py", "x = 1")
    write(folder, "unrelated.py", "")
    path = write(folder, "mine.py", METHOD.format(imports=imports))
    versions = [build_method(f"{path}:Mine").version]
    for name in ("helper_two.py", "helping/parts.py", "unrelated.py"):
        write(folder, name, (folder / name).read_text() + "\n# edited")
        versions.append(build_method(f"{path}:Mine").version)
    assert len(set(versions[:3])) == 3
    assert versions[3] == versions[2]


def test_a_declared_version_wins(folder):
    path = write(folder, "mine.py", METHOD.format(imports="") + "    version = '7'\n")
    assert build_method(f"{path}:Mine").version == "7"
