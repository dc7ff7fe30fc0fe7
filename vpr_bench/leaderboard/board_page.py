"""The page of one protocol: its table, and what has to be known to read it."""

from collections.abc import Mapping

from vpr_bench.leaderboard.collect import RESAMPLES
from vpr_bench.leaderboard.markdown import link
from vpr_bench.leaderboard.marks import NO_TIME, TIED, name_marks, name_notes
from vpr_bench.leaderboard.standing import SIGNIFICANCE, Board, Standing
from vpr_bench.metrics.bootstrap import Interval
from vpr_bench.report.foreign import plain, shortened
from vpr_bench.report.grid import markdown_table
from vpr_bench.report.numbers import fine_bounds, milliseconds, share
from vpr_bench.report.published import with_sources
from vpr_bench.runner.fair_times import BUSY

_METRICS = ("recall@1", "recall@5", "pr_auc", "pr_auc_matched")
_HEAD = ("rank", "method", *_METRICS, "p50 ms", "p95 ms", "machine")


def board_page(board: Board, letters: Mapping[str, str], home: str) -> str:
    """Write the page of a protocol as Markdown.

    Parameters
    ----------
    board : Board
        Its rows, ranked.
    letters : dict
        Machine fingerprint to letter.
    home : str
        Where the overview is, from this page.
    """
    rows = [_row(one, letters) for one in board.standings] + _published_rows(board)
    parts = [
        f"# {'Simulated images: ' if board.simulated else ''}`{board.protocol}`",
        _about(board),
        markdown_table(_HEAD, rows),
        "\n".join(f"- {note}" for note in _notes(board, letters)),
        link("All protocols", home),
    ]
    return "\n\n".join(parts) + "\n"


def _about(board: Board) -> str:
    first = board.standings[0].entry
    asked = "" if first.partial else f", {first.n_queries:,} queries, {first.n_counted:,} of which count in recall"
    simulated = " The images are simulated: numbers say nothing about the real dataset." if board.simulated else ""
    return f"{first.n_references:,} references{asked}.{simulated}"


def _row(one: Standing, letters: Mapping[str, str]) -> list[str]:
    entry = one.entry
    name = plain(shortened(entry.method)) + name_marks(entry)
    if entry.partial:
        asked = f"partial: {entry.n_queries:,} of {entry.n_available:,} queries"
        return ["", f"{name} ({asked})", *[""] * len(_METRICS), "", "", letters[entry.machine]]
    return [
        _rank(one),
        name,
        *(_value(entry.metrics[metric]) for metric in _METRICS),
        *(_time(one, f"latency_total_p{percentile}") for percentile in (50, 95)),
        letters[entry.machine] + ("" if one.fair_latency else f" {NO_TIME}"),
    ]


def _rank(one: Standing) -> str:
    if one.rank is None:
        return ""
    return f"{one.rank} {TIED}" if one.tied and one.p_value is not None else str(one.rank)


def _value(interval: Interval) -> str:
    between = fine_bounds(interval.low, interval.high)
    return share(interval.value) + (f" ({between})" if between else "")


def _time(one: Standing, name: str) -> str:
    return milliseconds(one.entry.latency[name]) if one.fair_latency else ""


def _published_rows(board: Board) -> list[list[str]]:
    rows = []
    for one, source in with_sources(board.published, _METRICS, board.protocol)[0]:
        values = [f"*{one.value:.3f}*" if metric == one.metric else "" for metric in _METRICS]
        rows.append(["", f"*{plain(shortened(one.method))}* (published, {source})", *values, "", "", ""])
    return rows


def _notes(board: Board, letters: Mapping[str, str]) -> list[str]:
    """Explain the marks that occur, and no others."""
    entries = [one.entry for one in board.standings]
    resampled = f"95 % bootstrap intervals over queries, {RESAMPLES:,} resamples"
    notes = [f"Ranked by `recall@1`; where that is equal, by `pr_auc`. In brackets: {resampled}."]
    if any(one.tied and one.p_value is not None for one in board.standings):
        notes.append(
            f"`{TIED}` not significantly different from rank 1: by McNemar's exact test on the same queries, "
            f"p ≥ {SIGNIFICANCE:g}. The order may be chance."
        )
    notes += name_notes(entries)
    if any(not one.entry.partial for one in board.standings):
        notes.append(
            "Milliseconds per query, one at a time, the image already decoded: only those of one machine compare."
        )
    if any(not one.fair_latency and not one.entry.partial for one in board.standings):
        notes.append(
            f"`{NO_TIME}` no times are shown: other processes took more than {100 * BUSY:g} % of the machine, "
            "or nobody noted how much."
        )
    abouts = {letters[one.machine]: one for one in entries}
    notes += [f"Machine {letter}: {plain(abouts[letter].machine_about)}." for letter in sorted(abouts)]
    if sources := with_sources(board.published, _METRICS, board.protocol)[1]:
        listed = "; ".join(f"({number}) {plain(source)}" for number, source in enumerate(sources, 1))
        notes.append(f"*Published* by others, with what they had; never ranked: {listed}.")
    return notes
