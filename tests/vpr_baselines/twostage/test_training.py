import subprocess
import sys

import numpy as np
import pytest

from vpr_baselines.retrieval import normalised
from vpr_baselines.twostage import lbfgs, regression, training
from vpr_baselines.twostage.training import train_components, train_parts, train_stage_one
from vpr_bench.checkpoint import checkpoints
from vpr_bench.progress import listen
from vpr_bench.types.clusters import Clusters

RECIPE = {"penalty": 10.0, "seed": 0}
SCATTERED = Clusters([0, 0, 1, 0, 2, 1, 1, 0, 3, 2, 2, 2])


def described(count, variants=6, dimensions=24):
    """Noisy variants of random directions, the first of each without noise."""
    chance = np.random.default_rng(count)
    places = normalised(chance.standard_normal((count, 1, dimensions)).astype(np.float32))
    noise = 0.1 * chance.standard_normal((count, variants, dimensions)).astype(np.float32)
    noise[:, 0] = 0
    return normalised(places + noise)


def same(one, other):
    """Tell whether two trained sets of parts agree in every bit."""
    return all(
        np.array_equal(a, b)
        for a, b in (
            (one[0].weight, other[0].weight),
            (one[0].bias, other[0].bias),
            (one[1].head.weight, other[1].head.weight),
            (one[1].head.bias, other[1].head.bias),
        )
    ) and (one[2] == other[2])


@pytest.fixture(scope="module")
def trained():
    return train_parts(SCATTERED, described(12), **RECIPE)


def test_originals_are_recognised_through_both_stages(trained):
    stage_one, components, _ = trained
    for reference, descriptor in enumerate(described(12)[:, 0]):
        cluster = SCATTERED.labels[reference]
        assert stage_one.logits(descriptor).argmax() == cluster
        assert components.answers(descriptor, np.array([cluster]), 1).references.tolist() == [reference]


def test_the_report_tells_each_part_on_samples_it_has_not_seen(trained):
    report = trained[2]
    assert (report.stage_one.classes, [one.classes for one in report.components]) == (4, [4, 3, 4, 1])
    parts = [report.stage_one, *report.components]
    totals = [one.training + one.validation + one.test for one in parts]
    assert totals == [72, 24, 18, 24, 6]
    assert all(one.validation == one.test > 0 for one in parts)
    assert report.stage_one.accuracy == 1.0 and report.components_accuracy > 0.8
    assert report.components[3].stopped == "nothing to learn"


@pytest.mark.parametrize(
    "clusters", [Clusters([0] * 5), Clusters(range(5)), Clusters([0, 1, 1, 0, 0])], ids=["one", "singles", "two"]
)
@pytest.mark.parametrize("variants", [1, 2, 6])
def test_every_shape_of_clusters_can_be_trained(clusters, variants):
    stage_one, components, report = train_parts(clusters, described(5, variants), **RECIPE)
    assert stage_one.weight.shape == (len(clusters), 24)
    assert components.head.weight.shape == (5, 24) and components.head.bias.shape == (5,)
    assert len(report.components) == len(clusters)
    for descriptor, cluster, reference in zip(described(5, variants)[:, 0], clusters.labels, range(5), strict=True):
        assert components.answers(descriptor, np.array([cluster]), 1).references.tolist() == [reference]


@pytest.mark.parametrize("value", [0.0, 0.2])
def test_identical_images_can_be_trained(value):
    descriptors = np.full((6, 6, 24), value, np.float32)
    stage_one, components, report = train_parts(Clusters([0, 0, 1, 1, 1, 2]), descriptors, **RECIPE)
    assert np.isfinite(stage_one.weight).all() and np.isfinite(components.head.weight).all()
    assert 0 <= report.stage_one.accuracy <= 1
    assert len(components.answers(descriptors[0, 0], np.array([0, 1, 2]), 3).references) == 6


def test_without_augmentations_nothing_is_measured():
    report = train_parts(SCATTERED, described(12, 1), **RECIPE)[2]
    assert report.stage_one.validation == report.stage_one.test == 0
    assert report.stage_one.accuracy is None and report.components_accuracy is None


def test_the_seed_decides_and_nothing_else(trained):
    assert same(train_parts(SCATTERED, described(12), **RECIPE), trained)
    assert not same(train_parts(SCATTERED, described(12), penalty=10.0, seed=1), trained)


