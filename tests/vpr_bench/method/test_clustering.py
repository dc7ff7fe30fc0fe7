from dataclasses import dataclass, field

import numpy as np
import pytest

from vpr_bench.errors import UsageError, VprBenchError
from vpr_bench.method.build import METHODS, BuiltMethod
from vpr_bench.method.clustering import ReferenceClusterer, clustering_method
from vpr_bench.method.interfaces import Clustering, DescribedClustering, Method
from vpr_bench.registry import Entry
from vpr_bench.types.clusters import Clusters
from vpr_bench.types.match import Match
from vpr_bench.types.traverse import Traverse

REFERENCES = Traverse("walk", [np.full((4, 4, 3), grey, np.uint8) for grey in (0, 10, 200, 210, 90)])


@dataclass
class Plain:
    answer: object = None

    def fit(self, references):
        """Learn nothing."""

    def match(self, image, k):
        return Match([], [])


class Halves(Plain):
    def cluster(self, references):
        if isinstance(self.answer, Exception):
            raise self.answer
        return self.answer or Clusters.from_starts([0, 3], len(references))


@dataclass
class Brightness(Plain):
    """Clusters by brightness, and counts how many images it has described."""

    step: int = 100
    scale: float = 1.0
    described: list = field(default_factory=list)

    def describe_for_clusters(self, references):
        self.described.append(len(references))
        return np.array([[image.mean() * self.scale] for image in references], dtype=np.float32)

    def cluster_described(self, descriptors):
        return Clusters.from_labels((descriptors[:, 0] // self.step).astype(int))

    def cluster(self, references):
        return self.cluster_described(self.describe_for_clusters(references))


def built(method):
    return BuiltMethod("mine", "1", {}, None, "mine(a=1)", method)


def test_capabilities_are_told_from_each_other():
    assert isinstance(Halves(), Clustering) and isinstance(Halves(), Method)
    assert not isinstance(Halves(), DescribedClustering) and not isinstance(Plain(), Clustering)
    assert isinstance(Brightness(), DescribedClustering)


def test_clusters_come_with_descriptors_where_the_method_has_some():
    plain = ReferenceClusterer(REFERENCES).cluster(built(Halves()))
    assert plain.clusters.labels.tolist() == [0, 0, 0, 1, 1] and plain.descriptors is None
    described = ReferenceClusterer(REFERENCES).cluster(built(Brightness()))
    assert described.clusters.labels.tolist() == [0, 0, 1, 1, 0]
    assert described.descriptors.ravel().tolist() == [0, 10, 200, 210, 90]


def test_references_are_described_once_for_all_parameters_that_do_not_change_that():
    clusterer = ReferenceClusterer(REFERENCES)
    first, second, third = Brightness(step=100), Brightness(step=50), Brightness(scale=2.0)
    clusterer.cluster(built(first))
    assert clusterer.cluster(built(second)).clusters.labels.tolist() == [0, 0, 1, 1, 2]
    assert clusterer.cluster(built(third)).descriptors.ravel().tolist() == [0, 20, 400, 420, 180]
    assert (first.described, second.described, third.described) == ([5], [2], [2, 5])


@pytest.mark.parametrize(
    ("method", "error", "message"),
    [
        (Plain(), UsageError, "does not cluster references"),
        (Halves(ValueError("n_clusters is too large")), UsageError, "cannot cluster walk: n_clusters is too large"),
        (Halves(RuntimeError("boom")), VprBenchError, "failed to cluster walk: RuntimeError: boom"),
        (Halves([0, 0, 1]), VprBenchError, "must return Clusters of 5 references. Got list"),
        (Halves(Clusters([0, 0])), VprBenchError, "Got 2 references"),
    ],
)
def test_what_goes_wrong_is_told_in_one_line(method, error, message):
    with pytest.raises(error, match=message) as raised:
        ReferenceClusterer(REFERENCES).cluster(built(method))
    assert "\n" not in str(raised.value) and type(raised.value) is error


def test_the_first_method_that_clusters_is_found_without_importing_any(tmp_path, monkeypatch):
    (tmp_path / "never_imported.py").write_text(
        "raise ImportError\nclass A:\n    def fit(self): ...\nclass B(A):\n    def cluster(self): ...\n"
    )
    monkeypatch.syspath_prepend(tmp_path)
    entries = {name: [Entry(name, f"never_imported:{name.upper()}", "somewhere")] for name in ("a", "b")}
    monkeypatch.setitem(vars(METHODS), "_found", entries)
    assert clustering_method() == "b"
    monkeypatch.setitem(vars(METHODS), "_found", {"a": entries["a"]})
    with pytest.raises(UsageError, match="No installed method clusters"):
        clustering_method()
