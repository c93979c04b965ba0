# SPDX-License-Identifier: MIT
"""A picture of each shape: its chain in colour over that of the start in grey."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PathCollection
from matplotlib.colors import to_rgba_array
from matplotlib.figure import Figure
from matplotlib.path import Path

from pliant.base import style
from pliant.measure.domains.rigid_turns import RigidTurns
from pliant.measure.shapes.other_shapes import OtherShapes
from pliant.measure.stages.analysis import Analysis
from pliant.measure.stages.parts import ReferenceStructure

COLUMNS = 4  #: panels in a row
FIRST = 3  #: shapes of the small picture
#: points of the curve for half the way from a residue to the next
POINTS = 4
LONGEST_STEP = 8.0  #: from residue to residue, Angstrom; a longer one is a gap
NEARER = 2.0  #: Angstrom in front of the start: the shape is seen where it has not moved
SCALE = 10.0  #: length of the bar in the corner, Angstrom
BESIDE = np.array([4.0, 16.0])  #: room between two panels, Angstrom


def first_shapes(analysis: Analysis) -> Figure:
    """A small picture of the most plausible ones."""
    return shape_pictures(analysis, FIRST)


def shape_pictures(analysis: Analysis, most: int | None = None) -> Figure:
    """One panel a shape, all to one scale: they share axes, of which each would take as long to
    draw as what is in them."""
    part = analysis[OtherShapes]
    shapes = part.shapes[:most]
    columns = min(COLUMNS, len(shapes))
    width, rows = style.WIDE[0] * max(columns, 2) / COLUMNS, -(-len(shapes) // columns)
    start = analysis[ReferenceStructure].positions[part.sites]
    pairs = [seen(start, shape.turns) for shape in shapes]
    size = 2 * np.max([np.abs(pair[..., :2]).max(axis=(0, 1)) for pair in pairs], axis=0) + BESIDE
    height = width * rows * size[1] / (columns * size[0])
    figure, axes = style.new_figure((width, height))
    axes.set_axis_off()
    for k, (shape, pair) in enumerate(zip(shapes, pairs, strict=True)):
        place = size * (k % columns, -(k // columns))
        draw_shape(axes, pair + np.append(place, 0.0), shape.turns)
        far = f"{shape.rmsd:.1f} Å{' (far)' if part.is_beyond(shape) else ''}"
        name = f"{k + 1}: {far}, frame {shape.frame}"
        at = place + size * (-0.5, 0.5)
        axes.text(*at, name, fontsize=8.5, weight="bold", color=style.INK, va="top")
    axes.set_aspect("equal", adjustable="datalim")
    axes.autoscale_view()
    return figure


def seen(start: np.ndarray, turns: RigidTurns) -> np.ndarray:
    """(2, n, 3) the start and the shape about their middle, as they are looked at."""
    view = _view(start, turns.axes[np.argmax(turns.angles)] if turns.angles.any() else None)
    pair = np.array([start, turns.end]) @ view
    return np.asarray(pair - (pair.min(axis=(0, 1)) + pair.max(axis=(0, 1))) / 2)


def draw_shape(axes: Axes, pair: np.ndarray, turns: RigidTurns) -> None:
    """A pair as `seen` gives it: the start in grey, the shape in the colours of its pieces."""
    before, after = pair
    grey, *every = to_rgba_array([style.GREY, *style.DOMAIN_COLOURS])
    shade = np.array(every)[turns.piece]
    parts = [_curve(before, np.tile(grey, (len(before), 1))), _curve(after, shade)]
    segments, depths, shades = (np.concatenate(values) for values in zip(*parts, strict=True))
    depths[len(parts[0][1]) :] += NEARER
    order = np.argsort(depths, kind="stable")
    # Each twice, over a wider one in white, for depth: widths take turns.
    paths = [path for k in order for path in 2 * [Path(segments[k])]]
    colours = np.ones((len(paths), 4))
    colours[1::2] = shades[order]
    look: dict[str, Any] = {"linewidths": (2.8, 1.3), "facecolors": "none", "capstyle": "butt"}
    axes.add_collection(PathCollection(paths, edgecolors=colours, **look), autolim=False)
    axes.update_datalim(segments.reshape(-1, 2))
    hinges = np.unique(turns.hinges)
    axes.scatter(after[hinges, 0], after[hinges, 1], s=9, color=style.INK, zorder=3)
    corner = pair.min(axis=(0, 1))[:2] - 2.0
    axes.plot(corner[0] + [0.0, SCALE], [corner[1]] * 2, color=style.INK, lw=1.2)


def _view(start: np.ndarray, axis: np.ndarray | None) -> np.ndarray:
    """Columns: right, up and towards the reader; the last is the axis, or that of least extent."""
    spread = np.linalg.svd(start - start.mean(axis=0), full_matrices=False)[2]
    towards = spread[2] if axis is None else axis
    right = spread[0] - (spread[0] @ towards) * towards
    if np.linalg.norm(right) < 0.1:
        right = spread[1] - (spread[1] @ towards) * towards
    right /= np.linalg.norm(right)
    return np.stack([right, np.cross(towards, right), towards], axis=1)


def _curve(points: np.ndarray, colours: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Pieces (m, p, 2) of a smooth curve through the points, their depths and their colours.

    A piece goes from halfway before a point to the point, or from there to halfway after it.
    """
    halves = np.arange(2 * (len(points) - 1))
    # A little further at both ends, so that no gap shows between one piece and the next.
    pieces = _on_curve(points, halves[:, None] / 2 + np.linspace(-0.03, 0.53, POINTS))
    whole = np.linalg.norm(np.diff(points, axis=0), axis=1)[halves // 2] < LONGEST_STEP
    shades = colours[(halves[whole] + 1) // 2]
    return pieces[whole, :, :2], pieces[whole, :, 2].mean(axis=1), shades


def _on_curve(points: np.ndarray, places: np.ndarray) -> np.ndarray:
    """Points (m, p, 3) of the curve of Catmull and Rom at places (m, p): whole ones are points."""
    first = np.clip(places.astype(int), 0, len(points) - 2)
    t = (places - first)[..., None]
    ends = np.concatenate([2 * points[:1] - points[1:2], points, 2 * points[-1:] - points[-2:-1]])
    a, b, c, d = (ends[first + k] for k in range(4))
    bend = 2 * a - 5 * b + 4 * c - d + (3 * (b - c) + d - a) * t
    return np.asarray(b + t / 2 * (c - a + bend * t))
