"""One environment id for each registered dataset, and one for all others."""

import re
import warnings
from collections import Counter

from vpr_bench.registry import PluginWarning, Registry

NAMESPACE, VERSION = "vpr_bench", 0

ANY = "place"
"""Gives the id of the environment that is told its dataset, which may be a folder of one's own."""

_SINGLE, _VECTOR = "vpr_bench.envs.single:VprEnv", "vpr_bench.envs.vector:VprVectorEnv"
_DATASET = re.compile(r"[a-z0-9][a-z0-9-]*")


def env_id(dataset: str) -> str:
    """Return the id of a dataset's environment.

    Examples
    --------
    >>> env_id("gardens"), env_id("berlin-a100")
    ('vpr_bench/Gardens-v0', 'vpr_bench/BerlinA100-v0')
    """
    name = "".join(part[:1].upper() + part[1:] for part in dataset.split("-"))
    return f"{NAMESPACE}/{name}-v{VERSION}"


def register_all() -> None:
    """Register the environments of all datasets that are installed, third-party ones too.

    Only names are looked at and no dataset is loaded, as this runs in the middle of somebody's ``import gymnasium``.
    An id that two datasets would have belongs to neither: the environment that is told its dataset serves both.
    """
    from gymnasium.envs.registration import register, registry

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", PluginWarning)  # told when datasets are used; an import is no place for it
        # Not the registry of cards: its module costs more to import than Gymnasium does.
        found = [entry.name for entry in Registry[object]("vpr_bench.datasets", "dataset").entries()]
    datasets = [name for name in found if _DATASET.fullmatch(name)]
    times = Counter(env_id(name) for name in [ANY, *datasets])
    wanted: dict[str, dict[str, str]] = {env_id(ANY): {}}
    wanted |= {env_id(name): {"dataset": name} for name in datasets if times[env_id(name)] == 1}
    for identifier, settings in wanted.items():
        if identifier not in registry:
            register(identifier, _SINGLE, vector_entry_point=_VECTOR, kwargs=settings)
