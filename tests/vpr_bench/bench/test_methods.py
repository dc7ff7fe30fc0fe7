import json

import numpy as np
import pytest

from vpr_bench.bench.methods import run
from vpr_bench.bench.variants import Variant
from vpr_bench.errors import UsageError, VprBenchError
from vpr_bench.maps.fit import fit_map
from vpr_bench.maps.map import load_map
from vpr_bench.maps.references import of_dataset
from vpr_bench.method.build import build_method


def asked(log, n_variants):
    """Return who was asked what, image by image and without warm-ups: the names in their order, and the image."""
    entries = [(name, shown) for name, shown in log if shown not in ("fit", "warm-up")]
    turns = [entries[first : first + n_variants] for first in range(0, len(entries), n_variants)]
    for turn in turns:
        assert len({shown for _, shown in turn}) == 1  # all are asked one image before the next
        assert len({name for name, _ in turn}) == n_variants
    return ["".join(name for name, _ in turn) for turn in turns], [turn[0][1] for turn in turns]


def test_all_are_asked_each_image_in_turn_in_an_order_drawn_anew(case, variant, log):
    run(case, [variant("a"), variant("b"), variant("c")], limit=8, rounds=4)
    orders, images = asked(log, 3)
    assert len(orders) == 8 * 4
    assert len(set(orders)) == 6 and {order[0] for order in orders} == {"a", "b", "c"}
    assert images[:8] == images[8:16] and len(set(images)) == 8


def test_the_seed_decides_images_and_order(case, variant, log):
    logs = []
    for seed in (0, 0, 1):
        log.clear()
        run(case, [variant("a"), variant("b")], limit=5, rounds=2, seed=seed)
        logs.append(asked(log, 2))
    assert logs[0] == logs[1]
    assert logs[0][0] != logs[2][0] and logs[0][1] != logs[2][1]


def test_all_are_fitted_before_any_is_asked_and_warm_before_any_is_timed(case, variant, log):
    found = run(case, [variant("a"), variant("b")], limit=3, rounds=2)
    shown = [what if what in ("fit", "warm-up") else "image" for _, what in log]
    assert shown == ["fit"] * 2 + (["warm-up"] * 6 + ["image"] * 6) * 2
    assert all(one.seconds["total"].shape == (2, 3) for one in found.variants)


def test_what_was_measured_is_reported(case, variant):
    found = run(
        case, [variant("a"), variant("b", stages=("encode", "rerank", "own"))], limit=5, rounds=3, threads=1, k=2
    )
    facts = found.as_dict()
    assert json.loads(json.dumps(facts, allow_nan=False)) == facts
    assert facts["protocol"] == "tiny/day_left-day_right"
    expected = {"references": 12, "images": 5, "size": [48, 64, 3], "rounds": 3, "order": "shuffled", "k": 2}
    assert {name: facts[name] for name in expected} == expected
    assert facts["threads"] == facts["machine"]["threads"] == 1
    first, second = facts["variants"]
    assert first["variant"] == "a" and first["map"] is None and first["fit_seconds"] > 0
    assert {name for name in first["latency_ms"] if name.endswith("_p50")} == {
        f"latency_{stage}_p50" for stage in ("encode", "match", "total")
    }
    assert first["ratio_to_first"]["total"] == {"value": 1, "low": 1, "high": 1}
    assert set(second["ratio_to_first"]) == {"encode", "before_rerank", "total"}
    ratio = second["ratio_to_first"]["total"]
    assert 0 < ratio["low"] <= ratio["value"] <= ratio["high"]


def test_all_images_are_asked_where_there_are_no_more(case, variant):
    assert run(case, [variant("a")], limit=100, rounds=1).n_images == 12
    assert run(case, [variant("a")], limit=None, rounds=1).n_images == 12


def test_sequence_methods_are_reset_and_shown_images_in_their_order(case, variant, sequel, log):
    one = variant("a", sequel)
    found = run(case, [one, variant("b")], limit=4, rounds=2)
    assert found.order == "sequential"
    _, images = asked(log, 2)
    assert images == [image.tobytes() for image in case.queries[:4]] * 2
    assert len(one.built.method.resets) == 2


def test_a_map_is_not_fitted_again(tiny_dataset, colours, case, tmp_path):
    kept = fit_map(build_method("colours"), of_dataset("tiny"), tmp_path / "tiny.map", threads=1)
    colours.done.clear()
    found = run(case, [Variant.of_map("tiny.map", load_map(kept.folder))], limit=2, rounds=1)
    assert not colours.done
    facts = found.as_dict()["variants"][0]
    assert facts["fit_seconds"] is None and facts["map"] == str(kept.folder) and facts["method"] == "colours"


def test_a_map_of_other_references_is_refused(tiny_dataset, colours, case, tmp_path):
    kept = fit_map(build_method("colours"), of_dataset("tiny", "day_left.first5"), tmp_path / "five.map", threads=1)
    with pytest.raises(UsageError, match=r"five\.map has 5 references, and day_left has 12"):
        run(case, [Variant.of_map("five.map", kept)])


def test_a_method_that_fails_is_named(case, variant):
    with pytest.raises(VprBenchError, match=r"The method 'b' failed while answering .*told to fail"):
        run(case, [variant("a"), variant("b", fail_after=12)], rounds=2)
    one = variant("c")
    one.built.method.fit = None
    with pytest.raises(VprBenchError, match="The method 'c' failed while fitting"):
        run(case, [one])


def test_an_answer_that_is_none_is_refused(case, variant):
    one = variant("a")
    one.built.method.match = lambda image, k: np.zeros(k)
    with pytest.raises(VprBenchError, match=r"The method 'a' answered .* instead of a Match"):
        run(case, [one])


@pytest.mark.parametrize("options", [{"rounds": 0}, {"limit": 0}, {"k": 13}])
def test_numbers_out_of_range_are_refused(case, variant, log, options):
    with pytest.raises(UsageError):
        run(case, [variant("a")], **options)
    assert not log  # before anything is fitted
