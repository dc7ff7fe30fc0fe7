import hashlib

import pytest
import torch

from vpr_bench.errors import DataError, UsageError
from vpr_bench.weights.choice import choose_weights
from vpr_bench.weights.place import MissingWeightsError


def test_a_training_set(tiny_weights, saved):
    choice = choose_weights("tiny-net", "dots")
    for asked in (choice.identity, choice.tensors):
        with pytest.raises(MissingWeightsError, match="weights fetch tiny-net-dots"):
            asked()
    (tiny_weights.folder / "tiny.pth").write_bytes(saved)
    assert choice.identity() == f"tiny-net (Dots) sha256:{hashlib.sha256(saved).hexdigest()}"
    assert torch.equal(choice.tensors()["fc.weight"], torch.ones(2, 3))


def test_a_file(tiny_weights, saved, tmp_path, monkeypatch):
    file = tmp_path / "mine.pth"
    for asked in (choose_weights("tiny-net", str(file)).identity, choose_weights("tiny-net", str(file)).tensors):
        with pytest.raises(DataError, match=r"mine.pth are not there"):
            asked()
    file.write_bytes(saved)
    monkeypatch.chdir(tmp_path)
    for path in (str(file), "mine.pth", "./mine.pth"):
        choice = choose_weights("tiny-net", path)
        assert choice.identity() == f"tiny-net (mine.pth) sha256:{hashlib.sha256(saved).hexdigest()}"
        assert choice.tensors().keys() == {"fc.weight"}


def test_random_numbers_must_be_asked_for_by_name(tiny_weights):
    choice = choose_weights("tiny-net", "random", seed=7)
    assert choice.random and choice.identity() == "tiny-net (random, seed 7)" and choice.tensors() == {}
    assert not choose_weights("tiny-net", "dots").random


@pytest.mark.parametrize(
    ("asked", "advice"), [("dot", "Did you mean 'dots'"), ("", "Known: dots, random"), ("x", "Known")]
)
def test_what_means_nothing_is_a_usage_error(tiny_weights, asked, advice):
    with pytest.raises(UsageError, match=f"no weights '{asked}' of tiny-net.*{advice}"):
        choose_weights("tiny-net", asked)
