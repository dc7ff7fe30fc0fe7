import numpy as np
import pytest

from vpr_baselines.projection import gaussian_projection


def test_angles_and_distances_are_nearly_kept():
    vectors = np.random.default_rng(1).random((20, 3000), dtype=np.float32) ** 4
    projected = vectors @ gaussian_projection(3000, 1000, 0).T

    def distances(points):
        return np.linalg.norm(points[:, None] - points[None], axis=2)[np.triu_indices(20, 1)]

    assert projected.shape == (20, 1000) and projected.dtype == np.float32
    assert distances(projected) == pytest.approx(distances(vectors), rel=0.12)
    assert np.linalg.norm(projected, axis=1) == pytest.approx(np.linalg.norm(vectors, axis=1), rel=0.12)


def test_the_matrix_depends_on_the_seed_alone():
    first = gaussian_projection(30, 20, 0)
    assert not np.array_equal(gaussian_projection(30, 20, 1), first)
    assert np.array_equal(gaussian_projection(30, 20, 0), first)
