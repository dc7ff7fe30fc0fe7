"""Ground floors of Amsterdam: doors above steps, shops of today, and shops of a hundred years ago."""

from functools import lru_cache

from vpr_datasets.simulation.chance import Dice
from vpr_datasets.simulation.city.amsterdam import DOORS, GROUND, House
from vpr_datasets.simulation.city.gables import STONE
from vpr_datasets.simulation.city.shops import BOARDS, GOODS, ink_on
from vpr_datasets.simulation.city.windows import glaze, sash
from vpr_datasets.simulation.city.words import DUTCH
from vpr_datasets.simulation.lots import plain, wall_across, wall_along
from vpr_datasets.simulation.materials import brick, plaster, tinted, toned
from vpr_datasets.simulation.spec import Epoch
from vpr_datasets.simulation.stage import Stage
from vpr_datasets.simulation.texture import Canvas, Colour, Texture

DENSITY = 32.0


@lru_cache(maxsize=2048)
def paint_ground_floor(seed: int, number: int, style: str, house: House, shade: int) -> Texture:
    """Paint the ground floor of a house: a home, or what ``style`` says was sold there and when."""
    dice = Dice(seed, "ground floor", number, style)
    canvas = Canvas(house.width, GROUND, DENSITY, house.colour)
    (brick if house.brick else plaster)(canvas, dice)
    canvas.rect(0, 0, house.width, 0.7, tinted(dice, (120, 118, 114), 14))
    door = dice.chance(0.5)
    if style == "home":
        _home(canvas, dice, house, left=door)
    elif style == "today":
        _shop(canvas, dice, house, left=door)
    else:
        _old_shop(canvas, dice, house, left=door)
    canvas.rect(0, GROUND - 0.24, house.width, 0.24, STONE if dice.chance(0.5) else toned(house.colour, 200))
    canvas.rect(0, GROUND - 0.3, house.width, 0.06, toned(house.colour, 120))
    return canvas.bake(shade)


def _door(canvas: Canvas, dice: Dice, x: float, low: float, high: float) -> None:
    canvas.rect(x - 0.18, low, 1.36, high - low, STONE)
    colour = tinted(dice, dice.pick(DOORS), 8)
    canvas.rect(x, low, 1.0, 2.1, colour)
    for y in (low + 0.2, low + 1.2):
        canvas.frame(x + 0.15, y, 0.7, 0.75, 0.06, toned(colour, 180))
    canvas.rect(x, low + 2.16, 1.0, high - low - 2.3, (92, 100, 104), 130)
    canvas.frame(x, low + 2.16, 1.0, high - low - 2.3, 0.05, STONE)


def _home(canvas: Canvas, dice: Dice, house: House, *, left: bool) -> None:
    """Put in a door above a few steps, tall windows, and small ones of the basement."""
    x = 0.5 if left else house.width - 1.6
    _door(canvas, dice, x, 0.7, 3.3)
    for step in range(4):
        canvas.rect(x - 0.5 + step * 0.05, 0.17 * step, 2.0 - step * 0.1, 0.16, tinted(dice, (164, 160, 152), 8))
    start, room = (2.0, house.width - 2.4) if left else (0.4, house.width - 2.4)
    count = max(int(room / 1.5), 1)
    for number in range(count):
        wide = min(1.2, room / count - 0.3)
        place = start + (number + 0.5) * room / count - wide / 2
        canvas.rect(place - 0.1, 0.95, wide + 0.2, 0.1, STONE)
        sash(canvas, dice, place, 1.05, wide, 2.1, house.frame, panes=2)
        canvas.rect(place, 0.15, wide, 0.4, (44, 48, 52))
        for bar in range(5):
            canvas.rect(place + bar * wide / 5, 0.15, 0.04, 0.4, (90, 92, 94))


def _shop(canvas: Canvas, dice: Dice, house: House, *, left: bool) -> None:
    """Put in a shop of today: large panes below a bright board."""
    frame = dice.pick(((36, 38, 42), (226, 224, 218), (90, 60, 44), (60, 84, 72), (140, 40, 40)))
    canvas.rect(0.2, 0.1, house.width - 0.4, 2.75, frame)
    x = 0.35 if left else house.width - 1.45
    glaze(canvas, dice, x + 0.1, 0.15, 0.9, 2.4, frame, lit=0.9)
    start, room = (1.6, house.width - 1.95) if left else (0.35, house.width - 1.95)
    canvas.rect(start, 0.45, room, 2.2, tinted(dice, (88, 84, 80), 18), 150)
    for _ in range(int(room * 6)):
        canvas.rect(dice.between(start, start + room - 0.3), dice.pick((0.5, 1.0, 1.5)), dice.between(0.1, 0.35),
                    dice.between(0.15, 0.45), _behind_glass(tinted(dice, dice.pick(GOODS), 20)), 150)  # fmt: skip
    for number in range(1 + int(room / 1.8)):
        canvas.rect(min(start + number * 1.8, start + room - 0.06), 0.45, 0.06, 2.2, frame)
    board = tinted(dice, dice.pick(BOARDS), 10)
    canvas.rect(0.2, 2.72, house.width - 0.4, 0.52, board, 60)
    name = dice.pick(DUTCH)
    tall = min(0.34, (house.width - 0.8) / len(name) * 1.1)
    canvas.text(0.45, 2.8, tall, name, ink_on(board))


