"""The cards of weights: ``vpr_baselines.weights.resnet18_imagenet`` is what ``resnet18_imagenet.toml`` here says."""

from importlib.resources import files

from vpr_bench.weights.card import WeightsCard


def __getattr__(name: str) -> WeightsCard:
    """Read a card when it is asked for."""
    file = files(__name__) / f"{name}.toml"
    if not file.is_file():
        raise AttributeError(f"there is no card {name!r}")
    return WeightsCard.from_toml(file)
