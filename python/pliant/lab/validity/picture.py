# SPDX-License-Identifier: MIT
"""The table of validity drawn: profiles beside experiment and MD, overlaps beside ANM's."""

from __future__ import annotations

import math
import os
from typing import TYPE_CHECKING, Any

import numpy as np

from pliant._core import InputError
from pliant.base.style import BLUE, DASHED, GREY, VERMILION, figure, save
from pliant.lab.validity.rows import TUNED, Row, Validity

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Title and name of the reference.
PROFILES = {
    "ubiquitin": ("ubiquitin: which residues move", "NMR (2K39)"),
    "HIV-PR": ("HIV-1 protease: which residues move", "MD"),
}
OVERLAP = "cumulative overlap of 10"
#: One motion measured twice, from other files of the same two states: the row of the pair is not
#: drawn where the kinase has its own.
SAME_MOTION = {
    "P69441, 4AKE_A to 1AKE_A": "AdK, open to closed",
    "P69441, 1AKE_A to 4AKE_A": "AdK, closed to open",
}


def draw(found: Validity, path: str | os.PathLike[str]) -> None:
    """Writes a PNG. Raises InputError where there is nothing to draw."""
    systems = [name for name in PROFILES if name in found.profiles]
    overlaps = motions_of(found.rows)
    count = len(systems) + bool(overlaps)
    if count == 0:
        raise InputError("--output: no row that the picture shows was measured")
    with figure(1, count, panel=(4.6, 3.4)) as (plot, axes):
        for name, panel in zip(systems, axes[0], strict=False):
            _profiles(panel, found, name)
        if overlaps:
            _overlaps(axes[0][-1], overlaps)
        save(plot, path)


def motions_of(rows: list[Row]) -> list[Row]:
    """The overlaps that were measured, one for each known motion."""
    overlaps = [row for row in rows if row.figure == OVERLAP and math.isfinite(row.ours)]
    names = {row.system for row in overlaps}
    return [row for row in overlaps if SAME_MOTION.get(row.system) not in names]


def _profiles(axes: Axes, found: Validity, name: str) -> None:
    """RMSF over its mean: how far an ensemble goes is an input. Ends that all have are left out."""
    title, reference = PROFILES[name]
    profiles = {key: np.array(values) for key, values in found.profiles[name].items()}
    residues = np.arange(1, len(profiles["reference"]) + 1)
    styles: dict[str, tuple[str, dict[str, Any]]] = {
        "reference": (reference, {"color": "black", "linewidth": 1.3}),
        "anm": ("ANM", {"color": VERMILION, "linestyle": DASHED, "linewidth": 1.2}),
        "ours": ("Pliant", {"color": BLUE}),
    }
    for key, (label, style) in styles.items():
        r = "" if key == "reference" else f", r = {_r(found, name, key):.2f}"
        axes.plot(residues, profiles[key] / profiles[key].mean(), label=label + r, **style)
    axes.set(title=title, xlabel="residue", ylabel="RMSF / its mean", ylim=(0, None))
    look = {"columnspacing": 1.0, "handlelength": 1.4, "bbox_to_anchor": (0.5, -0.16)}
    axes.legend(frameon=False, ncols=3, loc="upper center", **look)


def _r(found: Validity, name: str, key: str) -> float:
    """Of what is drawn: where ends are left out, the row of residues superposed on these alone."""
    rows = [r for r in found.rows if r.system == name and r.figure.startswith("r of RMSF")]
    row = max(rows, key=lambda r: "alone" in r.figure)
    return row.ours if key == "ours" else row.anm


def _overlaps(axes: Axes, rows: list[Row]) -> None:
    """Each direction a line from ANM's overlap to ours."""
    rows = sorted(rows, key=lambda row: row.ours)
    places = np.arange(len(rows))
    ours, anm = ([getattr(row, name) for row in rows] for name in ("ours", "anm"))
    axes.hlines(places, anm, ours, color=GREY)
    axes.plot(anm, places, "o", color=VERMILION, label="ANM", markersize=5)
    xerr = [row.error for row in rows]
    axes.errorbar(ours, places, xerr=xerr, fmt="o", color=BLUE, label="Pliant", markersize=5)
    axes.set_yticks(places, [_short(row) for row in rows])
    axes.tick_params(axis="y", labelsize=8)
    axes.set(
        title="known motions",
        ylim=(-0.7, len(rows) - 0.3),
        xlabel="cumulative overlap with ten modes (* tuned on)",
    )
    axes.legend(frameon=False, ncols=2, loc="upper center", bbox_to_anchor=(0.5, -0.16))


def _short(row: Row) -> str:
    name = row.system if row.system.startswith("AdK") else row.system.partition(", ")[2]
    return name.replace(" to ", " → ") + (" *" if row.data == TUNED else "")
