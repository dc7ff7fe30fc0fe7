"""Every method that comes with the project passes, at sizes that do not take long."""

from vpr_bench.check import parametrize_with_checks
from vpr_bench.check.method import Subject
from vpr_bench.method.build import METHODS

_SMALL = {"width": 64, "height": 64}
_NETWORK = {"inner": "efficientnet-lite0", "inner.width": 64, "inner.height": 64}

CHECKED = [
    ("alexnet", {"width": 127, "height": 127, "weights": "random"}),
    ("efficientnet-lite0", _SMALL),
    "hmm",
    "hog",
    "hog:thesis",
    "random",
    ("resnet18", {**_SMALL, "weights": "random"}),
    "sad",
    "sad:raw",
    "seqslam",
    ("seqslam", {**_NETWORK, "future": 3}),
    ("seqslam", {"inner": "random"}),
    ("sift", {"size": 160}),
    ("sift", {"size": 160, "verify": "homography"}),
    ("sift:thesis", {"size": 160}),
    ("twostage", _SMALL),
]


@parametrize_with_checks(CHECKED)
def test_method(check):
    check()


def test_no_registered_method_is_left_out():
    checked = {(one if isinstance(one, str) else one[0]).partition(":")[0] for one in CHECKED}
    assert checked == {entry.name for entry in METHODS.entries() if entry.origin.startswith("vpr-bench ")}


def test_what_is_declared_is_little():
    declared = {subject.id: dict(subject.expected_failures) for subject in map(Subject.of, CHECKED)}
    assert {name: list(checks) for name, checks in declared.items() if checks} == {
        "random": ["finds-the-same-image"],
        "twostage(width=64,height=64)": ["permuted-references"],
    }
