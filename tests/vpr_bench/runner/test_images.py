from dataclasses import replace

import pytest

from vpr_bench.dataset.load import load_case
from vpr_bench.errors import UsageError
from vpr_bench.runner.images import OtherImagesError, case_of
from vpr_bench.types.protocol import Protocol

ASKED = Protocol.parse("tiny/day_left-night_right@3f~reject")


@pytest.fixture
def digest(tiny_dataset):
    return load_case(str(ASKED)).digest


def test_the_same_images_are_found_with_radius_and_policy(digest):
    case = case_of(ASKED, digest)
    assert (case.digest, case.protocol) == (digest, ASKED)


def test_others_are_refused_and_both_digests_told(digest):
    with pytest.raises(OtherImagesError, match="sha256:1111 were recorded") as caught:
        case_of(ASKED, "sha256:1111")
    assert (caught.value.recorded, caught.value.found) == ("sha256:1111", digest)
    assert caught.value.folder == load_case("tiny").folder


def test_a_folder_of_ones_own_goes_by_the_name_in_the_result(tiny_images):
    own = load_case(str(tiny_images), "day_left-day_right")
    asked = replace(own.protocol, dataset="formerly", radius=2, unmatched="miss")
    assert case_of(asked, own.digest, str(tiny_images)).protocol == asked
    with pytest.raises(UsageError, match="formerly"):
        case_of(asked, own.digest)
