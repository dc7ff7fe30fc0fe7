"""Training all layers of one network."""

import copy
from collections.abc import Callable
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor, nn
from torch.nn import functional

from vpr_baselines.twostage.heads import LinearHead
from vpr_baselines.twostage.regression import balanced
from vpr_baselines.twostage.report import Stopped
from vpr_baselines.twostage.separate.body import Body
from vpr_baselines.twostage.separate.pictures import Pictures
from vpr_bench.checkpoint import load_checkpoint, save_checkpoint

_RATE = 1e-4
_PATIENCE = 3  # epochs that the validation loss may go without falling


def finetune(
    body: Body,
    head: LinearHead,
    training: Pictures,
    validation: Pictures,
    *,
    epochs: int,
    seed: tuple[int, ...],
    advance: Callable[[int], None] = lambda epochs: None,
) -> tuple[Body, LinearHead, int, Stopped]:
    """Train a network and its last layer with Adam, from what training the last layer alone came to.

    The batch norms stay folded into the convolutions: a cluster of a dozen pictures that look alike says nothing about
    the statistics that they would be normalised with. A last layer that fits already keeps the first steps from
    spoiling what is below it (Kumar et al., ICLR 2022).

    Parameters
    ----------
    body : Body
        Not changed.
    head : LinearHead
        At least two classes.
    training, validation : Pictures
        What is learnt from, and what says when to stop.
    epochs : int
        At most.
    seed : tuple of int
        Of the order of the pictures and of what dropout leaves out.
    advance : callable
        Told of every epoch.

    Returns
    -------
    body, head
        As they were after the epoch of the lowest validation loss, the start among them; without validation, at the
        end.
    epochs : int
        How many led there.
    stopped : str
        Why no more followed.
    """
    run = _Run(body, head, training, validation)
    run.resume()
    advance(run.epoch)
    stopped: Stopped = "limit"
    while run.epoch < epochs:
        if run.epoch - run.best_epoch >= _PATIENCE:
            stopped = "validation"
            break
        run.train(np.random.default_rng([*seed, run.epoch]))
        run.judge()
        save_checkpoint("finetune", run.state())
        advance(1)
    return *run.best_network(), run.best_epoch, stopped


class _Run:
    """A network in training, and the best that it has been."""

    def __init__(self, body: Body, head: LinearHead, training: Pictures, validation: Pictures) -> None:
        self.training, self.validation = training, validation
        self.network = copy.deepcopy(body.trunk.network).requires_grad_(True)
        self.body = body.on(self.network)
        self.layer = nn.Linear(head.weight.shape[1], len(head.weight))
        with torch.no_grad():
            self.layer.weight.copy_(torch.from_numpy(head.weight))
            self.layer.bias.copy_(torch.from_numpy(head.bias))
        self.weights = torch.from_numpy(balanced(training.labels, len(head.weight)))
        self.parameters = [*self.network.parameters(), *self.layer.parameters()]
        self.optimiser = torch.optim.Adam(self.parameters, lr=_RATE)
        self.epoch, self.best_epoch, self.lowest = 0, 0, np.inf
        self.best = [parameter.detach().clone() for parameter in self.parameters]

    def train(self, random: np.random.Generator) -> None:
        """Show it every picture once."""
        order = random.permutation(len(self.training))
        with torch.random.fork_rng(devices=[]):
            torch.manual_seed(int(random.integers(2**62)))
            self.network.train()
            for inputs, labels in self.training.batches(self.body, order):
                self.optimiser.zero_grad()
                self._loss(inputs, labels).backward()  # type: ignore[no-untyped-call]
                self.optimiser.step()
            self.network.eval()
        self.epoch += 1

    def judge(self) -> None:
        """Remember it if it is the best so far; without validation, the last one is."""
        loss = self.validation_loss()
        if loss is None or loss < self.lowest:
            self.best_epoch, self.lowest = self.epoch, loss or 0.0
            self.best = [parameter.detach().clone() for parameter in self.parameters]

    def validation_loss(self) -> float | None:
        """Return the mean loss of the pictures held back; None without any."""
        if not len(self.validation):
            return None
        with torch.inference_mode():
            batches = self.validation.batches(self.body, np.arange(len(self.validation)))
            losses = [float(self._loss(inputs, labels)) * len(labels) for inputs, labels in batches]
        return sum(losses) / len(self.validation)

    def best_network(self) -> tuple[Body, LinearHead]:
        """Return the network at its best, frozen."""
        with torch.no_grad():
            for parameter, value in zip(self.parameters, self.best, strict=True):
                parameter.copy_(value)
        self.network.requires_grad_(False)
        return self.body, LinearHead(self.layer.weight.detach().numpy(), self.layer.bias.detach().numpy())

    def state(self) -> dict[str, NDArray[Any]]:
        """Return everything that the next epoch depends on."""
        arrays = {"progress": np.array([self.epoch, self.best_epoch, self.lowest], dtype=np.float64)}
        for number, (parameter, best) in enumerate(zip(self.parameters, self.best, strict=True)):
            arrays |= {f"parameter {number}": parameter.detach().numpy(), f"best {number}": best.numpy()}
            # The former last layer, which nobody asks for an answer, has no moments.
            for name, moment in self.optimiser.state[parameter].items():
                arrays[f"{name} {number}"] = moment.numpy()
        return arrays

    def resume(self) -> None:
        """Go on from the last epoch that was stored; else measure where it starts."""
        stored = load_checkpoint("finetune")
        if stored is None:
            loss = self.validation_loss()
            self.lowest = np.inf if loss is None else loss
            return
        epoch, best_epoch, self.lowest = stored["progress"].tolist()
        self.epoch, self.best_epoch = int(epoch), int(best_epoch)
        for number, (parameter, best) in enumerate(zip(self.parameters, self.best, strict=True)):
            parameter.data.copy_(torch.from_numpy(stored[f"parameter {number}"]))
            best.copy_(torch.from_numpy(stored[f"best {number}"]))
            for name in ("step", "exp_avg", "exp_avg_sq"):
                if f"{name} {number}" in stored:
                    moment = torch.tensor(stored[f"{name} {number}"])
                    # Laid out as the parameter is, or sums would be taken in another order.
                    laid_out = torch.empty_like(parameter).copy_(moment) if moment.ndim else moment
                    self.optimiser.state[parameter][name] = laid_out.detach()

    def _loss(self, inputs: Tensor, labels: Tensor) -> Tensor:
        return functional.cross_entropy(self.layer(self.body.response(inputs)), labels, self.weights)
