from pathlib import Path

import pytest

from vpr_bench.dataset.layout import Layout, Recognised, find_layout, recognise
from vpr_bench.dataset.own import own_card
from vpr_bench.errors import DataError, UsageError

PROTOCOL = {"references": "a", "queries": "b", "radius": 1}
FOUND = Recognised("two walks", "f", [{"name": "a"}, {"name": "b"}], [PROTOCOL])


@pytest.fixture
def layouts(monkeypatch):
    """Replace all layouts by some that recognise what they are told to."""

    def put(**said):
        def asked(answer):
            def ask(folder):
                if isinstance(answer, Exception):
                    raise answer
                return answer

            return ask

        made = {
            name: Layout(name, load=print, recognise=asked(answer), rank=rank) for name, (rank, answer) in said.items()
        }
        registry = type("Registry", (), {"load_all": staticmethod(lambda: made)})
        monkeypatch.setattr("vpr_bench.dataset.layout.LAYOUTS", registry)
        monkeypatch.setattr("vpr_bench.dataset.layout.find_layout", made.__getitem__)

    return put


def test_the_most_specific_layout_comes_first(layouts):
    layouts(low=(1, FOUND), high=(9, FOUND), none=(5, None))
    assert [name for name, _ in recognise(Path())] == ["high", "low"]


def test_a_broken_folder_is_broken_for_its_most_specific_layout_only(layouts):
    layouts(low=(1, DataError("no fix")), high=(9, FOUND))
    assert [name for name, _ in recognise(Path())] == ["high"]
    layouts(low=(1, FOUND), high=(9, DataError("no fix")))
    with pytest.raises(DataError, match="no fix"):
        recognise(Path())
    assert [name for name, _ in recognise(Path(), only="low")] == ["low"]


def test_what_a_layout_raises_is_told_in_one_line(layouts):
    layouts(wrong=(1, KeyError("x")))
    with pytest.raises(DataError, match=r"The layout .wrong. failed on .*KeyError"):
        recognise(Path())


@pytest.mark.parametrize(
    "traverses", [[{"name": "a"}, {"name": "a"}], [{"name": ""}, {"name": "b"}], [{"name": "a", "folder": "c:d"}]]
)
def test_a_folder_that_makes_no_dataset_is_a_data_error(layouts, tmp_path, traverses):
    layouts(only=(1, Recognised("two walks", "f", traverses, [PROTOCOL])))
    with pytest.raises(DataError, match="cannot be described"):
        own_card(tmp_path)


def test_a_layout_that_does_not_exist():
    with pytest.raises(UsageError, match=r"There is no layout .numberd.\. Did you mean 'numbered'"):
        find_layout("numberd")
