"""Networks that were trained as a whole, each in a file of its own, in memory once they have been run."""

import copy
import shutil
import weakref
from collections import OrderedDict
from pathlib import Path
from tempfile import mkdtemp

from safetensors.torch import save_file
from torch import Tensor

from vpr_baselines.twostage.separate.body import Body
from vpr_bench.errors import DataError
from vpr_bench.files.atomic import replacing
from vpr_bench.files.disk import disk_errors
from vpr_bench.weights.checkpoint import load_checkpoint
from vpr_bench.weights.fit import fit_checkpoint

_HELD = 3_000_000_000
"""Bytes of networks that stay in memory; of ResNet-18, 67."""


class TunedBodies:
    """The networks of all parts below their last layers.

    Parameters
    ----------
    folder : Path, optional
        Where they are; by default a new one that vanishes with this object.
    body : Body
        What each of them was before.
    """

    def __init__(self, folder: Path | None, body: Body) -> None:
        if folder is None:
            folder = Path(mkdtemp(prefix="vpr-bench-networks-"))
            weakref.finalize(self, shutil.rmtree, folder, ignore_errors=True)
        self.folder, self.body = folder, body
        size = sum(one.numel() * one.element_size() for one in body.trunk.network.state_dict().values())
        self._most = max(_HELD // max(size, 1), 1)
        self._held: OrderedDict[int | None, Body] = OrderedDict()

    def of(self, component: int | None) -> Body:
        """Return the network of a component, or with None of stage one.

        Raises
        ------
        DataError
            If its file is missing or damaged.
        """
        if component not in self._held:
            self._held[component] = self._load(component)
            while len(self._held) > self._most:
                self._held.popitem(last=False)
        self._held.move_to_end(component)
        return self._held[component]

    def store(self, component: int | None, state: dict[str, Tensor]) -> None:
        """Write the state of a network."""
        self._held.pop(component, None)
        with replacing(self._path(component)) as temporary:
            save_file({name: tensor.contiguous() for name, tensor in state.items()}, temporary)

    def copy(self, folder: Path) -> None:
        """Write all of them into a new folder."""
        with disk_errors(folder):
            shutil.copytree(self.folder, folder)

    def _load(self, component: int | None) -> Body:
        path = self._path(component)
        if not path.is_file():
            raise DataError(f"The network {path} is missing. Restore it, or fit the map again.")
        network = copy.deepcopy(self.body.trunk.network)
        fit_checkpoint(network, load_checkpoint(path), name=str(path))
        return self.body.on(network)

    def _path(self, component: int | None) -> Path:
        return self.folder / (
            "stage-one.safetensors" if component is None else f"component-{component:05d}.safetensors"
        )
