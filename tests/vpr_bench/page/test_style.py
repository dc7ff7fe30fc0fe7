"""Text can be read in both themes: a contrast of at least 4.5 to 1, by WCAG 2."""

import re

import pytest

from vpr_bench.page.page import asset

TEXT_ON_GROUND = [
    *((ink, ground) for ink in ("ink", "quiet", "accent", "wrong", "right") for ground in ("paper", "raised")),
    ("warn-ink", "warn-paper"),
    ("paper", "accent"),
    *(("bar-ink", f"bar-{number}") for number in range(1, 6)),
]


def colours(*sheets):
    """Return the custom properties of style sheets; later ones replace earlier ones."""
    return {name: colour for sheet in sheets for name, colour in re.findall(r"--([\w-]+): (#\w{6});", asset(sheet))}


def luminance(colour):
    parts = [int(colour[at : at + 2], 16) / 255 for at in (1, 3, 5)]
    linear = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
    return sum(weight * part for weight, part in zip((0.2126, 0.7152, 0.0722), linear, strict=True))


def contrast(one, other):
    lighter, darker = sorted((luminance(one), luminance(other)), reverse=True)
    return (lighter + 0.05) / (darker + 0.05)


@pytest.mark.parametrize("sheets", [("page.css",), ("page.css", "dark.css")], ids=["light", "dark"])
@pytest.mark.parametrize(("ink", "ground"), TEXT_ON_GROUND)
def test_text_has_contrast(sheets, ink, ground):
    found = colours(*sheets)
    assert contrast(found[ink], found[ground]) >= 4.5


@pytest.mark.parametrize("sheets", [("page.css",), ("page.css", "dark.css")], ids=["light", "dark"])
def test_the_white_number_in_the_first_bar_has_contrast(sheets):
    assert contrast("#ffffff", colours(*sheets)["bar-0"]) >= 4.5


@pytest.mark.parametrize("sheets", [("page.css",), ("page.css", "dark.css")], ids=["light", "dark"])
def test_lines_can_be_seen(sheets):
    found = colours(*sheets)
    assert min(contrast(colour, found["paper"]) for name, colour in found.items() if name.startswith("method")) >= 2.7
