import cv2
import numpy as np
import pytest

from vpr_bench.errors import DataError
from vpr_bench.report.curve import draw_curve
from vpr_bench.report.rows import score_run


def test_draws_a_png_and_an_svg(stored, tmp_path):
    run = stored()
    files = draw_curve(
        [score_run(run, protocol=run.protocol.with_radius(0)), score_run(run, protocol=run.protocol.with_radius(1))],
        tmp_path,
    )
    assert [file.name for file in files] == ["precision_recall.png", "precision_recall.svg"]
    image = cv2.imread(str(files[0]))
    assert len(np.unique(image.reshape(-1, 3), axis=0)) > 50  # lines, text, grid
    assert files[1].read_text().startswith("<?xml")


def test_same_run_same_file(stored, tmp_path):
    row = score_run(stored())
    first = draw_curve([row], tmp_path)[1].read_bytes()
    assert draw_curve([row], tmp_path)[1].read_bytes() == first


def test_unwritable_folder(stored, tmp_path):
    (tmp_path / "file").touch()
    with pytest.raises(DataError, match="Cannot write"):
        draw_curve([score_run(stored())], tmp_path / "file")
