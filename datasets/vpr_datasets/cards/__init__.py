"""The cards: ``vpr_datasets.cards.gardens`` is what ``gardens.toml`` in this folder says."""

from importlib.resources import files

from vpr_bench.dataset.card import Card


def __getattr__(name: str) -> Card:
    """Read a card when it is asked for."""
    file = files(__name__) / f"{name}.toml"
    if not file.is_file():
        raise AttributeError(f"there is no card {name!r}")
    return Card.from_toml(file)
