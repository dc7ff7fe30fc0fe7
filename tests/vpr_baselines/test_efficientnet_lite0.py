import numpy as np
import pytest
from conftest import TINY_PLACES, tiny_image

from vpr_bench.method.build import build_method
from vpr_bench.types.traverse import Traverse

SMALL = {"width": 96, "height": 64}
