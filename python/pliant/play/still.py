# SPDX-License-Identifier: MIT
"""A still picture of joints, for where no page can be: a notebook that is read without a kernel."""

from __future__ import annotations

import struct
import zlib

import numpy as np
from numpy.typing import NDArray

WIDTH, HEIGHT, MARGIN = 640, 400, 24
LEAST_RADIUS = 2.5  #: of a joint, in pixels
BALL = 0.75  #: Angstrom
COLOURS = {
    1: (226, 230, 235),
    7: (48, 96, 208),
    8: (204, 60, 40),
    15: (240, 140, 40),
    16: (220, 190, 50),
}
GREY = (125, 132, 140)


def picture(positions: NDArray[np.float64], elements: NDArray[np.uint8] | None = None) -> bytes:
    """A PNG of balls from the side where the molecule is widest, on no ground; b"" of nothing."""
    if len(positions) == 0 or not np.isfinite(positions).all():
        return b""
    seen = _turned(np.asarray(positions, np.float64))
    span = np.maximum(np.ptp(seen[:, :2], axis=0), 1e-9)
    scale = min((WIDTH - 2 * MARGIN) / span[0], (HEIGHT - 2 * MARGIN) / span[1], 40.0)
    places = (seen[:, :2] - seen[:, :2].mean(axis=0)) * scale + (WIDTH / 2, HEIGHT / 2)
    image = np.zeros((HEIGHT, WIDTH, 4), np.uint8)
    radius = max(LEAST_RADIUS, BALL * scale)
    depth = seen[:, 2] - seen[:, 2].min()
    share = depth / max(depth.max(), 1e-9)  # 0 far, 1 near
    for joint in np.argsort(depth):
        number = int(elements[joint]) if elements is not None else 6
        _ball(image, places[joint], radius, COLOURS.get(number, GREY), 0.55 + 0.45 * share[joint])
    return _png(image)


def _turned(positions: NDArray[np.float64]) -> NDArray[np.float64]:
    centred = positions - positions.mean(axis=0)
    _, _, axes = np.linalg.svd(centred, full_matrices=False)
    turned: NDArray[np.float64] = centred @ axes.T if len(axes) == 3 else centred
    return turned


def _ball(
    image: NDArray[np.uint8],
    place: NDArray[np.float64],
    radius: float,
    colour: tuple[int, int, int],
    light: float,
) -> None:
    left, top = np.floor(place - radius).astype(int)
    size = int(np.ceil(2 * radius)) + 1
    rows, columns = np.mgrid[top : top + size, left : left + size]
    x, y = (columns - place[0]) / radius, (rows - place[1]) / radius
    inside = (
        (x * x + y * y <= 1) & (rows >= 0) & (rows < HEIGHT) & (columns >= 0) & (columns < WIDTH)
    )
    height = np.sqrt(np.maximum(0, 1 - x * x - y * y))
    shade = light * np.clip(0.45 + 0.55 * (height - 0.4 * x - 0.5 * y) / 1.2, 0.25, 1)
    pixels = np.empty((size, size, 4), np.uint8)
    pixels[..., :3] = shade[..., None] * colour
    pixels[..., 3] = 255
    image[rows[inside], columns[inside]] = pixels[inside]


def _png(image: NDArray[np.uint8]) -> bytes:
    height, width = image.shape[:2]
    rows = np.zeros((height, 1 + 4 * width), np.uint8)  # each begins with the number of its filter
    rows[:, 1:] = image.reshape(height, -1)

    def chunk(name: bytes, data: bytes) -> bytes:
        return (
            struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
        )

    head = struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)
    packed = zlib.compress(rows.tobytes(), 9)
    return (
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", packed) + chunk(b"IEND", b"")
    )
