import pytest

from vpr_bench.check.listening import listening


def test_events_are_heard_inside_only(tmp_path):
    heard = []
    with listening(lambda event, arguments: heard.append((event, arguments[:1]))):
        (tmp_path / "inside").touch()
    (tmp_path / "outside").touch()
    opened = [arguments[0] for event, arguments in heard if event == "open"]
    assert str(tmp_path / "inside") in opened
    assert str(tmp_path / "outside") not in opened


def test_what_a_listener_raises_stops_what_was_about_to_be_done(tmp_path):
    def refuse(event, arguments):
        if event == "os.mkdir":
            raise PermissionError("no folders")

    with listening(refuse), pytest.raises(PermissionError, match="no folders"):
        (tmp_path / "folder").mkdir()
    assert not (tmp_path / "folder").exists()
