import sys
import warnings
from importlib.metadata import EntryPoint
from types import SimpleNamespace

import pytest

from vpr_bench.errors import UsageError
from vpr_bench.registry import Entry, PluginWarning, Registry, import_object


def point(name, value, package="ours", version="1.0"):
    found = EntryPoint(name, value, "vpr_bench.methods")
    vars(found).update(dist=SimpleNamespace(name=package, version=version) if package else None)
    return found


def registry(*points, kind=None):
    def find(group):
        assert group == "vpr_bench.methods"
        return points

    return Registry("vpr_bench.methods", "method", kind, find)


@pytest.fixture
def plugin(tmp_path, monkeypatch):
    """Return a writer of importable modules; what they import is forgotten afterwards."""
    monkeypatch.syspath_prepend(tmp_path)
    before = set(sys.modules)

    def write(name, source):
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(source, "utf-8")
        return path

    yield write
    for name in set(sys.modules) - before:
        del sys.modules[name]


def test_entry_points_are_listed_by_name_and_imported_when_they_are_loaded(plugin):
    plugin("late_plugin.py", "class Late: pass")
    methods = registry(point("late", "late_plugin:Late", "third", "2.5"), point("early", "math:pi"))
    assert [entry.name for entry in methods.entries()] == ["early", "late"]
    entry = methods.entry("late")
    assert (entry.target, entry.origin) == ("late_plugin:Late", "third 2.5")
    assert "late_plugin" not in sys.modules
    assert entry.load().__name__ == "Late"


def test_an_entry_point_without_a_package_is_usable():
    assert registry(point("pi", "math:pi", package=None)).entry("pi").origin == "unknown package"


def test_an_object_is_named_by_its_module():
    entry = registry().entry("collections.abc:Sequence")
    assert entry == Entry("collections.abc:Sequence", "collections.abc:Sequence", "not installed")
    assert entry.load().__name__ == "Sequence"


def test_an_object_is_named_by_its_file(plugin, monkeypatch):
    path = plugin("mine.py", 'class Thing:\n    """A thing."""\n    size: int = 3')
    monkeypatch.chdir(path.parent)
    for name in ("mine.py:Thing", "./mine.py:Thing", f"{path}:Thing"):
        entry = registry().entry(name)
        assert entry == Entry("mine.py:Thing", f"{path}:Thing", "not installed")  # the folder is nobody's business
        assert entry.load().__name__ == "Thing"
        assert (entry.summary(), entry.parameters()) == ("A thing.", {"size": "3"})


def test_a_file_without_a_class_is_asked_for_one():
    with pytest.raises(UsageError, match=r"Which class of that file is the method\? Write mine.py:Class."):
        registry().entry("mine.py")


def test_import_reaches_into_objects():
    assert import_object("collections:OrderedDict.fromkeys", "it")("a") == {"a": None}


@pytest.mark.parametrize("target", ["no_such_module:x", "math:no_such_name", "math"])
def test_what_cannot_be_imported_is_named(target):
    with pytest.raises(UsageError, match="The loader of x cannot be loaded from"):
        import_object(target, "The loader of x")


@pytest.mark.parametrize("name", ["hogg", "no such:thing", "mod:", ":Class", "", "../x:y"])
def test_an_unknown_name_is_refused(name):
    with pytest.raises(UsageError, match=r"There is no method .*(Did you mean 'hog'\?|Known: hog\.)"):
        registry(point("hog", "math:pi")).entry(name)


def test_the_closest_name_is_suggested():
    with pytest.raises(UsageError, match=r"There is no method 'twostag'. Did you mean 'twostage\'\?"):
        registry(point("hog", "math:pi"), point("twostage", "math:e")).entry("twostag")


@pytest.mark.parametrize(
    ("target", "reason"),
    [
        ("no_such_module:Thing", "ModuleNotFoundError: No module named 'no_such_module'"),
        ("math:sqrrt", r"there is no 'sqrrt' in it. Did you mean 'sqrt'\?"),
        ("breaks_at_import:Thing", "breaks_at_import.py, line 1: RuntimeError: no licence"),
    ],
)
def test_what_cannot_be_loaded_says_where_it_is_from_and_why(plugin, target, reason):
    plugin("breaks_at_import.py", "raise RuntimeError('no licence')")
    with pytest.raises(UsageError, match=rf"'bad' \(third 3.1\) cannot be loaded from {target}: {reason}"):
        registry(point("bad", target, "third", "3.1")).entry("bad").load()


def test_a_name_that_two_packages_claim_is_refused_when_used():
    methods = registry(point("hog", "math:pi", "ours", "1.0"), point("hog", "math:e", "theirs", "2.0"))
    with pytest.raises(UsageError, match=r"'hog' is claimed by ours 1.0 and theirs 2.0: uninstall one"):
        methods.entry("hog")


def test_a_name_that_two_packages_claim_is_left_out_of_lists_with_one_warning():
    methods = registry(point("hog", "math:pi", "ours"), point("hog", "math:e", "theirs"), point("sift", "math:e"))
    with pytest.warns(PluginWarning, match="ours 1.0 and theirs 1.0") as warned:
        entries = methods.entries()
    assert len(warned) == 1
    assert [entry.name for entry in entries] == ["sift"]


