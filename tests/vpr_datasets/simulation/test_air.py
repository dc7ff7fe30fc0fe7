import numpy as np

from vpr_datasets.simulation.air import AIR, snowfall, veil
from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.raster import FAR, Buffers, jitter_pattern


def test_haze_takes_half_of_the_light_where_it_should() -> None:
    buffers = Buffers.empty(jitter_pattern(4, 4))
    buffers.depth[0], buffers.depth[1] = 0.5, 60.0
    veiled = veil(np.zeros((4, 4, 3), dtype=np.uint16), buffers, 60.0)
    assert veiled[0].max() < 0.02 * AIR
    assert (np.abs(veiled[1] / AIR - 0.5) < 0.01).all()
    assert buffers.depth[2, 0] == np.float32(FAR) and (veiled[2:] < AIR).all()


def test_more_snow_falls_when_it_snows_harder() -> None:
    black = np.zeros((60, 80, 3), dtype=np.uint16)
    share = [float((snowfall(black, Dice(1), amount) > 0).mean()) for amount in (0.0, 0.5, 1.0, 2.0)]
    assert share[0] == 0 and share[1] < share[2] < share[3] < 0.4
    np.testing.assert_array_equal(snowfall(black, Dice(2), 1.0), snowfall(black, Dice(2), 1.0))
