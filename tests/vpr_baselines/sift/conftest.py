import cv2
import numpy as np
import pytest


@pytest.fixture(scope="session")
def scenes():
    """Return 6 pictures of shapes, (180, 240, 3) uint8, with corners to find."""
    return [scene(place) for place in range(6)]


def scene(place):
    generator = np.random.default_rng(place)
    image = np.full((180, 240, 3), 90, np.uint8)
    for _ in range(60):
        corner, size = generator.integers((-20, -20), (240, 180)), generator.integers(6, 50, 2)
        colour = generator.integers(0, 256, 3).tolist()
        if generator.random() < 0.5:
            cv2.rectangle(image, corner.tolist(), (corner + size).tolist(), colour, -1)
        else:
            cv2.ellipse(image, corner.tolist(), size.tolist(), float(generator.integers(180)), 0, 360, colour, -1)
    return image
