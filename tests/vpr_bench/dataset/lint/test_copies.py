import shutil

from vpr_bench.dataset.lint.copies import find_repeated
from vpr_bench.types.traverse import Traverse


def test_a_query_among_the_references(made):
    shutil.copy(made.image("day", 3), made.image("night", 4))
    made.protocols += [{"references": "day", "queries": "night", "radius": 2}]
    finding = made.only()
    assert (finding.check, finding.severity, finding.where) == ("duplicate", "error", "day-night")
    assert finding.message.endswith("1 of 10 queries: night/04.png is day/03.png")


def test_an_image_that_is_there_twice(made):
    shutil.copy(made.image("day", 3), made.image("day", 7))
    finding = made.only()
    assert (finding.check, finding.severity, finding.where) == ("duplicate", "warning", "day")
    assert finding.message == "byte for byte an earlier image: 1 of 10 images: day/07.png is day/03.png"


def test_empty_files_are_no_copies(made):
    for traverse in ("day", "night"):
        for index in (1, 2):
            made.image(traverse, index).write_bytes(b"")
    assert {one.check for one in made.lint()} == {"does-not-decode"}


def test_images_in_memory(picture):
    (finding,) = find_repeated(Traverse("walk", [picture(1), picture(2), picture(1)]), set())
    assert finding.message.endswith("walk[2] is walk[0]")
