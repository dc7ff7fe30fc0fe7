"""Reading weights that nobody vouches for: tensors by name, and nothing is run."""

import pickle
import re
import warnings
import zipfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from torch import Tensor

from vpr_bench.errors import DataError, error_in_words, one_line
from vpr_bench.files.disk import disk_errors

_WRAPPERS = ("state_dict", "model_state_dict", "model", "network")
_PARALLEL = "module"  # what torch.nn.DataParallel puts before the names of what it wraps


def load_checkpoint(path: Path) -> dict[str, Tensor]:
    """Read a checkpoint: safetensors, or what ``torch.save`` of any version wrote, under Python 2 or 3.

    A state dict that is wrapped (``{"state_dict": …, "epoch": …}``) is unwrapped. The names' parts ``module``,
    which come from training on several processors, are left out wherever they stand: the AlexNet of Places365
    calls its weights ``features.module.0.weight``.

    Parameters
    ----------
    path : Path
        The file; its name does not matter.

    Returns
    -------
    dict of str to Tensor
        On the CPU, dense, in the order and of the types of the file.

    Raises
    ------
    DataError
        If the file is missing, damaged, no checkpoint, or a pickle that asks for more than tensors. Nothing of it
        is run, and no more memory is filled than the file has bytes.
    """
    with disk_errors(path, "read"), path.open("rb") as file:
        start = file.read(9)
    try:
        loaded = _read_safetensors(path) if start[8:] == b"{" else _read_torch(path, start)
    except DataError:
        raise
    except Exception as error:  # the readers raise whatever a damaged file makes them stumble over
        raise DataError(_explain(path, start, error)) from None
    return _tensors(path, _unwrapped(loaded))


def _read_safetensors(path: Path) -> Mapping[str, Tensor]:
    from safetensors.torch import load_file

    return load_file(path)


def _read_torch(path: Path, start: bytes) -> object:
    import torch

    if start.startswith(b"PK"):
        _check_sizes(path)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of versions of pickle; a file that cannot be read is an error anyway
        return torch.load(path, map_location="cpu", weights_only=True)


def _check_sizes(path: Path) -> None:
    """Refuse what unpacks to more than it is: ``torch.save`` never compresses."""
    with zipfile.ZipFile(path) as archive:
        packed = archive.infolist()
    if any(one.compress_type != zipfile.ZIP_STORED for one in packed) or (
        sum(one.file_size for one in packed) > path.stat().st_size
    ):
        raise DataError(f"{path} is refused: it is compressed, which no checkpoint is. Get it from its publisher.")


def _explain(path: Path, start: bytes, error: Exception) -> str:
    if start.lstrip()[:1] == b"<":
        return f"{path} is a web page and no checkpoint. Check the address that it came from."
    # Torch's messages go on to say how the file can be loaded all the same: that advice is not passed on.
    if isinstance(error, pickle.UnpicklingError):
        asked = re.search(r"GLOBAL ([\w.]+)", str(error))
        why = (
            f"its pickle asks for {asked[1]:.100}" if asked else "its pickle asks for more than tensors, or is damaged"
        )
        return (
            f"{path} is refused: {why}. Nothing of it was run; get it from its publisher, "
            "or have it saved as safetensors."
        )
    reason = error_in_words(error).partition(" In PyTorch 2.6")[0]
    return f"{path} is damaged or no checkpoint ({reason:.200}). Get it again."


def _unwrapped(loaded: object) -> object:
    if isinstance(loaded, Mapping):
        for name in _WRAPPERS:
            if isinstance(loaded.get(name), Mapping):
                return loaded[name]
    return loaded


def _tensors(path: Path, loaded: object) -> dict[str, Tensor]:
    """Take the tensors under their own names, and nothing else.

    Raises
    ------
    DataError
        If it is not a mapping of names to dense tensors, or two of them end up with the same name.
    """
    if not isinstance(loaded, Mapping) or not loaded:
        raise DataError(f"{path} is no checkpoint: it holds no tensors by name ({type(loaded).__name__}).")
    tensors: dict[str, Tensor] = {}
    for key, value in loaded.items():
        if not isinstance(key, str) or not _is_plain(value):
            name = one_line(key)
            raise DataError(f"{path} is no checkpoint: {name:.100} is {type(value).__name__} and no dense tensor.")
        name = ".".join(part for part in key.split(".") if part != _PARALLEL)
        if name in tensors:
            raise DataError(f"{path} is ambiguous: it holds {name:.100} with and without {_PARALLEL!r} in it.")
        tensors[name] = value.detach()
    return tensors


def _is_plain(value: Any) -> bool:
    return (
        isinstance(value, Tensor)
        and value.device.type == "cpu"
        and str(value.layout) == "torch.strided"
        and not (value.is_quantized or value.is_nested)
    )
