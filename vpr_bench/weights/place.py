"""Where weights lie on this machine."""

from pathlib import Path

from vpr_bench.dataset.folders import folder_named_by
from vpr_bench.errors import DataError
from vpr_bench.importing import import_object
from vpr_bench.weights.card import WeightsCard, find_weights_card

WEIGHTS_VARIABLE = "VPR_BENCH_WEIGHTS"
"""Environment variable that names the folder of weights."""


class MissingWeightsError(DataError):
    """Weights are not on this machine; the message says how to get them."""


def weights_root() -> Path:
    """Return the folder that holds weights: ``$VPR_BENCH_WEIGHTS``, else ``weights`` in the user's data folder.

    Raises
    ------
    DataError
        If the variable names something that is not a folder.
    """
    named = folder_named_by(WEIGHTS_VARIABLE)
    if named is not None:
        return named
    import platformdirs

    return Path(platformdirs.user_data_dir("vpr-bench", appauthor=False)) / "weights"


def weights_path(card: WeightsCard) -> Path:
    """Return where the weights are, or would be.

    Raises
    ------
    MissingWeightsError
        If they come with a package that is not installed.
    DataError
        If the folder of weights is not one.
    """
    if card.packaged is None:
        return weights_root() / card.file
    try:
        return Path(import_object(card.packaged, card.id)())
    except Exception:  # the package is missing, or another one has taken its name
        raise MissingWeightsError(_missing(card)) from None


def find_weights(name: str) -> Path:
    """Return the file of weights, not looked into.

    Parameters
    ----------
    name : str
        Their id.

    Raises
    ------
    UsageError
        If there are none of that id.
    MissingWeightsError
        If they are not here; says which command fetches them, and into which folder they can be put.
    """
    return find_file(find_weights_card(name))


def find_file(card: WeightsCard) -> Path:
    """Return the file of the weights of a card, as :func:`find_weights` does."""
    path = weights_path(card)
    if not path.is_file():
        raise MissingWeightsError(_missing(card))
    return path


def _missing(card: WeightsCard) -> str:
    if card.packaged is not None:
        return f"The weights {card.id} are missing: {card.file} is not installed. {card.obtain}".rstrip()
    return (
        f"The weights {card.id} are not here. Fetch them with `vpr-bench weights fetch {card.id}`,\n"
        f"or put {card.file} (from {card.url}) into {weights_root()}"
    )
