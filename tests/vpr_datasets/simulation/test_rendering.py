import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import cv2
import numpy as np
import pytest

from vpr_bench.progress import Advance, listen
from vpr_datasets.simulation import SimulationSpec, render, render_frame
from vpr_datasets.simulation.files import Files

SPEC = SimulationSpec.model_validate(
    {
        "seed": 7,
        "frames": 3,
        "width": 96,
        "height": 54,
        "traverses": [{"name": "day"}, {"name": "night", "light": "night"}],
    }
)


def test_writes_the_layout_and_tells_each_image(tmp_path: Path) -> None:
    told: list[tuple[str, int | None]] = []
    steps: list[int] = []

    @contextmanager
    def bar(description: str, total: int | None) -> Iterator[Advance]:
        told.append((description, total))
        yield steps.append

    with listen(bar):
        render(SPEC, tmp_path / "new", workers=2)
    files = sorted(path.relative_to(tmp_path).as_posix() for path in tmp_path.rglob("*") if path.is_file())
    assert files == [f"new/{name}/Image{index:03d}.jpg" for name in ("day", "night") for index in range(3)]
    assert told == [("Rendering the simulated edition", 6)]
    assert sum(steps) == 6
    stored = np.asarray(cv2.imread(str(tmp_path / "new/day/Image002.jpg")))[..., ::-1]
    assert np.abs(stored.astype(int) - render_frame(SPEC, "day", 2)).mean() < 8


def test_a_worker_that_fails_is_quoted(tmp_path: Path) -> None:
    # Where the folder of a traverse should be made there is a file.
    (tmp_path / "night").write_text("in the way")
    with pytest.raises(RuntimeError, match=r"rendering worker \d of 2 ended with exit status 1:(.|\n)*night"):
        render(SPEC, tmp_path, workers=2)


def test_an_interruption_stops_the_workers(tmp_path: Path) -> None:
    def interrupt(steps: int) -> None:
        raise KeyboardInterrupt

    @contextmanager
    def bar(description: str, total: int | None) -> Iterator[Advance]:
        yield interrupt

    with listen(bar), pytest.raises(KeyboardInterrupt):
        render(SPEC.model_copy(update={"frames": 150}), tmp_path, workers=1)
    written = len(list(tmp_path.rglob("*.jpg")))
    assert written < 150
    time.sleep(0.2)
    assert len(list(tmp_path.rglob("*.jpg"))) == written


def test_names_numbers_and_kinds_of_files_can_be_chosen(tmp_path: Path) -> None:
    files = Files(pattern="{traverse}/images-{number:05d}.png", first=1)
    render(SPEC, tmp_path, files=files, workers=1)
    assert sorted(path.name for path in (tmp_path / "night").iterdir()) == [f"images-0000{n}.png" for n in (1, 2, 3)]
    stored = np.asarray(cv2.imread(str(tmp_path / "day/images-00003.png")))[..., ::-1]
    np.testing.assert_array_equal(stored, render_frame(SPEC, "day", 2))


def test_files_do_not_depend_on_the_number_of_workers(tmp_path: Path) -> None:
    small = SimulationSpec.model_validate(SPEC.model_dump() | {"frames": 2, "traverses": [{"name": "day"}]})
    for workers in (1, 2):
        render(small, tmp_path / str(workers), workers=workers)
    for path in (tmp_path / "1").rglob("*.jpg"):
        assert path.read_bytes() == (tmp_path / "2" / path.relative_to(tmp_path / "1")).read_bytes()


def test_raw_pictures_have_one_channel_that_can_be_demosaiced(tmp_path: Path) -> None:
    bayer = "GBRG"
    traverse = {"name": "day"}
    spec = SimulationSpec.model_validate(SPEC.model_dump() | {"bayer": bayer, "frames": 1, "traverses": [traverse]})
    render(spec, tmp_path, files=Files(pattern="{traverse}/{number}.png"), workers=1)
    raw = np.asarray(cv2.imread(str(tmp_path / "day/0.png"), cv2.IMREAD_UNCHANGED))
    image = render_frame(spec, "day", 0)
    assert raw.shape == image.shape[:2]
    np.testing.assert_array_equal(raw[::2, ::2], image[::2, ::2, "RGB".index(bayer[0])])
    np.testing.assert_array_equal(raw[1::2, ::2], image[1::2, ::2, "RGB".index(bayer[2])])


def test_no_worker_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="workers must be at least 1, got 0"):
        render(SPEC, tmp_path, workers=0)
