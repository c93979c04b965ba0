# SPDX-License-Identifier: MIT
"""The picture of how data flows through the folders of the library."""

from pathlib import Path

import matplotlib.pyplot as plt
from matplotlib.patches import FancyArrowPatch, FancyBboxPatch

INK, BLUE, PALE, GREY = "#22313f", "#0072b2", "#e8f1f8", "#5f6b76"
HEIGHT = 0.62

# Each box: folder, what it does there, x, y, width. Data flows from left to right.
FLOW = [
    ("molecule", "files to structures,\nstructures to frameworks", 0.0, 2.0, 2.3),
    ("generate", "random graphs", 0.0, 1.0, 2.3),
    ("framework", "joints, bars, limits;\nwhat is broken", 2.9, 1.5, 2.0),
    ("perturb", "pushes", 5.6, 2.0, 1.8),
    ("resolve", "makes bars whole", 5.6, 1.0, 1.8),
    ("record", "H5MD, PDB, XML", 8.3, 1.5, 2.0),
]
BELOW = [
    ("order", "sequences of bars", 3.6, 0.0, 1.8),
    ("rigidity", "rigid units", 5.6, 0.0, 1.8),
    ("base, text", "vectors, graphs, random numbers, errors; text of files", 0.0, -1.0, 10.3),
]
ARROWS = [
    ((2.3, 2.31), (2.9, 1.95)),
    ((2.3, 1.31), (2.9, 1.67)),
    ((4.9, 1.95), (5.6, 2.31)),
    ((6.1, 2.0), (6.1, 1.62)),
    ((6.9, 1.62), (6.9, 2.0)),
    ((7.4, 1.31), (8.3, 1.67)),
    ((4.7, 0.62), (5.6, 1.1)),
    ((6.5, 0.62), (6.5, 1.0)),
]


def draw_box(axes: plt.Axes, name: str, what: str, x: float, y: float, width: float) -> None:
    """One folder with its name and what it does."""
    style = "round,pad=0.02,rounding_size=0.08"
    axes.add_patch(FancyBboxPatch((x, y), width, HEIGHT, style, facecolor=PALE, edgecolor=BLUE))
    middle = x + width / 2
    axes.text(middle, y + HEIGHT * 0.72, name, ha="center", va="center", color=INK, weight="bold")
    axes.text(middle, y + HEIGHT * 0.3, what, ha="center", va="center", color=GREY, fontsize=7.5)


def draw_loop(axes: plt.Axes) -> None:
    """The frame around the loop of a run."""
    style = "round,pad=0.02,rounding_size=0.12"
    frame = FancyBboxPatch(
        (5.35, 0.82), 2.3, 2.28, style, facecolor="none", edgecolor=GREY, linestyle="--"
    )
    axes.add_patch(frame)
    axes.text(6.5, 2.88, "run: Motion, step after step", ha="center", color=GREY, fontsize=8)


def make_structure_picture(path: Path) -> None:
    """Draws the folders of the library as boxes, and arrows along which data flows."""
    figure = plt.figure(figsize=(10.4, 4.4), dpi=110)
    axes = figure.add_axes([0.01, 0.02, 0.98, 0.96])
    for row in FLOW + BELOW:
        draw_box(axes, *row)
    draw_loop(axes)
    for start, end in ARROWS:
        arrow = FancyArrowPatch(start, end, arrowstyle="-|>", mutation_scale=12, color=INK)
        axes.add_patch(arrow)
    axes.set_xlim(-0.15, 10.45)
    axes.set_ylim(-1.15, 3.25)
    axes.set_axis_off()
    figure.savefig(path)
    plt.close(figure)


if __name__ == "__main__":
    make_structure_picture(Path(__file__).parent / "pictures" / "structure.png")
