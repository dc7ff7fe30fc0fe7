"""``vpr-bench doctor``: what this installation has, for bug reports and for the puzzled."""

import typer

from vpr_bench.cli.console import show
from vpr_bench.errors import VprBenchError


def doctor() -> None:
    """Say which versions, cores, folders, images and weights there are; exit 1 if something is wrong."""
    from rich.table import Table
    from rich.text import Text

    from vpr_bench.cores import available_cores
    from vpr_bench.runner.machine import describe_machine
    from vpr_bench.runner.provenance import source_state

    states = [*_folders(), *_images(), *_weights()]
    machine = describe_machine(available_cores())  # after what loads the libraries that multiply matrices
    faults = 0
    table = Table(show_header=False, box=None, pad_edge=False)
    table.add_column(style="bold")
    table.add_column(overflow="fold")
    table.add_row("system", f"{machine.system}, Python {machine.python}")
    table.add_row("machine", f"{machine}, fingerprint {machine.fingerprint}")
    table.add_row("BLAS", ", ".join(machine.blas or []))
    table.add_row("vpr-bench at", str(source_state() or "no known commit"))
    for name, version in machine.libraries.items():
        table.add_row(name, version)
    for name, state in states:
        faults += isinstance(state, VprBenchError)
        table.add_row(name, Text(str(state), style="red" if isinstance(state, VprBenchError) else ""))
    show(table)
    if faults:
        raise typer.Exit(1)


def _folders() -> list[tuple[str, object]]:
    from vpr_bench.dataset.folders import cache_root, data_root

    try:
        root: object = data_root()
    except VprBenchError as error:
        root = error
    return [("data root", root), ("cache", cache_root())]


def _images() -> list[tuple[str, object]]:
    from vpr_bench.dataset.acquire import verify_images
    from vpr_bench.dataset.card import DATASETS
    from vpr_bench.dataset.editions import find_images

    states: list[tuple[str, object]] = []
    for name, card in DATASETS.load_all().items():
        try:
            folder = find_images(card)
            faults = verify_images(card, folder, card.id) if folder else []
            states.append(
                (f"images of {name}", faults[0] if faults else folder or "not on disk: simulated ones are used")
            )
        except VprBenchError as error:
            states.append((f"images of {name}", error))
    return states


def _weights() -> list[tuple[str, object]]:
    from vpr_bench.method.build import METHODS, build_method
    from vpr_bench.weights.place import MissingWeightsError

    states: list[tuple[str, object]] = []
    for entry in METHODS.entries():
        try:
            weights: object = build_method(entry.name).weights or "needs none"
        except MissingWeightsError as error:
            weights = str(error)  # a method that nobody uses here is no fault
        except VprBenchError as error:
            weights = error
        states.append((f"weights of {entry.name}", weights))
    return states
