from pathlib import Path

import pytest

from vpr_bench.dataset.lint.numbering import frame_numbers
from vpr_bench.types.traverse import Traverse


def names(numbers, pattern="{:05d}.png"):
    return [pattern.format(number) for number in numbers]


def test_frames_that_one_traverse_has_lost(made):
    made.write("day", names(range(1, 11)), 0)
    made.write("night", names([2, 7, 8, 9, 14, 15, 16, 17, 18, 19]), 100)
    finding = made.only()
    assert (finding.check, finding.severity, finding.where) == ("misaligned-names", "warning", "day-night")
    assert "10 of 10 labels, such as day/00001.png and night/00002.png" in finding.message
    assert finding.message.endswith("day 0, night 2")


def test_the_same_gaps_everywhere(made):
    made.write("day", names([1, 2, 5, 6, 7, 12, 13, 14, 15, 16]), 0)
    made.write("night", names([1, 2, 5, 6, 7, 12, 13, 14, 15, 16]), 100)
    assert made.lint() == []


def test_labels_that_are_the_numbers_may_have_gaps(made):
    numbers = [1, 2, 4, 5, 6, 8, 9, 10, 11, 12]
    made.write("night", names(numbers), 100)
    made.options["night"] = {"labels": numbers}
    assert [one.check for one in made.lint()] == ["query-without-match"]


def test_counted_from_elsewhere_is_a_note(made):
    made.write("night", names(range(1, 11), "{:02d}.png"), 100)
    finding = made.only()
    assert (finding.check, finding.severity) == ("misaligned-names", "note")
    assert "1 apart from those of the same place: day/00.png and night/01.png" in finding.message


def test_times_of_day_are_no_numbers_of_frames(made):
    made.write("day", names(1400000000 + 1000 * n + n**3 for n in range(10)), 0)
    made.write("night", names(1500000000 + 1000 * n + 5 * n**2 for n in range(10)), 100)
    assert made.lint() == []


def test_numbers_sorted_by_spelling(made):
    for first, name in ((0, "day"), (100, "night")):
        made.write(name, names(range(8, 18), "img{}.png"), first)
    found = made.lint()
    assert [(one.check, one.severity, one.where) for one in found] == [
        ("misaligned-names", "warning", "day"),
        ("misaligned-names", "warning", "night"),
    ]
    assert found[0].message.startswith("day/img8.png comes right after day/img17.png")


@pytest.mark.parametrize(
    "files",
    [["a.png", "b.png"], ["a1.png", "b2.png"], ["one/1.png", "two/1.png"], ["1" * 200 + ".png"], ["1.png", "x.png"]],
)
def test_names_without_a_number_of_the_frame(files):
    assert frame_numbers(Traverse("walk", [Path(file) for file in files])) is None
