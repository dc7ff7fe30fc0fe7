"""Not looking for garbage where much is made that stays."""

import gc
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def no_collections() -> Iterator[None]:
    """Collect no garbage inside the ``with`` block, and never what it leaves behind.

    Importing a network library and reading weights makes a million objects that stay; looking through them again
    and again takes a tenth of the time, and once, right after the block, a tenth of a second.
    """
    enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if enabled:
            gc.freeze()
            gc.enable()
