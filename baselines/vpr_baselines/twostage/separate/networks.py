"""Whole networks, one for stage one and one per component, run one after the other."""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from safetensors.numpy import load_file, save

from vpr_baselines.twostage.components import Answers, Components
from vpr_baselines.twostage.heads import LinearHead
from vpr_baselines.twostage.separate.body import Body
from vpr_baselines.twostage.separate.tuned import TunedBodies
from vpr_bench.errors import DataError, blaming
from vpr_bench.files.atomic import replacing
from vpr_bench.types.clusters import Clusters

_HEADS = "heads.safetensors"
_TUNED = "networks"


class SeparateNetworks:
    """Stage one and the components as networks of their own.

    Nothing is shared between parts when a query is answered, because that is what the thesis's operation time is
    about (eq. 9 to 12): every call of :meth:`stage_one`, :meth:`describe` and :meth:`component` is one pass through a
    whole network. Frozen trunks are equal, so that they are stored and held in memory once.

    Parameters
    ----------
    body : Body
        The network as it was before training.
    stage_one : LinearHead
        Last layer of stage one.
    components : Components
        Last layers of the components.
    tuned : TunedBodies, optional
        What the networks became below their last layers; without it, they stayed as they were.
    """

    def __init__(
        self, body: Body, stage_one: LinearHead, components: Components, tuned: TunedBodies | None = None
    ) -> None:
        self.body, self.head, self.components, self.tuned = body, stage_one, components, tuned

    @property
    def clusters(self) -> Clusters:
        """Which references belong to which component."""
        return self.components.clusters

    def describe(self, image: NDArray[np.uint8]) -> NDArray[np.float32]:
        """Pass an image through stage one's network up to its last layer: (D,) float32."""
        return self._respond(None, image)

    def rank(self, descriptor: NDArray[np.float32]) -> NDArray[np.float32]:
        """Apply stage one's last layer to what :meth:`describe` returned: (C,) float32 logits of the clusters."""
        return self.head.logits(descriptor)

    def stage_one(self, image: NDArray[np.uint8]) -> NDArray[np.float32]:
        """Pass an (H, W, 3) uint8 RGB image through stage one: (C,) float32 logits of the clusters."""
        return self.rank(self.describe(image))

    def component(self, component: int, image: NDArray[np.uint8]) -> NDArray[np.float32]:
        """Pass an image through one component: (m,) float32 logits of the cluster's members, in their order."""
        return self.components.part(component).logits(self._respond(component, image))

    def answers(self, image: NDArray[np.uint8], triggered: NDArray[np.int64], best: int | None) -> Answers:
        """Let each triggered component, passed through one after the other, name its ``best`` references."""
        return Answers.join(
            [
                Answers.best(one, self.components.members(one), self.component(one, image), best)
                for one in triggered.tolist()
            ]
        )

    def save(self, folder: Path) -> None:
        """Write last layers and tuned networks into an existing folder; frozen networks are not written."""
        arrays = {
            "stage_one.weight": self.head.weight,
            "stage_one.bias": self.head.bias,
            "components.weight": self.components.head.weight,
            "components.bias": self.components.head.bias,
        }
        with replacing(folder / _HEADS) as temporary:
            temporary.write_bytes(save({name: np.ascontiguousarray(array) for name, array in arrays.items()}))
        if self.tuned is not None:
            self.tuned.copy(folder / _TUNED)

    @classmethod
    def load(cls, folder: Path, clusters: Clusters, body: Body, *, finetune: bool) -> "SeparateNetworks":
        """Read what :meth:`save` wrote.

        Tuned networks are read when they are first run.

        Parameters
        ----------
        folder : Path
            Where they are.
        clusters : Clusters
            That they were trained on.
        body : Body
            That training began with.
        finetune : bool
            Whether all layers were trained.

        Raises
        ------
        DataError
            If files are missing or damaged, or do not belong to these clusters.
        """
        path = folder / _HEADS
        with blaming(f"{path} is missing or damaged; fit the map again", DataError):
            arrays = load_file(path)
        shapes = {"stage_one": len(clusters), "components": len(clusters.labels)}
        heads = {name: _head(path, arrays, name, classes) for name, classes in shapes.items()}
        if heads["stage_one"].weight.shape[1] != heads["components"].weight.shape[1]:
            raise DataError(f"{path} is damaged: its parts have different inputs. Fit the map again.")
        tuned = TunedBodies(folder / _TUNED, body) if finetune else None
        return cls(body, heads["stage_one"], Components(clusters, heads["components"]), tuned)

    def _respond(self, component: int | None, image: NDArray[np.uint8]) -> NDArray[np.float32]:
        classes = len(self.clusters) if component is None else len(self.components.members(component))
        # With a single class there was nothing to learn.
        body = self.tuned.of(component) if self.tuned is not None and classes > 1 else self.body
        descriptor = np.asarray(body.respond([image])[0])
        if len(descriptor) != self.head.weight.shape[1]:
            expected = self.head.weight.shape[1]
            raise DataError(f"The map belongs to another network: {len(descriptor)} inputs in place of {expected}.")
        return descriptor


def _head(path: Path, arrays: dict[str, NDArray[np.float32]], name: str, classes: int) -> LinearHead:
    """Take a layer out of a file, and check that it is one."""
    weight, bias = arrays.get(f"{name}.weight"), arrays.get(f"{name}.bias")
    if (
        weight is None
        or bias is None
        or (weight.ndim, bias.shape, len(weight)) != (2, (classes,), classes)
        or not all(array.dtype == np.float32 and np.isfinite(array).all() for array in (weight, bias))
    ):
        raise DataError(f"{path} is damaged or of another map: {name} is no layer of {classes} classes. Fit it again.")
    return LinearHead(weight, bias)
