from dataclasses import replace

from rich.console import Console

from vpr_bench.gate.tables import render


def printed(judgement, width=200):
    console = Console(width=width, highlight=False)
    with console.capture() as capture:
        console.print(render(judgement))
    return capture.get()


def test_a_table_says_what_became_of_each_cell(failing):
    told = printed(failing)
    assert "gardens/day_left-day_right@0f" in told
    for name, outcome in (("fails", "fail"), ("passes", "pass"), ("absent", "missing"), ("fresh", "new")):
        assert any(line.split()[:2] == [name, outcome] for line in told.splitlines())
    assert "1 passed, 1 failed, 1 missing, 1 new" in told
    assert "lost: 0 (day_right/Image000.jpg" in told


def test_it_fits_a_window_of_80_columns(failing):
    table = [line for line in printed(failing, 80).splitlines() if "recall@1" in line and "fell" not in line]
    assert len(table) == 3
    assert all("0.02" in line for line in table)


def test_names_are_no_markup(failing, hostile):
    verdict = replace(failing.verdicts[1], label="[red]name[/]", reasons=[hostile.replace("\ud800", "")])
    told = printed(replace(failing, verdicts=[verdict]))
    assert "[red]name[/]" in told
    assert "\x1b" not in told