def _behind_glass(colour: Colour) -> Colour:
    """Return a colour as it looks through a pane that mirrors the street."""
    red, green, blue = colour
    return (red + 170) // 3, (green + 172) // 3, (blue + 176) // 3


def _old_shop(canvas: Canvas, dice: Dice, house: House, *, left: bool) -> None:
    """Put in a shop of long ago: a wooden front, many small panes, lettering on the wall."""
    wood = tinted(dice, dice.pick(((60, 46, 36), (44, 54, 46), (80, 40, 36), (150, 140, 120), (40, 40, 44))), 8)
    canvas.rect(0.15, 0.0, house.width - 0.3, 3.2, wood)
    x = 0.4 if left else house.width - 1.45
    sash(canvas, dice, x, 0.7, 1.0, 1.9, toned(wood, 300), panes=2)
    canvas.rect(x, 0.1, 1.0, 0.6, toned(wood, 200))
    start, room = (1.65, house.width - 2.0) if left else (0.35, house.width - 2.0)
    canvas.rect(start, 0.75, room, 1.85, (70, 70, 68))
    for _ in range(int(room * 5)):
        canvas.rect(dice.between(start, start + room - 0.2), dice.pick((0.8, 1.3, 1.8)), dice.between(0.08, 0.25),
                    dice.between(0.12, 0.35), tinted(dice, (170, 160, 140), 40))  # fmt: skip
    for number in range(int(room / 0.6) + 1):
        canvas.rect(start + min(number * 0.6, room - 0.05), 0.75, 0.05, 1.85, toned(wood, 300))
    for y in (1.35, 2.0, 2.55):
        canvas.rect(start, y, room, 0.05, toned(wood, 300))
    canvas.rect(0.25, 2.68, house.width - 0.5, 0.5, dice.pick(((30, 30, 32), (220, 214, 196), (60, 30, 28))))
    name = dice.pick(DUTCH)
    dark = int(canvas.rgb[canvas.area(0.3, 2.9, 0.1, 0.1)][0, 0, 0]) < 120
    canvas.text(
        0.45, 2.78, min(0.32, (house.width - 0.8) / len(name) * 1.1), name, (226, 214, 170) if dark else (40, 36, 32)
    )


def put_stoop(stage: Stage, dice: Dice, house: House, style: str, epoch: Epoch, side: int, s: float, t: float) -> None:
    """Put out what stands before a ground floor: steps and railings, or an awning."""
    if style == "home":
        if dice.chance(0.6):
            stone = plain((170, 166, 158), dice)
            place = s + (1.0 if dice.chance(0.5) else house.width - 1.1)
            stage.box(place, side * (t - 0.5), 1.6, 1.0, 0.5, stone, stone, stone)
            rail = Canvas(1.0, 0.9, 40.0)
            for number in range(6):
                rail.rect(number * 0.18, 0, 0.04, 0.9, (36, 38, 40))
            rail.rect(0, 0.82, 1.0, 0.06, (36, 38, 40))
            wall_across(stage, place - 0.8, t - 1.0, 1.0, 0.5, 1.4, rail.bake(), side)
            wall_across(stage, place + 0.8, t - 1.0, 1.0, 0.5, 1.4, rail.bake(), side)
        return
    if dice.chance(0.55 if epoch == "archive" else 0.35):
        reach = dice.between(0.8, 1.5)
        colour = (196, 188, 170) if epoch == "archive" else tinted(dice, dice.pick(BOARDS), 10)
        cloth = Canvas(house.width - 0.4, 0.7, 32.0, colour)
        for number in range(int(house.width / 0.5)):
            cloth.rect(number * 0.5, 0, 0.25, 0.7, toned(colour, 290 if sum(colour) < 450 else 200))
        wall_along(stage, side, s + 0.2, s + house.width - 0.2, t - reach, 2.3, 2.95, cloth.bake())
        cover = plain(toned(colour, 170), dice)
        wall_across(stage, s + 0.2, t - reach, reach, 2.4, 2.95, cover, side)
        stage.slab(s + 0.2, t - reach if side > 0 else -t, house.width - 0.4, reach, 2.5, cover, roof=True)
    if epoch == "today" and dice.chance(0.5):
        board = Canvas(0.7, 0.7, 48.0, tinted(dice, dice.pick(BOARDS), 8))
        board.disc(0.35, 0.42, 0.2, tinted(dice, (226, 222, 212), 20))
        board.text(0.06, 0.06, 0.16, dice.pick(DUTCH)[:5], (240, 238, 230))
        board.ink[:] = 100
        wall_across(stage, s + dice.between(0.5, house.width - 0.5), t - 0.9, 0.7, 2.9, 3.6, board.bake(), side)
