"""``vpr-bench list`` and ``vpr-bench info``: what there is."""

from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import typer

from vpr_bench.cli.console import show, write
from vpr_bench.errors import UsageError, closest

if TYPE_CHECKING:
    from vpr_bench.dataset.card import Card

LIST_EXAMPLES = """[bold]Examples[/bold]

vpr-bench list

vpr-bench list methods --format json
"""
INFO_EXAMPLES = """[bold]Examples[/bold]

vpr-bench info gardens

vpr-bench info twostage

vpr-bench info gardens.map
"""


Kind = Literal["methods", "datasets", "metrics"]
TextFormat = Literal["table", "json"]
PageFormat = Literal["table", "json", "markdown"]

KindArgument = Annotated[Kind | None, typer.Argument(help="What to list. Default: everything.")]
TextFormatOption = Annotated[TextFormat, typer.Option("--format", "-f", help="How to write to stdout.")]


def list_(kind: KindArgument = None, form: TextFormatOption = "table") -> None:
    """List methods, datasets and metrics, and where each comes from."""
    from rich.table import Table
    from rich.text import Text

    listed = {one: _LISTS[one]() for one in ([kind] if kind else _LISTS)}
    if form == "json":
        _write_json(listed)
        return
    for title, lines in listed.items():
        table = Table(title=title, title_justify="left", title_style="bold", box=None, pad_edge=False)
        for column in lines[0] if lines else ():
            table.add_column(column, overflow="fold")
        for line in lines:
            table.add_row(*(Text(value) for value in line.values()))
        show(table)


def info(
    name: Annotated[str, typer.Argument(help="A method, dataset or metric, a map, or a folder of your own images.")],
    form: Annotated[
        PageFormat, typer.Option("--format", "-f", help="How to write to stdout; markdown for datasets only.")
    ] = "table",
) -> None:
    """Say everything about one method, dataset, metric or map."""
    if form == "markdown":
        from vpr_bench.dataset.request import Request
        from vpr_bench.dataset.source import find_whole_card
        from vpr_bench.report.card_page import card_page

        write(card_page(find_whole_card(Request.parse(name))).rstrip("\n"))
        return
    show_facts(_describe(name), form)


def show_facts(facts: dict[str, Any], form: TextFormat) -> None:
    """Print what is known about one thing on stdout; a list holds parts of it, with facts of their own."""
    if form == "json":
        _write_json(facts)
        return
    from rich.table import Table
    from rich.text import Text

    table = Table(show_header=False, box=None, pad_edge=False)
    table.add_column(style="bold")
    table.add_column(overflow="fold")
    for key, value in facts.items():
        table.add_row(key, Text("\n".join(map(_line, value)) if isinstance(value, list) else str(value)))
    show(table)


def _line(facts: dict[str, Any]) -> str:
    """Write a part of a description on one line; what is empty is left out."""
    return " · ".join(f"{key}: {value}" for key, value in facts.items() if value not in (None, ""))


def _describe(name: str) -> dict[str, Any]:
    from vpr_bench.dataset.card import DATASETS
    from vpr_bench.dataset.own import own_card
    from vpr_bench.dataset.request import Request, own_folder
    from vpr_bench.method.build import METHODS

    if (Path(name) / "map.json").is_file():
        from vpr_bench.cli.map_facts import describe_map
        from vpr_bench.maps.map import load_map

        return describe_map(load_map(name))
    methods = {entry.name for entry in METHODS.entries()}
    datasets = {entry.name for entry in DATASETS.entries()}
    dataset = Request.parse(name).dataset  # gardens:simulated and whole protocol ids name it too
    if dataset in datasets:
        return _describe_card(DATASETS.find(dataset), DATASETS.entry(dataset).origin)
    own = None if name in methods else own_folder(name)
    if own is not None:
        return _describe_card(own_card(own), str(own))
    if name in methods or ":" in name:
        return _describe_method(name)
    from vpr_bench.metrics.definitions import METRICS, lookup

    with suppress(UsageError):
        return {"metric": name, "definition": lookup(name).definition}
    known = methods | datasets | METRICS.keys()
    raise UsageError(f"There is no method, dataset, metric or map {name!r}. {closest(name, known)}")


def _describe_method(name: str) -> dict[str, Any]:
    from vpr_bench.method.build import find_method
    from vpr_bench.method.presets import chosen, written_presets

    entry, preset = find_method(name)
    presets = written_presets(entry)
    defaults = entry.parameters()
    if preset is not None:
        defaults |= {key: repr(value) for key, value in chosen(entry, presets, preset).items()}
    return {
        "method": name,
        "summary": entry.summary(),
        "from": f"{entry.origin} ({entry.target})",
        "parameters": [{"parameter": key, "default": value} for key, value in defaults.items()],
        "presets": [{"preset": f"{entry.name}:{key}", **values} for key, values in presets.items()],
    }


def _describe_card(card: "Card", origin: str) -> dict[str, Any]:
    return {
        "dataset": f"{card.id}: {card.name}",
        "summary": card.summary,
        "citation": card.citation,
        "licence": card.licence,
        "homepage": card.homepage,
        "groups": ", ".join(card.groups),
        "from": origin,
        "traverses": [{"name": one.name, "images": one.images, "about": one.about} for one in card.traverses],
        "protocols": [
            {"id": str(protocol), "about": one.about}
            for protocol, one in zip(card.listed_protocols(), card.protocols, strict=True)
        ],
        "published": [
            {
                "protocol": f"{one.references}-{one.queries}",
                "radius": "not stated" if one.radius is None else one.radius,
                "method": one.method,
                one.metric: one.value,
                "source": one.source,
            }
            for one in card.published
        ],
        "editions": ", ".join(card.edition_names()),
    }


def _methods() -> list[dict[str, str]]:
    from vpr_bench.method.build import METHODS
    from vpr_bench.method.presets import written_presets

    return [
        {
            "name": one.name,
            "what": one.summary(),
            "presets": ", ".join(f"{one.name}:{preset}" for preset in written_presets(one)),
            "from": one.origin,
        }
        for one in METHODS.entries()
    ]


def _datasets() -> list[dict[str, str]]:
    from vpr_bench.dataset.card import DATASETS

    cards = DATASETS.load_all()
    return [
        {
            "name": name,
            "what": card.summary,
            "groups": ", ".join(card.groups),
            "editions": ", ".join(card.edition_names()),
            "from": DATASETS.entry(name).origin,
        }
        for name, card in cards.items()
    ]


def _metrics() -> list[dict[str, str]]:
    from vpr_bench.metrics.definitions import METRICS

    return [{"name": metric.id, "what": metric.definition} for metric in METRICS.values()]


def _write_json(content: Any) -> None:
    import json

    write(json.dumps(content, indent=2, ensure_ascii=False))


_LISTS = {"methods": _methods, "datasets": _datasets, "metrics": _metrics}
