import numpy as np
import pytest

from vpr_bench.errors import DataError
from vpr_bench.runner.answers import AnswerTable
from vpr_bench.types.match import Match


def _table():
    table = AnswerTable(k=3)
    table.add(7, Match([4, 2], [0.9, 0.5]), {"encode": 0.2, "total": 0.3})
    table.add(1, Match([0, 1, 2], [0.3, 0.2, 0.1]), {"encode": 0.1, "rerank": 0.1, "total": 0.4})
    return table


def test_rows_are_in_the_order_of_the_queries_and_padded():
    arrays = _table().match_arrays()
    assert arrays["queries"].tolist() == [1, 7]
    assert arrays["indices"].tolist() == [[0, 1, 2], [4, 2, -1]]
    assert arrays["scores"][1].tolist() == [np.float32(0.9), np.float32(0.5), -np.inf]


def test_a_stage_that_was_skipped_took_no_time():
    timings = _table().timing_arrays()
    assert list(timings) == ["seconds.encode", "seconds.rerank", "seconds.total"]
    assert timings["seconds.rerank"].tolist() == [0.1, 0.0]


def test_round_trip(tmp_path):
    _table().save(tmp_path / "answers.npz")
    again = AnswerTable.load(tmp_path / "answers.npz", k=3)
    for name, array in _table().match_arrays().items():
        assert np.array_equal(again.match_arrays()[name], array)
    assert again.seconds[7] == {"encode": 0.2, "rerank": 0.0, "total": 0.3}


def test_damaged_file(tmp_path):
    (tmp_path / "answers.npz").write_bytes(b"PK")
    with pytest.raises(DataError, match="damaged"):
        AnswerTable.load(tmp_path / "answers.npz", k=3)
