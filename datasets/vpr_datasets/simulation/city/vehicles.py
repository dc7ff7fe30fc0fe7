"""What vehicles are made of, with all their sides, so that they look right from a car, a bicycle and a bus."""

from dataclasses import dataclass

from vpr_datasets.simulation.materials import toned
from vpr_datasets.simulation.stage import Stage
from vpr_datasets.simulation.texture import Canvas, Colour, Texture

PAINTS: tuple[Colour, ...] = (
    (38, 40, 44), (60, 62, 66), (150, 152, 156), (196, 198, 200), (226, 226, 224), (110, 114, 120), (34, 52, 96),
    (150, 30, 34), (226, 226, 224), (44, 84, 60), (40, 84, 140), (190, 160, 120), (28, 28, 30), (90, 30, 36),
)  # fmt: skip

GLASS: Colour = (46, 54, 62)

RUBBER: Colour = (26, 26, 28)

YELLOW: Colour = (240, 202, 40)
"""Of Berlin's buses."""

DENSITY = 42.0


@dataclass(frozen=True)
class Block:
    """A box that is part of a vehicle, open where it has no texture.

    Lengths are in metres, ``rear`` and ``front`` from the vehicle's middle.
    """

    rear: float
    front: float
    inset: float
    low: float
    high: float
    flank: Texture | None
    mirrored: Texture | None
    back: Texture | None
    face: Texture | None
    lid: Texture | None


@dataclass(frozen=True)
class Vehicle:
    """A vehicle of so many blocks."""

    length: float
    width: float
    height: float
    blocks: tuple[Block, ...]
    shadow: Texture

    def put(self, stage: Stage, s: float, t: float, *, onward: bool = True) -> None:
        """Put it at a place; ``onward`` is facing along the path."""
        way = 1.0 if onward else -1.0
        for block in self.blocks:
            half = self.width / 2 - block.inset
            near, far = sorted((s + way * block.rear, s + way * block.front))
            right, left = t - half, t + half
            first, second = (block.flank, block.mirrored) if onward else (block.mirrored, block.flank)
            ends = (block.back, block.face) if onward else (block.face, block.back)
            sides = (((near, right), (far, right), first), ((far, left), (near, left), second),
                     ((near, left), (near, right), ends[0]), ((far, right), (far, left), ends[1]))  # fmt: skip
            for start, stop, texture in sides:
                if texture is not None:
                    stage.wall(start, stop, block.low, block.high, texture)
            if block.lid is not None:
                stage.slab(near, right, far - near, 2 * half, block.high, block.lid)
        # What it stands on is dark: without it, it would seem to float.
        stage.slab(s - self.length / 2 - 0.1, t - self.width / 2 - 0.12, self.length + 0.2, self.width + 0.24, 0.016,
                   self.shadow)  # fmt: skip


def block(
    rear: float,
    front: float,
    inset: float,
    low: float,
    high: float,
    flank: Canvas | None,
    back: Canvas | None,
    face: Canvas | None,
    lid: Canvas | None,
    lettering: tuple[float, float, float, str, Colour] | None = None,
) -> Block:
    """Make a block of its right flank, back, face and lid; what is lettered on the flanks reads well on both."""
    mirrored = None
    if flank is not None:
        mirrored = Canvas(flank.width, flank.height, flank.density)
        mirrored.rgb[:], mirrored.ink[:] = flank.rgb[:, ::-1], flank.ink[:, ::-1]
        if lettering is not None:
            # What is written must not be mirrored.
            x, y, tall, words, ink = lettering
            flank.text(x, y, tall, words, ink)
            mirrored.text(max(flank.width - x - 0.8 * tall * len(words), 0.1), y, tall, words, ink)
    baked = [
        None if canvas is None else canvas.bake(shade)
        for canvas, shade in ((flank, 256), (mirrored, 256), (back, 232), (face, 236), (lid, 270))
    ]
    return Block(rear, front, inset, low, high, *baked)


def shadow() -> Texture:
    """Return what lies below a vehicle."""
    canvas = Canvas(1.0, 1.0, 8.0, (34, 34, 36))
    return canvas.bake()


def wheel(canvas: Canvas, x: float, radius: float) -> None:
    """Paint a wheel that stands on the ground."""
    canvas.disc(x, radius, radius, RUBBER)
    canvas.disc(x, radius, radius * 0.58, (158, 160, 162))
    canvas.disc(x, radius, radius * 0.2, (60, 60, 62))


def plate(canvas: Canvas, y: float, width: float) -> None:
    """Paint a number plate."""
    canvas.rect(width / 2 - 0.27, y, 0.54, 0.13, (232, 232, 226), 30)
    canvas.rect(width / 2 - 0.2, y + 0.03, 0.4, 0.06, (70, 70, 72))


def ends_of(width: float, low: float, high: float, colour: Colour) -> tuple[Canvas, Canvas]:
    """Paint the back and the front of a car's body from the ground up."""
    ends = []
    for lamp, glow in (((186, 30, 30), 150), ((238, 236, 220), 230)):
        canvas = Canvas(width, high, DENSITY)
        for x in (0.1, width - 0.34):
            canvas.rect(x, 0, 0.24, low + 0.1, RUBBER)
        canvas.rect(0.0, low, width, high - low, colour)
        canvas.rect(0.0, low, width, 0.12, toned(colour, 150))
        canvas.rect(0.02, low + 0.1, width - 0.04, 0.05, toned(colour, 190))
        for x in (0.05, width - 0.4):
            canvas.rect(x, high - 0.3, 0.35, 0.17, lamp, glow)
        if glow > 200:
            canvas.rect(width * 0.3, high - 0.32, width * 0.4, 0.17, (30, 30, 32))
        plate(canvas, low + 0.2, width)
        ends.append(canvas)
    return ends[0], ends[1]
