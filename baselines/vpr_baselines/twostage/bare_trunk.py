"""The trunk alone: what a query must cost at least."""

from dataclasses import dataclass
from functools import cached_property
from typing import Annotated, ClassVar, cast

import numpy as np
import torch
from numpy.typing import NDArray
from pydantic import Field

from vpr_baselines.backbones.architectures import ARCHITECTURES, Backbone
from vpr_baselines.backbones.layers import Layered, respond
from vpr_baselines.backbones.trunk import Normalise, Trunk, load_trunk
from vpr_baselines.twostage.method import Side, TwoStage
from vpr_bench.timing import stage
from vpr_bench.types.match import Match
from vpr_bench.types.traverse import Traverse
from vpr_bench.weights.choice import choose_weights


@dataclass
class BareTrunk:
    """Passes a query through the trunk of ``twostage`` and throws the result away: for comparing times, not places.

    It always answers with the first references of the map. The defaults are those of
    :class:`~vpr_baselines.twostage.method.TwoStage`, and so is the network in memory where both run in one process.

    Parameters
    ----------
    prepare : bool
        Resize the query and normalise its light, as whoever uses the trunk must. If not, one input, made of the
        first reference, goes through the network again and again.
    backbone, weights, layer, width, height, normalise, seed
        As for :class:`~vpr_baselines.twostage.method.TwoStage`.
    """

    version: ClassVar[str] = "1"
    expected_failures: ClassVar[dict[str, str]] = {
        "finds-the-same-image": "it does not look for anything",
    }

    prepare: bool = True
    backbone: Backbone = TwoStage.backbone
    weights: str = TwoStage.weights
    layer: str | None = TwoStage.layer
    width: Side = TwoStage.width
    height: Side = TwoStage.height
    normalise: Normalise = TwoStage.normalise
    seed: Annotated[int, Field(ge=0)] = TwoStage.seed

    def weights_digest(self) -> str:
        """Name the trunk's weights by training set and SHA-256; it raises what :func:`choose_weights` raises."""
        return choose_weights(self.backbone, self.weights, self.seed).identity()

    def fit(self, references: Traverse) -> None:
        """Count the references, and prepare the first one."""
        self.size_ = len(references)
        self.input_ = self._trunk.input(references[0])

    def match(self, image: NDArray[np.uint8], k: int) -> Match:
        """Answer with the first ``k`` references, whatever the trunk responds."""
        with stage("encode"), torch.inference_mode():
            images = self._trunk.input(image) if self.prepare else self.input_
            respond(cast(Layered, self._trunk.network), images, self._trunk.layers)
        answered = min(k, self.size_)
        return Match(np.arange(answered), np.zeros(answered, np.float32))

    @cached_property
    def _trunk(self) -> Trunk:
        one = ARCHITECTURES[self.backbone]
        layers = (self.layer or one.last,)
        return load_trunk(one, self.width, self.height, self.weights, self.normalise, layers, self.seed)
