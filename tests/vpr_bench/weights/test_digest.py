import hashlib

import pytest

from vpr_bench.errors import DataError
from vpr_bench.weights.digest import OtherWeightsError, weights_digest


@pytest.fixture
def placed(tiny_weights, saved):
    """Put the weights where they belong; return the digits of their digest."""
    (tiny_weights.folder / "tiny.pth").write_bytes(saved)
    return hashlib.sha256(saved).hexdigest()


def spoil(tiny_weights):
    file = tiny_weights.folder / "tiny.pth"
    file.write_bytes(file.read_bytes() + b"\0")  # which can still be read


@pytest.mark.parametrize("whole", [True, False])
def test_published_digests_are_held_against_the_file(tiny_weights, placed, whole):
    published = {"sha256": f"sha256:{placed}"} if whole else {"sha256_prefix": placed[:8]}
    card = tiny_weights.register(**published)
    assert weights_digest(card) == f"sha256:{placed}"
    spoil(tiny_weights)
    for accept in (False, True):
        with pytest.raises(DataError, match=r"damaged or another file: .*\n.*`vpr-bench weights fetch tiny-net-dots`"):
            weights_digest(card, accept=accept)


def test_without_one_the_first_contact_decides_and_can_be_replaced(tiny_weights, placed):
    card = tiny_weights.register()
    assert weights_digest(card) == weights_digest(card) == f"sha256:{placed}"
    spoil(tiny_weights)
    with pytest.raises(
        OtherWeightsError, match=r"not the file that was met here first.*\n.*verify tiny-net-dots --accept"
    ):
        weights_digest(card)
    accepted = weights_digest(card, accept=True)
    assert accepted != f"sha256:{placed}" and weights_digest(card) == accepted


def test_what_is_no_checkpoint_is_not_met(tiny_weights, saved):
    card, file = tiny_weights.register(), tiny_weights.folder / "tiny.pth"
    file.write_bytes(b"<html></html>")
    with pytest.raises(DataError, match="is a web page"):
        weights_digest(card)
    file.write_bytes(saved)
    assert weights_digest(card) == f"sha256:{hashlib.sha256(saved).hexdigest()}"