def test_descriptors_may_be_of_half_precision(trained):
    stage_one, _, _ = train_parts(SCATTERED, described(12).astype(np.float16), **RECIPE)
    assert np.allclose(stage_one.weight, trained[0].weight, atol=0.3)


def test_small_clusters_are_not_drowned_by_large_ones():
    """Ninety-five alike and five between them and elsewhere."""
    chance = np.random.default_rng(0)
    near = chance.standard_normal((100, 1, 24)).astype(np.float32)
    near[95:, 0, 0] += 3
    clusters = Clusters([0] * 95 + [1] * 5)
    stage_one, _ = train_stage_one(clusters, normalised(near), **RECIPE)
    assert (stage_one.logits(normalised(near)[95:, 0]).argmax(axis=1) == 1).all()


def test_a_component_knows_only_its_own_cluster(trained):
    changed = described(12)
    changed[SCATTERED.labels != 1] *= -1
    components, _ = train_components(SCATTERED, changed, **RECIPE)
    assert np.array_equal(components.part(1).weight, trained[1].part(1).weight)
    assert not np.allclose(components.part(0).weight, trained[1].part(0).weight)


def test_added_clusters_get_components_and_the_others_stay(trained, monkeypatch):
    clusters = Clusters([*SCATTERED.labels, 4, 4, 5, 4])
    descriptors = described(16)
    descriptors[:12] = described(12)
    expected, _ = train_components(clusters, descriptors, **RECIPE)
    asked = []
    train = regression.train_head
    monkeypatch.setattr(training, "train_head", lambda *args: asked.append(args[1]) or train(*args))
    components, reports = train_components(clusters, descriptors, **RECIPE, known=(trained[1], trained[2].components))
    assert asked == [3, 1] and len(reports) == 6
    assert np.array_equal(components.head.weight, expected.head.weight)
    assert np.array_equal(components.head.weight[:12], trained[1].head.weight)
    assert components.answers(descriptors[13, 0], np.array([4]), 1).references.tolist() == [13]


@pytest.mark.parametrize("labels", [[0] * 16, [*SCATTERED.labels, 3]], ids=["other", "grown"])
def test_known_components_must_be_those_of_the_beginning(trained, labels):
    with pytest.raises(ValueError, match="must be those of the first clusters"):
        train_components(Clusters(labels), described(len(labels)), **RECIPE, known=(trained[1], trained[2].components))


class StoppedHereError(Exception):
    pass


@pytest.mark.parametrize("calls", [1, 7, 20, 45, 60])
def test_interrupted_anywhere_it_goes_on_the_same_to_the_last_bit(trained, tmp_path, monkeypatch, calls):
    monkeypatch.setattr(lbfgs, "_SAVE_EVERY", 0.0)
    monkeypatch.setattr(training, "_BLOCK", 2)
    gradient, left = regression._Loss.with_gradient, [calls]

    def failing(self, point):
        left[0] -= 1
        if left[0] < 0:
            raise StoppedHereError
        return gradient(self, point)

    monkeypatch.setattr(regression._Loss, "with_gradient", failing)
    with checkpoints(tmp_path), pytest.raises(StoppedHereError):
        train_parts(SCATTERED, described(12), **RECIPE)
    left[0] = whole = 100_000
    with checkpoints(tmp_path):
        again = train_parts(SCATTERED, described(12), **RECIPE)
    resumed, left[0] = whole - left[0], whole
    train_parts(SCATTERED, described(12), **RECIPE)
    assert same(again, trained)
    assert resumed < whole - left[0] or calls == 1


def test_progress_is_told(monkeypatch):
    from contextlib import contextmanager

    bars = {}

    @contextmanager
    def listener(description, total):
        bars[description] = [total, 0]
        yield lambda steps: bars[description].__setitem__(1, bars[description][1] + steps)

    with listen(listener):
        train_parts(SCATTERED, described(12), **RECIPE)
    assert list(bars) == ["Training stage one", "Training components"]
    assert bars["Training components"] == [4, 4]
    assert 0 < bars["Training stage one"][1] <= bars["Training stage one"][0]


def test_answering_needs_no_scikit_learn():
    code = (
        "import sys; import vpr_baselines.twostage.method; "
        "print([name for name in ('scipy', 'sklearn') if name in sys.modules])"
    )
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    assert found.strip() == "[]"
