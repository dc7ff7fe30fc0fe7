"""Telling where images come from."""

from pathlib import Path

from vpr_bench.cli.console import say


def say_where(dataset: str, edition: str, folder: Path, *, chosen: bool) -> None:
    """Say it in one line; loudly where images are simulated and nobody asked for that.

    Parameters
    ----------
    dataset, edition : str
        What was loaded.
    folder : Path
        From where.
    chosen : bool
        Whether the user named the edition.
    """
    from vpr_bench.dataset.folders import data_root

    if edition == "simulated" and not chosen:
        say(
            f"{dataset}: SIMULATED images, rendered by vpr-bench, because the real ones are not under "
            f"{data_root()}. Get them with `vpr-bench data fetch {dataset}`."
        )
    else:
        say(f"{dataset}: {edition} images in {folder}")
