import hashlib
from pathlib import Path

import numpy as np
import pytest

from vpr_bench.dataset.content import case_digest, traverse_digest
from vpr_bench.dataset.recording import Recording
from vpr_bench.errors import DataError
from vpr_bench.types.ground_truth import GroundTruth
from vpr_bench.types.traverse import Traverse


@pytest.fixture
def files(tmp_path):
    """Three files, not in the order of their names."""
    paths = [tmp_path / name for name in ("b.jpg", "a.jpg", "c.jpg")]
    for path in paths:
        path.write_bytes(path.name.encode() * 3)
    return paths


def test_the_digest_is_that_of_the_listing_by_sha256sum(files):
    lines = [f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {path.name}\n" for path in sorted(files)]
    expected = f"sha256:{hashlib.sha256(''.join(lines).encode()).hexdigest()}"
    assert traverse_digest(Traverse("walk", files)) == expected
    assert traverse_digest(Traverse("renamed", files[::-1])) == expected


def test_the_digest_depends_on_every_byte_and_on_the_names(files):
    digests = [traverse_digest(Traverse("walk", files)), traverse_digest(Traverse("walk", files[:2]))]
    files[1].write_bytes(b"A" + files[1].read_bytes()[1:])
    digests.append(traverse_digest(Traverse("walk", files)))
    files[1] = files[1].rename(files[1].with_name("d.jpg"))
    digests.append(traverse_digest(Traverse("walk", files)))
    assert len(set(digests)) == 4


def test_the_digest_of_images_in_memory_depends_on_their_order():
    light, dark = np.full((2, 2, 3), 200, np.uint8), np.zeros((2, 2, 3), np.uint8)
    digests = {traverse_digest(Traverse("m", images)) for images in ([light, dark], [dark, light], [light])}
    assert len(digests) == 3
    assert traverse_digest(Traverse("m", [light, dark])) == traverse_digest(Traverse("n", [light.copy(), dark]))


def test_a_missing_file_is_a_data_error(files):
    files[2].unlink()
    with pytest.raises(DataError, match=r"c\.jpg"):
        traverse_digest(Traverse("walk", files))


def test_the_digest_of_a_case_depends_on_traverses_and_labels():
    labels = np.arange(3.0)
    truth = GroundTruth.from_lists([[0], [1], [2]], 3)
    walk = Traverse("walk", [Path("Image2.jpg"), Path("Image10.jpg"), Path("Image1.jpg")])

    def digest(x="x", y="y", labels=labels, walk=walk, given=None):
        return case_digest([(Recording(walk, np.arange(3.0)), x), (Recording(walk, labels), y)], given)

    changed = {
        digest(),
        digest(x="y", y="x"),
        digest(y="z"),
        digest(labels=np.array([0, 1, 2.5])),
        digest(walk=walk.subset([2, 0, 1])),  # the same files and labels, another order
        digest(walk=Traverse("walk", walk.sources, convert=np.negative)),
        digest(given=truth),
        digest(given=truth.with_soft(GroundTruth.from_lists([[1], [], []], 3))),
    }
    assert len(changed) == 8
    assert digest(labels=np.arange(6.0)[::2] / 2) == digest(labels=np.arange(3, dtype=">f8")) == digest()


def test_images_that_change_places_between_folders_are_noticed(tmp_path):
    files = [tmp_path / folder / "1.jpg" for folder in "ab"]
    for file in files:
        file.parent.mkdir()
        file.write_text(file.parent.name)
    before = traverse_digest(Traverse("walk", files), afresh=True)
    files[0].write_text("b")
    files[1].write_text("a")
    assert traverse_digest(Traverse("walk", files), afresh=True) != before
