import hashlib

import pytest

from vpr_bench.errors import DataError
from vpr_bench.weights.digest import OtherWeightsError
from vpr_bench.weights.fetch import fetch_weights

pytestmark = pytest.mark.usefixtures("pauses")


def names(folder):
    return {path.name for path in folder.iterdir()}


@pytest.mark.parametrize("published", ["nothing", "beginning", "whole"])
def test_weights_are_fetched_once(tiny_weights, server, saved, published):
    page = server.add("/tiny.pth", saved)
    digest = {"nothing": {}, "beginning": {"sha256_prefix": page.sha256[7:15]}, "whole": {"sha256": page.sha256}}
    card = tiny_weights.register(url=page.url, **digest[published])
    for _ in range(2):
        assert fetch_weights(card) == tiny_weights.folder / "tiny.pth"
    assert (tiny_weights.folder / "tiny.pth").read_bytes() == saved
    assert len(page.requests) == 1
    assert {name for name in names(tiny_weights.folder) if not name.endswith(".lock")} == {"tiny.pth"}


def test_an_interrupted_download_is_continued(tiny_weights, server, saved):
    page = server.add("/tiny.pth", saved, cut_after=[500, 300])
    fetch_weights(tiny_weights.register(url=page.url, sha256_prefix=page.sha256[7:15]))
    assert [request.get("Range") for request in page.requests] == [None, "bytes=500-", "bytes=800-"]
    assert (tiny_weights.folder / "tiny.pth").read_bytes() == saved


@pytest.mark.parametrize("published", [{"sha256_prefix": "0" * 8}, {"sha256": f"sha256:{'0' * 64}"}])
def test_what_is_not_what_was_published_does_not_appear(tiny_weights, server, saved, published):
    card = tiny_weights.register(url=server.add("/tiny.pth", saved).url, **published)
    with pytest.raises(DataError, match="digest"):
        fetch_weights(card)
    assert not [name for name in names(tiny_weights.folder) if not name.endswith(".lock")]


def test_what_is_no_checkpoint_does_not_appear(tiny_weights, server):
    page = server.add("/tiny.pth", b"<html>We have moved.</html>")
    with pytest.raises(DataError, match=r"What came from http://127.*/tiny.pth is refused\. .*web page"):
        fetch_weights(tiny_weights.register(url=page.url))
    assert not [name for name in names(tiny_weights.folder) if not name.endswith(".lock")]


def test_what_changes_at_its_source_is_noticed(tiny_weights, server, saved):
    page = server.add("/tiny.pth", saved)
    card = tiny_weights.register(url=page.url)
    fetch_weights(card).unlink()
    page.body = saved + b"\0"
    with pytest.raises(DataError, match=f"expected sha256:{hashlib.sha256(saved).hexdigest()}"):
        fetch_weights(card)


def test_what_is_here_is_verified_and_never_replaced(tiny_weights, server, saved):
    page = server.add("/tiny.pth", saved)
    file = tiny_weights.folder / "tiny.pth"
    file.write_bytes(b"mine")
    with pytest.raises(DataError, match="damaged or another file"):
        fetch_weights(tiny_weights.register(url=page.url, sha256=page.sha256))
    card = tiny_weights.register(url=page.url)
    with pytest.raises(DataError, match="asks for more than tensors, or is damaged"):
        fetch_weights(card)
    file.write_bytes(saved)
    fetch_weights(card)  # nobody knows better: it is met first
    file.write_bytes(saved + b"\0")
    with pytest.raises(OtherWeightsError):
        fetch_weights(card)
    assert file.read_bytes() == saved + b"\0" and not page.requests


def test_what_the_server_does_not_have_is_a_data_error(tiny_weights, server):
    with pytest.raises(DataError, match="404"):
        fetch_weights(tiny_weights.register(url=f"{server.root}/gone.pth"))
