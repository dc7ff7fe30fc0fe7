import gc

import pytest

from vpr_bench.garbage import no_collections


@pytest.mark.parametrize("enabled", [True, False])
def test_collections_are_as_they_were_afterwards(enabled):
    (gc.enable if enabled else gc.disable)()
    try:
        with pytest.raises(RuntimeError), no_collections():
            assert not gc.isenabled()
            raise RuntimeError
        assert gc.isenabled() is enabled
    finally:
        gc.enable()


def test_what_was_made_inside_is_never_looked_through_again():
    with no_collections():
        kept = [[number] for number in range(1000)]
    try:
        assert gc.get_freeze_count() > len(kept)
    finally:
        gc.unfreeze()
