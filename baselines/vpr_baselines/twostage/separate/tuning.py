"""Training all layers of all networks, one after the other."""

from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray

from vpr_baselines.twostage.components import Components
from vpr_baselines.twostage.heads import LinearHead
from vpr_baselines.twostage.report import PartReport, TrainingReport, accuracy_and_precision
from vpr_baselines.twostage.separate.body import Body
from vpr_baselines.twostage.separate.finetune import finetune
from vpr_baselines.twostage.separate.networks import SeparateNetworks
from vpr_baselines.twostage.separate.pictures import Pictures
from vpr_baselines.twostage.separate.tuned import TunedBodies
from vpr_baselines.twostage.split import TEST, TRAINING, VALIDATION, split
from vpr_bench.checkpoint import kept
from vpr_bench.progress import task
from vpr_bench.types.traverse import Traverse


def tune_parts(
    references: Traverse, frozen: SeparateNetworks, report: TrainingReport, variants: int, epochs: int, seed: int
) -> tuple[SeparateNetworks, TrainingReport]:
    """Train whole networks, beginning with those of which only the last layer was trained.

    Parameters
    ----------
    references : Traverse
        n images.
    frozen : SeparateNetworks
        To begin with; a part with a single class stays as it is.
    report : TrainingReport
        Theirs.
    variants : int
        How many of each reference are trained with.
    epochs : int
        At most, for each part.
    seed : int
        Of augmentations, split and order: those that the last layers were trained with.
    """
    clusters = frozen.clusters
    parts = split(clusters, variants, seed)
    tuned = TunedBodies(None, frozen.body)

    def tune(component: int | None, head: LinearHead, before: PartReport) -> tuple[LinearHead, PartReport]:
        members = np.arange(len(clusters.labels)) if component is None else clusters.members(component)
        labels = clusters.labels if component is None else np.arange(len(members))
        if len(head.bias) == 1:
            return head, before

        def pictures(part: int) -> Pictures:
            rows, columns = np.nonzero(parts[members] == part)
            return Pictures(references, np.stack([members[rows], columns], axis=1), labels[rows], seed)

        def compute() -> dict[str, NDArray[Any]]:
            called = "stage one" if component is None else f"component {component}"
            with task(f"Training {called}", epochs) as advance:
                order = (seed, 0 if component is None else component + 1)
                body, learnt, rounds, stopped = finetune(
                    frozen.body,
                    head,
                    pictures(TRAINING),
                    pictures(VALIDATION),
                    epochs=epochs,
                    seed=order,
                    advance=advance,
                )
            accuracy, precision = _test(body, learnt, pictures(TEST))
            after = before.model_copy(
                update={"rounds": rounds, "stopped": stopped, "accuracy": accuracy, "average_precision": precision}
            )
            state = {f"network.{name}": value.numpy() for name, value in body.trunk.network.state_dict().items()}
            return {"weight": learnt.weight, "bias": learnt.bias, "report": np.array(after.model_dump_json()), **state}

        arrays = kept(f"network {'of stage one' if component is None else component}", compute)
        prefix = "network."
        tuned.store(
            component,
            {
                name.removeprefix(prefix): torch.from_numpy(array)
                for name, array in arrays.items()
                if name.startswith(prefix)
            },
        )
        return LinearHead(arrays["weight"], arrays["bias"]), PartReport.model_validate_json(arrays["report"].item())

    stage_one, first = tune(None, frozen.head, report.stage_one)
    heads, others = zip(
        *(tune(one, frozen.components.part(one), report.components[one]) for one in range(len(clusters))), strict=True
    )
    head = LinearHead(np.concatenate([one.weight for one in heads]), np.concatenate([one.bias for one in heads]))
    networks = SeparateNetworks(frozen.body, stage_one, Components(clusters, head), tuned)
    return networks, TrainingReport(stage_one=first, components=others)


def _test(body: Body, head: LinearHead, pictures: Pictures) -> tuple[float, float] | tuple[None, None]:
    """Measure a network on the pictures kept for it."""
    with torch.inference_mode():
        batches = pictures.batches(body, np.arange(len(pictures)))
        responses = [body.response(inputs).numpy() for inputs, _ in batches]
    if not responses:
        return None, None
    return accuracy_and_precision(head.logits(np.concatenate(responses)), pictures.labels)
