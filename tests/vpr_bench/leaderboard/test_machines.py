from vpr_bench.leaderboard.machines import machine_letters, machine_names


def test_letters_go_by_fingerprint_and_are_as_many_as_needed(make_entry):
    entries = [make_entry(machine=f"{number:08x}") for number in range(28)]
    letters = machine_letters(entries)
    assert list(letters.items()) == list(machine_letters(entries[::-1]).items())
    assert letters[f"{0:08x}"] == "A"
    assert letters[f"{26:08x}"] == "AA"
    assert len(set(letters.values())) == 28


def test_a_renewed_row_changes_no_letter(make_entry):
    rows = [make_entry(machine="00000001"), make_entry(machine="00000002", created="2026-02-02T00:00:00Z")]
    renewed = [make_entry(machine="00000001", created="2027-01-01T00:00:00Z"), rows[1]]
    assert machine_letters(renewed) == machine_letters(rows) == {"00000001": "A", "00000002": "B"}


def test_names_are_the_newest(make_entry):
    entries = [make_entry(machine_about="new", created="2027-01-01T00:00:00Z"), make_entry(machine_about="old")]
    assert machine_names(entries) == {"0123abcd": "new"}
