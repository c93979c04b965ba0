# SPDX-License-Identifier: MIT
"""One heat map a claim: where in the sweep of settings it holds."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.image import AxesImage

from pliant.base import style
from pliant.lab.experiment.claims import CLAIMS, Claim
from pliant.lab.experiment.document import Figure
from pliant.lab.experiment.settings import Settings
from pliant.lab.experiment.sweep import BOXES, FORCES, SIZES, TOLERANCES, Point

WORDS = {"sweeps": "sweeps", "passes": "passes", "projections": "work"}


Axis = tuple[str, list[Any], list[str], Callable[[Point], object]]


def axes_of(start: Settings, points: list[Point]) -> list[Axis]:
    """Label, values, their texts, and the value of a point, None if it is of another axis."""
    usual = {
        "force": start.force,
        "size": (start.depth, start.children, start.ring),
        "box": start.box,
        "consecutive": start.consecutive,
    }
    small = usual | {"size": SIZES[0], "consecutive": True}

    def along(name: str, fixed: dict[str, object] = usual) -> Callable[[Point], object]:
        others = [(key, value) for key, value in fixed.items() if key != name]
        return lambda p: (
            getattr(p, name) if all(getattr(p, key) == value for key, value in others) else None
        )

    joints = {p.size: p.joints for p in points}
    forces = [f"{100 * force * start.timestep**2:g}" for force in FORCES]
    return [
        ("push (Å)", list(FORCES), forces, along("force")),
        (
            "joints, mean",
            list(SIZES),
            [f"{joints.get(key, 0):.0f}" for key in SIZES],
            along("size"),
        ),
        ("box (Å)", list(BOXES), [f"{box:g}" for box in BOXES], along("box")),
        ("pushes act", [False, True], ["from\nrest", "in\nturn"], along("consecutive")),
        ("push (Å), few joints, in turn", list(FORCES), forces, along("force", small)),
    ]


def shares(
    points: list[Point], values: list[Any], value_of: Callable[[Point], object]
) -> np.ndarray:
    """(values, tolerances) share of the statements that hold; negative where there are none."""
    grid = np.full((len(values), len(TOLERANCES)), -1.0)
    for point in points:
        value = value_of(point)
        if value in values and point.statements > 0:
            place = values.index(value), TOLERANCES.index(point.tolerance_length)
            grid[place] = point.holding / point.statements
    return grid


def draw_claim(claim: Claim, points: list[Point], start: Settings, folder: Path) -> Figure:
    """Tolerance across; what else was varied up; one row of panels a yardstick."""
    rows = claim.yardsticks
    with style.figure(len(rows), 5, panel=(2.3, 2.5)) as (figure, axes):
        for panels, yardstick in zip(axes, rows, strict=True):
            mine = [p for p in points if (p.claim, p.yardstick) == (claim.id, yardstick)]
            for axis, (label, values, texts, value_of) in zip(
                panels, axes_of(start, mine), strict=True
            ):
                image = _draw_grid(axis, shares(mine, values, value_of), texts)
                axis.set_ylabel(label)
                axis.set_xlabel("tolerance ($10^x$ Å), x")
            panels[0].set_title(f"{claim.id}, counted in {WORDS[yardstick]}")
        bar = figure.colorbar(image, ax=axes, shrink=0.8, pad=0.01, ticks=(0, 0.5, 1))
        bar.set_label("share of its statements that hold")
        path = folder / f"claim-{claim.id}.png"
        style.save(figure, path)
    return Figure(
        path, f"{claim.id}: {claim.text}. A dot: every statement holds; empty: no push broke a bar."
    )


def _draw_grid(axis: Axes, grid: np.ndarray, texts: list[str]) -> AxesImage:
    shown = np.ma.masked_less(grid, 0.0)
    image = axis.imshow(shown, cmap=style.MAP, vmin=0.0, vmax=1.0, aspect="auto", origin="lower")
    for row, column in np.argwhere(grid == 1.0):
        axis.plot(column, row, "o", color="black", markersize=4)
    exponents = [f"{np.log10(tolerance):.0f}" for tolerance in TOLERANCES]
    axis.set_xticks(range(len(TOLERANCES)), exponents)
    axis.set_yticks(range(len(texts)), texts)
    axis.grid(visible=False)
    return image


def draw_maps(points: list[Point], start: Settings, folder: Path) -> dict[str, Figure]:
    """The heat map of every claim, by its id."""
    folder.mkdir(parents=True, exist_ok=True)
    return {claim.id: draw_claim(claim, points, start, folder) for claim in CLAIMS}
