from vpr_bench.leaderboard.machines import machine_letters, machine_names


def test_letters_go_by_first_use_and_are_as_many_as_needed(make_entry):
    entries = [
        make_entry(machine=f"{number:08x}", created=f"2026-01-01T00:{59 - number:02}:00+00:00") for number in range(28)
    ]
    letters = machine_letters(entries)
    assert letters == machine_letters(entries[::-1])
    assert letters[f"{27:08x}"] == "A"
    assert letters[f"{1:08x}"] == "AA"
    assert len(set(letters.values())) == 28


def test_names_are_the_newest(make_entry):
    entries = [make_entry(machine_about="new", created="2027-01-01T00:00:00Z"), make_entry(machine_about="old")]
    assert machine_names(entries) == {"0123abcd": "new"}
