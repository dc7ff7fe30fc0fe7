"""A dataset's page, in Markdown, written from its card."""

from collections.abc import Iterable

from vpr_bench.dataset.card import Card, EditionCard, Overlay, Published
from vpr_bench.report.grid import markdown_table

_SIMULATED = """\
Rendered by vpr-bench in the layout of the real images, the same on every machine. Its numbers say nothing about the \
real dataset."""
_NAMED_TOO = """\
The first is the default. A pairing of other traverses, parts of them (`.every10`, `.first100`, `.even100`) and \
several joined by `+` can be named as well."""


def card_page(card: Card) -> str:
    """Return the page of a dataset: what it is, licence, how to get it, editions, protocols, published numbers."""
    parts = [
        f"# {card.name}",
        card.summary,
        _facts(card),
        "## Getting the images",
        *_getting(card),
        "## Traverses",
        markdown_table(
            ("name", "images", "what"), [(f"`{one.name}`", _count(one.images), one.about) for one in card.traverses]
        ),
        "## Protocols",
        _NAMED_TOO,
        _protocols(card, "real"),
    ]
    for name, edition in _editions(card):
        parts += [f"## The edition `{name}`", *_edition(card, name, edition)]
    if card.published:
        parts += ["## Published numbers", "As their sources print them; not measured here.", _published(card)]
    return "\n\n".join(parts) + "\n"


def _facts(card: Card) -> str:
    rows = [
        ("id", f"`{card.id}`" + (f", in the groups {_codes(card.groups)}" if card.groups else "")),
        ("licence", card.licence),
        ("citation", card.citation),
        ("homepage", f"<{card.homepage}>" if card.homepage.startswith("http") else card.homepage),
        ("places are measured in", {"f": "frames", "m": "metres", "pair": "pairs"}.get(card.unit, card.unit)),
    ]
    return markdown_table(("", ""), rows)


def _getting(card: Card) -> list[str]:
    folders = " or ".join(f"`<data root>/{name}/`" for name in [card.id, *card.folders])
    paths = list(dict.fromkeys(one.path for one in card.traverses))
    where = f"The traverse folders {_codes(paths)} lie in {folders}."
    if card.download is None:
        return [card.obtain, where]
    fetch = f"`vpr-bench data fetch {card.id}` downloads <{card.download.url}> and verifies what arrives."
    return [*([card.obtain] if card.obtain else []), f"{fetch} {where}"]


def _editions(card: Card) -> list[tuple[str, Overlay]]:
    named: list[tuple[str, Overlay]] = [(one.name, one) for one in card.editions]
    return named + ([("simulated", card.simulation)] if card.simulation else [])


def _edition(card: Card, name: str, edition: Overlay) -> list[str]:
    if isinstance(edition, EditionCard):
        folders = " or ".join(f"`<data root>/{folder}/`" for folder in edition.folders)
        parts = [f"{edition.about[:1].upper()}{edition.about[1:]}. It lies in {folders}."]
    else:
        parts = [_SIMULATED]
    if edition.traverses is not None:
        rows = [(f"`{one.name}`", _count(one.images), one.about) for one in edition.traverses]
        parts.append(markdown_table(("name", "images", "what"), rows))
    return [*parts, _protocols(card.in_edition(name), name)]


def _protocols(card: Card, edition: str) -> str:
    listed = zip(card.listed_protocols(edition), card.protocols, strict=True)
    return markdown_table(("protocol", "what"), [(f"`{protocol}`", one.about) for protocol, one in listed])


def _published(card: Card) -> str:
    rows = [
        (f"`{_pairing(card, one)}`", one.method, f"`{one.metric}`", f"{one.value:g}", one.source)
        for one in card.published
    ]
    return markdown_table(("protocol", "method", "metric", "value", "source"), rows)


def _pairing(card: Card, one: Published) -> str:
    reach = "" if one.radius is None else f"@{one.radius:g}{one.unit or card.unit}"
    return f"{one.references}-{one.queries}{reach}"


def _count(images: int | None) -> str:
    return "any" if images is None else f"{images:,}"


def _codes(names: Iterable[str]) -> str:
    return ", ".join(f"`{name}`" for name in names)