def test_the_same_package_found_twice_is_no_duplicate():
    methods = registry(point("hog", "math:pi"), point("hog", "math:pi"))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert len(methods.entries()) == 1
    assert methods.entry("hog").load() == import_object("math:pi", "pi")


def test_a_broken_plug_in_is_left_out_with_one_warning_and_the_others_load(plugin):
    plugin("breaks_at_import.py", "raise RuntimeError('no licence')")
    methods = registry(point("bad", "breaks_at_import:Thing", "third"), point("good", "math:pi"))
    with pytest.warns(PluginWarning, match="Left out method 'bad': .*third 1.0.*no licence") as warned:
        assert list(methods.load_all()) == ["good"]
    assert len(warned) == 1


def test_a_plug_in_that_is_something_else_is_left_out_with_one_warning():
    methods = registry(point("join", "os.path:join"), point("pi", "math:pi"), kind=float)
    with pytest.warns(PluginWarning, match="'join' must be a builtins.float. Got function instead") as warned:
        assert list(methods.load_all()) == ["pi"]
    assert len(warned) == 1
    with pytest.raises(UsageError, match="Got function"):
        methods.find("join")
    assert methods.find("pi") == import_object("math:pi", "pi")


def test_a_plug_in_with_an_id_has_that_name(plugin):
    plugin("named.py", "from types import SimpleNamespace\ncard = SimpleNamespace(id='sift')\n")
    methods = registry(point("hog", "named:card"), point("sift", "named:card"))
    assert methods.find("sift").id == "sift"
    with pytest.raises(UsageError, match="'hog' has the id 'sift': both must be the same"):
        methods.find("hog")


def test_the_summary_is_read_without_importing(plugin):
    source = 'raise RuntimeError\nclass Other: "Other."\nclass Third:\n    """One line.\n\n    More.\n    """\n'
    plugin("never_imported.py", source)
    assert Entry("third", "never_imported:Third", "third 1.0").summary() == "One line."
    assert "never_imported" not in sys.modules


def test_a_function_has_a_summary_too(plugin):
    plugin("with_function.py", 'def third(): "Makes one."')
    assert Entry("third", "with_function:third", "third 1.0").summary() == "Makes one."


@pytest.mark.parametrize(
    "target",
    [
        "no_such_module:Thing",
        "no_such_package.module:Thing",
        "undocumented:Thing",
        "undocumented:Missing",
        "not_python:Thing",
        "binary:Thing",
        "sys:path",
        "",
    ],
)
def test_there_is_no_summary_where_there_is_nothing_to_read(plugin, target):
    plugin("undocumented.py", "class Thing: pass")
    plugin("not_python.py", "class Thing(:")
    plugin("binary.py", "").write_bytes(b"\xff\xfe\x00")
    assert Entry("thing", target, "third 1.0").summary() == ""


def test_a_summary_is_read_without_running_the_package(plugin):
    plugin("broken_package/__init__.py", "raise RuntimeError('no licence')")
    plugin("broken_package/module.py", 'class Thing: "Found all the same."')
    assert Entry("thing", "broken_package.module:Thing", "third 1.0").summary() == "Found all the same."


def test_packages_are_not_run_to_read_what_is_in_them(plugin):
    plugin("broken_package/__init__.py", "raise RuntimeError('no licence')")
    plugin("broken_package/module.py", 'class Thing: "Never run."')
    assert Entry("thing", "broken_package.module:Thing", "third 1.0").summary() == "Never run."


def test_a_name_is_known_or_not():
    methods = registry(point("hog", "math:pi"))
    assert "hog" in methods and "math:pi" not in methods


def test_the_installed_plug_ins_are_found():
    methods = Registry("vpr_bench.methods", "method")
    assert {"hog", "twostage"} <= {entry.name for entry in methods.entries()}
    assert methods.entry("hog").origin.startswith("vpr-bench ")
    assert all(entry.summary() for entry in methods.entries() if entry.origin.startswith("vpr-bench "))


def test_parameters_are_read_without_importing(tmp_path, monkeypatch):
    monkeypatch.syspath_prepend(tmp_path)
    (tmp_path / "heavy_plugin.py").write_text(
        "raise ImportError('must not be imported')\n"
        "@dataclass\n"
        "class Fields:\n"
        "    version: ClassVar[str] = '1'\n"
        "    size: int\n"
        "    kind: str = 'cosine'\n"
        "class Plain:\n"
        "    def __init__(self, depth=5, *, wide: bool = True): ...\n"
    )
    assert Entry("a", "heavy_plugin:Fields", "x").parameters() == {"size": "required", "kind": "'cosine'"}
    assert Entry("a", "heavy_plugin:Plain", "x").parameters() == {"depth": "5", "wide": "True"}
    assert Entry("a", "heavy_plugin:Nothing", "x").parameters() == {}
