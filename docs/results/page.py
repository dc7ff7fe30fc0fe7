"""Write the numbers of docs/results.md: ``python docs/results/page.py``. What is measured is read, nothing is run."""

import re
from pathlib import Path

from cells import HERE
from tables import TABLES

from vpr_bench.files.atomic import write_bytes

PAGE = HERE.parent / "results.md"
_PLACE = re.compile(r"(<!-- table: (\w+) -->\n)(.*?)(<!-- end -->)", re.DOTALL)


def filled(text: str) -> str:
    """Return a page with all its tables as they are by now."""

    def table(place: re.Match[str]) -> str:
        content = TABLES[place[2]]()
        return place[1] + (f"\n{content}\n\n" if content else "") + place[4]

    return _PLACE.sub(table, text)


def write_page(page: Path = PAGE) -> None:
    """Fill the page anew."""
    write_bytes(page, filled(page.read_text("utf-8")).encode())


if __name__ == "__main__":
    write_page()
