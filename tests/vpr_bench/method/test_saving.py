import pytest

from vpr_bench.errors import DataError, VprBenchError
from vpr_bench.method.saving import save_fitted


class Saving:
    def __init__(self, error=None):
        self.error = error

    def save(self, folder):
        (folder / "state").write_text("learnt")
        if self.error:
            raise self.error

    def load(self, folder):
        return self


def test_writes_into_an_empty_folder(tmp_path):
    folder = tmp_path / "deep" / "folder"
    folder.mkdir(parents=True)
    (folder / "old").touch()
    assert save_fitted(Saving(), folder, "saving")
    assert [path.name for path in folder.iterdir()] == ["state"]


def test_what_cannot_be_kept(tmp_path):
    assert not save_fitted(object(), tmp_path / "folder", "object")
    assert not save_fitted(Saving(NotImplementedError()), tmp_path / "folder", "wrapper")


@pytest.mark.parametrize(
    ("error", "kind", "said"),
    [
        (OSError(28, "No space left on device"), DataError, "Free some space"),
        (OSError("120 requested and 0 written"), DataError, "120 requested"),
        (RuntimeError("no\nidea"), VprBenchError, "failed while saving its map to .*: RuntimeError: no idea"),
    ],
)
def test_what_goes_wrong_is_said_in_one_line(tmp_path, error, kind, said):
    with pytest.raises(kind, match=said):
        save_fitted(Saving(error), tmp_path / "folder", "saving")
