import numpy as np

from vpr_datasets.simulation.ground import paint_grounds
from vpr_datasets.simulation.path import lay_course
from vpr_datasets.simulation.setting import Setting
from vpr_datasets.simulation.stage import Band, Floor, Slab

COURSE = lay_course(5, 20.0, 0.1, before=5.0, beyond=5.0)
FLOORS = [Floor(-60, 100, 2.5, "track", "meadow", "water")]


def test_the_land_goes_on_below_the_ground() -> None:
    ground, land = paint_grounds(1, "summer", COURSE, FLOORS, Setting(density=8.0, margin=6.0, land=40.0))
    assert land.width > ground.width + 60
    assert land.level < ground.level
    assert len(paint_grounds(1, "summer", COURSE, FLOORS, Setting(density=8.0, margin=6.0))) == 1


def test_snow_covers_the_land_and_spares_the_rails() -> None:
    brightness = []
    for snow in (0.0, 0.4, 1.0):
        (ground,) = paint_grounds(
            1, "winter", COURSE, FLOORS, Setting(density=10.0, margin=8.0, kerb=None, snow={"winter": snow})
        )
        brightness.append(_mean(ground))
    assert brightness[0] + 5 < brightness[1] < brightness[2] - 5
    texels = ground.texture.texels[: ground.texture.widths[0] * ground.texture.heights[0]]
    red = np.asarray(texels & 255).reshape(ground.texture.heights[0], -1)
    rows = red[40:-40].mean(axis=1)
    assert rows.min() < 0.9 * np.median(rows)


def _mean(slab: Slab) -> float:
    return float((slab.texture.texels[: slab.texture.widths[0] * slab.texture.heights[0]] & 255).mean())


def test_bands_lie_on_the_floor_and_holes_go_through() -> None:
    bands = (Band(-3.0, 3.0, "tarmac"), Band(-0.2, 0.2, "line"), Band(3.5, 5.0, "void"))
    floors = [Floor(-60, 100, 2.0, "grass", "grass", "grass", bands)]
    straight = lay_course(5, 20.0, 0.0, before=5.0, beyond=5.0)
    (ground,) = paint_grounds(1, "summer", straight, floors, Setting(density=10.0, margin=8.0, kerb=None))
    texture = ground.texture
    texels = texture.texels[: texture.widths[0] * texture.heights[0]].reshape(texture.heights[0], -1)
    place = {t: texels[round((t + 8.0) * 10)] for t in (-6.0, -1.5, 0.0, 4.2)}
    brightness = {t: float((row & 255).mean()) for t, row in place.items()}
    assert brightness[0.0] > brightness[-1.5] + 60
    assert (place[4.2] >> 24 == 0).all()
    assert all((place[t] >> 24 == 1).all() for t in (-6.0, -1.5, 0.0))
