"""Putting a checkpoint's tensors into a network, key by key, and saying what did not fit."""

from collections.abc import Mapping
from dataclasses import dataclass

import torch
from torch import Tensor, nn

from vpr_bench.errors import DataError

_SHOWN = 4  # keys of each kind that a message names


@dataclass(frozen=True)
class Fit:
    """How a checkpoint fits a network.

    Attributes
    ----------
    loaded : tuple of str
        Keys that fit.
    missing : tuple of str
        Keys of the network that the checkpoint does not have.
    unexpected : tuple of str
        Keys of the checkpoint that the network does not have.
    reshaped : tuple of str
        Keys of both whose shapes differ, each with both shapes.
    dropped : tuple of str
        Keys of the head, which are left alone because they were allowed to differ.
    """

    loaded: tuple[str, ...]
    missing: tuple[str, ...]
    unexpected: tuple[str, ...]
    reshaped: tuple[str, ...]
    dropped: tuple[str, ...] = ()

    def __str__(self) -> str:
        """Write the report on one line."""
        parts = {
            "missing": self.missing,
            "unexpected": self.unexpected,
            "of another shape": self.reshaped,
            "head left out": self.dropped,
        }
        told = [f"{len(keys)} {what} ({_some(keys)})" for what, keys in parts.items() if keys]
        return "; ".join([f"{len(self.loaded)} keys fit", *told])


def compare(module: nn.Module, state: Mapping[str, Tensor], *, allow_head: str | None = None) -> Fit:
    """Say how a checkpoint fits a network without changing it.

    Parameters
    ----------
    module : nn.Module
        The network.
    state : mapping
        The checkpoint, as :func:`vpr_bench.weights.checkpoint.load_checkpoint` returns it.
    allow_head : str, optional
        Name of the classification head (``fc``, ``classifier.6``), which may be missing or of another shape on
        either side. It is then left as it is in the network.
    """
    own = module.state_dict()

    def is_head(key: str) -> bool:
        return allow_head is not None and key.startswith(f"{allow_head}.")

    # Checkpoints from before batch norms counted their batches lack the count, which only training needs.
    missing = [key for key in own if key not in state and not key.endswith("num_batches_tracked")]
    unexpected = [key for key in state if key not in own]
    differing = [key for key in own if key in state and own[key].shape != state[key].shape]
    heads = [key for key in (*missing, *unexpected, *differing) if is_head(key)]
    if heads:  # weight and bias belong together
        heads = [key for key in {**own, **state} if is_head(key)]
    return Fit(
        loaded=tuple(key for key in own if key in state and key not in differing and key not in heads),
        missing=tuple(key for key in missing if key not in heads),
        unexpected=tuple(key for key in unexpected if key not in heads),
        reshaped=tuple(f"{key}: {_shape(state[key])} for {_shape(own[key])}" for key in differing if key not in heads),
        dropped=tuple(heads),
    )


def fit_checkpoint(
    module: nn.Module, state: Mapping[str, Tensor], *, allow_head: str | None = None, name: str = "The checkpoint"
) -> Fit:
    """Load a checkpoint into a network.

    Parameters
    ----------
    module : nn.Module
        The network; changed only if everything fits.
    state : mapping
        The checkpoint.
    allow_head : str, optional
        As for :func:`compare`.
    name : str
        What messages call the checkpoint.

    Raises
    ------
    DataError
        If a key is missing, unexpected, or of another shape (names the first ones of each kind), or what would be
        loaded is not finite.
    """
    fit = compare(module, state, allow_head=allow_head)
    if fit.missing or fit.unexpected or fit.reshaped:
        raise DataError(f"{name} does not fit {type(module).__name__}: {fit}.")
    own = module.state_dict()
    for key in fit.loaded:
        if not torch.isfinite(state[key]).all():
            raise DataError(f"{name} is damaged: {key} holds NaN or infinite numbers. Get it again.")
    with torch.no_grad():
        for key in fit.loaded:
            own[key].copy_(state[key])
    return fit


def _shape(tensor: Tensor) -> str:
    return "×".join(map(str, tensor.shape)) or "scalar"


def _some(keys: tuple[str, ...]) -> str:
    more = f" and {len(keys) - _SHOWN} more" if len(keys) > _SHOWN else ""
    return ", ".join(keys[:_SHOWN]) + more
