"""The tables of docs/results.md, from the CSV files beside this one and the datasets' cards."""

from collections.abc import Callable
from itertools import groupby

from cells import Line, called, number, read, settings, signed, with_bounds
from plan import DATASETS, DAY, NIGHT, RIGHT

from vpr_bench.dataset.card import Card, find_card
from vpr_bench.report.grid import markdown_table
from vpr_bench.report.numbers import UNDEFINED, short_share

METRICS = ("recall@1", "pr_auc", "pr_auc_matched")
_STEPS = ("clusters", "components", "ranking")


def gardens() -> str:
    """Lay out every method on the real images of Gardens Point, with intervals."""
    head = ["protocol", "method", *(f"`{name}`" for name in METRICS)]
    rows = [
        [f"`{line['protocol']}`", called(line), *(with_bounds(line, name) for name in METRICS)]
        for pairing in (NIGHT, RIGHT, DAY)
        for line in _part("gardens")
        if f"/{pairing}@" in line["protocol"]
    ]
    return markdown_table(head, rows)


def thesis() -> str:
    """Lay out the thesis's areas beside ours, dataset by dataset."""
    head = ["dataset", "thesis: AUC, 7 / 1", "here: `pr_auc_matched`, 7 / 1", "`pr_auc`, 7 / 1", "`recall@1`, 7 / 1"]
    rows = []
    for dataset in DATASETS:
        published = find_card(dataset).published
        said = {one.method: one.value for one in published if one.source.startswith("thesis")}
        areas = [
            short_share(said.get(f"two-stage, {count}", float("nan"))) for count in ("7 components", "1 component")
        ]
        for images in ("real", "simulated"):
            part = "gardens" if images == "real" else "simulated"
            found = [_of_components(part, f"{dataset}:{images}", count) for count in (7, 1)]
            if all(found):
                ours = [f"{images}: {' / '.join(number(line, one) for line in found)}" for one in METRICS[::-1]]
                rows.append([f"`{found[0]['protocol']}`", " / ".join(areas), *ours])
    return markdown_table(head, rows)


def radius() -> str:
    """Lay out each metric of the real night against the radius."""
    lines = read("radius.csv")
    parts = []
    for metric in METRICS:
        rows = [
            [called(run[0]), *(number(line, metric) for line in run)]
            for _, group in groupby(lines, key=lambda line: line["variant"])
            for run in [list(group)]
        ]
        radii = list(dict.fromkeys(f"{float(line['radius']):g}" for line in lines))
        parts.append(markdown_table([f"`{metric}`, radius", *radii], rows))
    return "\n\n".join(parts)


def lost() -> str:
    """Say which step lost the right place, of the runs of several numbers of components."""
    head = ["protocol", "components", *(f"lost by {step}" for step in _STEPS), "references compared", "`recall@1`"]
    rows = [
        [
            f"`{line['protocol']}`",
            _count(line),
            *(number(line, f"lost_by_{step}") for step in _STEPS),
            f"{float(line['left_after_components']):.1f}",
            number(line, "recall@1"),
        ]
        for line in _part("gardens")
        if line["method"].startswith("twostage")
    ]
    return markdown_table(head, rows)


def ablations() -> str:
    """Say what changes if one choice is another, with intervals of paired differences."""
    parts = []
    for protocol, group in groupby(
        sorted(_part("ablations"), key=lambda line: line["protocol"]), lambda one: one["protocol"]
    ):
        shown = METRICS[:2]
        head = [f"`{protocol}`", *(text for name in shown for text in (f"`{name}`", "change")), "`pr_auc_matched`"]
        rows = []
        for line in group:
            cells = []
            for name in shown:
                usual = line["variant"].endswith("twostage()")
                cells += [number(line, name), "" if usual else signed(line, f"{name}_change")]
            rows.append([settings(line) or "as by default", *cells, number(line, "pr_auc_matched")])
        parts.append(markdown_table(head, rows))
    return "\n\n".join(parts)


def published() -> str:
    """Lay out what others published, as the cards have it, beside ours where the images are the same."""
    head = ["dataset", "protocol", "radius", "method", "metric", "value", "here, 7 components", "source"]
    rows = [row for dataset in DATASETS for row in _published(find_card(dataset))]
    return markdown_table(head, rows)


def latency() -> str:
    """Write the section about times: all of it, or nothing as long as they have not been measured."""
    lines = read("latency.csv")
    if not lines:
        return ""
    table = markdown_table(list(lines[0]), [list(line.values()) for line in lines])
    return f"## Time\n\n{_ABOUT_TIMES}\n\n{table}"


_ABOUT_TIMES = """Measured side by side in one run on an otherwise idle machine, image already decoded.
The thesis states 200 to 220 ms per query with one component, and 1,021 ms on AmsterTime, on a machine of its own."""

TABLES: dict[str, Callable[[], str]] = {
    table.__name__: table for table in (gardens, thesis, radius, lost, ablations, published, latency)
}
"""By the name that stands in the page."""


def _published(card: Card) -> list[list[str]]:
    rows = []
    for one in card.published:
        if one.source.startswith("thesis"):  # in a table of its own
            continue
        pairing = f"{one.references}-{one.queries}"
        ours = [
            line for line in _part("gardens") if line["variant"] == f"{card.id}:real/{pairing} twostage(n_components=7)"
        ]
        reach = "not stated" if one.radius is None else f"{one.radius:g}"
        value = number(ours[0], one.metric) if ours else UNDEFINED
        rows.append(
            [card.id, f"`{pairing}`", reach, one.method, f"`{one.metric}`", short_share(one.value), value, one.source]
        )
    return rows


def _part(name: str) -> list[Line]:
    return [line for line in read("runs.csv") if line["part"] == name]


def _of_components(part: str, source: str, count: int) -> Line:
    ending = f"twostage(n_components={count})"
    found = [
        line for line in _part(part) if line["variant"].startswith(f"{source}/") and line["variant"].endswith(ending)
    ]
    return found[0] if found else {}


def _count(line: Line) -> str:
    return called(line).partition("=")[2].removesuffix(")") or "all"
