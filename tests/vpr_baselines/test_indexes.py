import importlib.util

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sklearn.metrics import pairwise_distances

from vpr_baselines import indexes
from vpr_baselines.indexes import ExactIndex, build_index, check_index, load_index
from vpr_bench.errors import UsageError
from vpr_bench.method.build import build_method


@pytest.mark.parametrize("metric", ["euclidean", "manhattan"])
@settings(max_examples=25)
@given(st.integers(1, 300), st.integers(1, 700), st.integers(0, 9))
def test_distances_are_scikit_learns(metric, count, length, seed):
    generator = np.random.default_rng(seed)
    database = generator.normal(size=(count, length)).astype(np.float32)
    query = generator.normal(size=length).astype(np.float32)
    expected = pairwise_distances(query[np.newaxis].astype(np.float64), database.astype(np.float64), metric)[0]
    assert ExactIndex(database, metric).scores(query) == pytest.approx(-expected, rel=1e-5)


def test_rows_longer_than_a_block_are_compared_too():
    database = np.random.default_rng(0).random((5, indexes._BLOCK + 3), dtype=np.float32)
    assert ExactIndex(database, "manhattan").search(database[3], 1).indices.tolist() == [3]


def test_small_distances_are_exact_though_the_numbers_are_large():
    """|a|² + |b|² - 2ab is off by as much as the distance here."""
    database = np.full((2, 1000), 255, np.float32)
    database[1, 0] += 0.5
    assert ExactIndex(database, "euclidean").scores(database[0]).tolist() == [0, -0.5]


def test_cosine_is_the_product_with_the_database():
    database = np.random.default_rng(0).random((50, 30), dtype=np.float32)
    assert np.array_equal(ExactIndex(database, "cosine").scores(database[7]), database @ database[7])


def test_equally_near_references_keep_their_order():
    database = np.zeros((6, 4), np.float32)
    assert ExactIndex(database, "manhattan").search(database[0], 3).indices.tolist() == [0, 1, 2]


def test_the_exact_index_survives_the_disk(tmp_path):
    database = np.random.default_rng(0).random((9, 5), dtype=np.float32)
    build_index("exact", "euclidean", database).save(tmp_path)
    loaded = load_index("exact", "euclidean", tmp_path)
    assert loaded.search(database[4], 1).indices.tolist() == [4]


@pytest.mark.parametrize("name", ["hnsw", "ivf"])
def test_approximate_indexes_do_not_know_manhattan(name):
    with pytest.raises(ValueError, match=f"the index '{name}' knows cosine and euclidean"):
        check_index(name, "manhattan")


def test_faiss_is_asked_for_only_where_it_is_needed(monkeypatch):
    monkeypatch.setattr(indexes, "find_spec", lambda name: None)
    check_index("exact", "manhattan")
    with pytest.raises(UsageError, match=r"index=hnsw needs FAISS: pip install 'vpr-bench\[faiss\]'"):
        build_method("hog", {"index": "hnsw"})


@pytest.mark.skipif(importlib.util.find_spec("faiss") is None, reason="faiss is not installed")
@pytest.mark.parametrize("metric", ["cosine", "euclidean"])
@pytest.mark.parametrize("name", ["hnsw", "ivf"])
class TestFaiss:
    @pytest.fixture
    def database(self, metric):
        """Return 800 descriptors around 40 centres, as places are."""
        generator = np.random.default_rng(0)
        centres = generator.normal(size=(40, 32)).repeat(20, axis=0)
        vectors = (centres + 0.5 * generator.normal(size=centres.shape)).astype(np.float32)
        return vectors / np.linalg.norm(vectors, axis=1, keepdims=True) if metric == "cosine" else vectors

    def test_it_finds_nearly_all_that_exact_search_finds(self, name, metric, database):
        index, exact = build_index(name, metric, database), ExactIndex(database, metric)
        queries = database[::20] + np.float32(0.01)
        hits = 0
        for query in queries:
            ours, truth = index.search(query, 10), exact.search(query, 10)
            common = np.intersect1d(ours.indices, truth.indices)
            hits += len(common)
            assert ours.scores == pytest.approx(exact.scores(query)[ours.indices], abs=1e-4)
        assert hits >= 0.95 * 10 * len(queries)

    def test_the_same_descriptors_make_the_same_map(self, name, metric, database):
        one, other = (build_index(name, metric, database) for _ in range(2))
        for query in database[::50]:
            assert one.search(query, 20).indices.tolist() == other.search(query, 20).indices.tolist()

    def test_it_survives_the_disk(self, name, metric, database, tmp_path):
        index = build_index(name, metric, database)
        index.save(tmp_path)
        loaded = load_index(name, metric, tmp_path)
        for query in database[::50]:
            before, after = index.search(query, 5), loaded.search(query, 5)
            assert before.indices.tolist() == after.indices.tolist()
            assert before.scores.tolist() == after.scores.tolist()

    def test_a_small_map_is_enough(self, name, metric, database):
        found = build_index(name, metric, database[:2]).search(database[1], 9)
        assert found.indices.tolist() == [1, 0]

    def test_as_many_are_answered_as_are_asked_for(self, name, metric, database):
        index = build_index(name, metric, database)
        for k in (1, len(database) - 1, len(database) + 1):
            assert len(index.search(database[0], k)) == min(k, len(database))

    def test_similarities_to_all_references_are_refused(self, name, metric, database):
        method = build_method("hog", {"index": name, "metric": metric, "width": 32, "height": 32}).method
        images = [np.random.default_rng(i).integers(0, 256, (32, 32, 3), dtype=np.uint8) for i in range(3)]
        method.fit(images)
        assert method.match(images[2], 1).indices.tolist() == [2]
        with pytest.raises(ValueError, match="need index='exact'"):
            method.scores(images[0])
