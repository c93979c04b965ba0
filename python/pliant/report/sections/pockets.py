# SPDX-License-Identifier: MIT
"""How much room the pockets of a molecule have in each frame."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pliant.base import style
from pliant.base.console import Table
from pliant.measure.pockets.pocket_volumes import (
    LEAST_VOLUME,
    Pocket,
    PocketVolumes,
    pocket_volumes,
)
from pliant.measure.stages.analysis import Analysis
from pliant.measure.stages.names import chains_of
from pliant.report.section import Columns, Picture, Values
from pliant.report.sections.frames import drawn_by
from pliant.report.sections.headings import POCKETS
from pliant.report.sections.measured import Measured, has
from pliant.report.sections.other_shapes import residues_text
from pliant.report.sections.pocket_scripts import write_pocket_frames
from pliant.trajectory.kind import ENSEMBLE

COLUMNS = (
    *("pocket", "at the start (Å³), ± error of the grid", "smallest, frame", "largest, frame"),
    *("frames with a gap instead", "lined by"),
)
CAPTION = (
    "Volumes come from geometry alone. A frame in which a pocket is open shows that it can open, "
    f"not how often it does. A pocket that opens has less than {LEAST_VOLUME:g} Å³ at the start, "
    "one that widens is open there. Where the lining has come apart there is a gap, and no volume."
)
DOTS: dict[str, Any] = {"lw": 0, "marker": "o", "ms": 3.5, "mew": 0}
CROSSES: dict[str, Any] = {"lw": 0, "marker": "x", "ms": 4, "color": style.GREY, "clip_on": False}


def _frame(analysis: Analysis, place: int) -> int:
    """The number in the file of a frame looked at."""
    return int(analysis.frames[analysis[PocketVolumes].places[place]])


def _lined_by(analysis: Analysis, pocket: Pocket) -> str:
    """Names of the residues, each chain named once."""
    residues = analysis.universe.residues[pocket.residues]
    chains = chains_of(residues)
    names = [f"{one.resname}{one.resid}" for one in residues]
    if len(set(chains_of(analysis.universe.residues))) == 1:
        return " ".join(names)
    return "; ".join(
        f"{chain}: {' '.join(n for n, own in zip(names, chains, strict=True) if own == chain)}"
        for chain in dict.fromkeys(chains.tolist())
    )


def _tables(analysis: Analysis) -> Iterator[Table]:
    rows = [
        (
            pocket.name,
            f"{pocket.at_start:.0f} ± {pocket.error:.0f}",
            *(
                f"{pocket.volumes[place]:.0f}, {_frame(analysis, place)}"
                for place in (pocket.smallest, pocket.largest)
            ),
            f"{np.count_nonzero(pocket.is_gap)}",
            _lined_by(analysis, pocket),
        )
        for pocket in analysis[PocketVolumes].pockets
    ]
    yield Table(CAPTION, COLUMNS, rows)


def _lines(analysis: Analysis) -> Iterator[tuple[str, str]]:
    """The first pocket."""
    part = analysis[PocketVolumes]
    first, *others = part.pockets
    low, high = first.volumes[first.smallest], first.volumes[first.largest]
    gaps = int(np.count_nonzero(first.is_gap))
    start = f"{first.name}: {first.at_start:.0f} Å³ at the start (grid error ± {first.error:.0f})"
    frames = f"{low:.0f} to {high:.0f} in {len(part.places) - gaps} frames"
    gap = f", a gap in {gaps}" if gaps else ""
    more = f"; {len(others)} more in the report" if others else ""
    yield "pockets", f"{start}, {frames}{gap}{more}"


def _columns(analysis: Analysis) -> Columns:
    """One row per frame looked at, Angstrom^3; empty where there is a gap."""
    part = analysis[PocketVolumes]
    columns: Columns = {"frame": analysis.frames[part.places], **drawn_by(analysis, part.places)}
    for pocket in part.pockets:
        volumes = np.round(pocket.volumes).astype(int).tolist()
        columns[f"{pocket.name} (angstrom3)"] = [
            "" if gap else volume for volume, gap in zip(volumes, pocket.is_gap, strict=True)
        ]
    return columns


def _values(analysis: Analysis) -> Values:
    def at(pocket: Pocket, place: int) -> Values:
        return {"frame": _frame(analysis, place), "volume": float(pocket.volumes[place])}

    part = analysis[PocketVolumes]
    found = [
        {
            "name": pocket.name,
            "at_start": pocket.at_start,
            "error": pocket.error,
            "mean": pocket.mean,
            "gaps": int(np.count_nonzero(pocket.is_gap)),
            "smallest": at(pocket, pocket.smallest),
            "largest": at(pocket, pocket.largest),
            "residues": residues_text(analysis, pocket.residues).split(),
        }
        for pocket in part.pockets
    ]
    return {"pockets": {"frames": len(part.places), "volumes": found}}


def _draw(analysis: Analysis) -> Figure:
    """One panel a pocket: frames around the start and others, and the start's volume as a line."""
    part, (x, label) = analysis[PocketVolumes], analysis.axis
    count, x = len(part.pockets), x[part.places]
    size = (style.WIDE[0], 0.5 + 1.25 * count)
    figure, axes = style.new_figure(size, count, 1, sharex=True, squeeze=False)
    named: dict[str, Artist] = {}
    for panel, pocket in zip(axes[:, 0], part.pockets, strict=True):
        _draw_pocket(panel, pocket, x, analysis)
        handles, names = panel.get_legend_handles_labels()
        named |= dict(zip(names, handles, strict=True))
    axes[-1, 0].set_xlabel(label)
    style.legend_above(axes[0, 0], named.values(), named)
    return figure


def _draw_pocket(panel: Axes, pocket: Pocket, x: np.ndarray, analysis: Analysis) -> None:
    start, error, gap, volumes = pocket.at_start, pocket.error, pocket.is_gap, pocket.volumes
    panel.axhspan(start - error, start + error, color=style.FAINT, lw=0)
    panel.axhline(start, color=style.INK, lw=1.1, ls=(0, (5, 3)), label="start")
    panel.set(ylabel="Å³", title=pocket.name)
    panel.set_ylim(0, 1.12 * max(volumes[pocket.largest], start + error, 1.0))
    if analysis.kind == ENSEMBLE:
        reaches, places = analysis.reaches, analysis[PocketVolumes].places
        far = np.zeros(len(x), bool) if reaches is None else reaches[places]
        _draw_some(panel, x, volumes, ~far & ~gap, "around the start", DOTS | {"color": style.BLUE})
        _draw_some(panel, x, volumes, far & ~gap, "further from it", DOTS | {"color": style.ORANGE})
    else:
        panel.plot(x, np.where(gap, np.nan, volumes), color=style.BLUE)
    _draw_some(panel, x, 0 * x, gap, "a gap", CROSSES)
    ends = [pocket.smallest, pocket.largest]
    panel.plot(x[ends], volumes[ends], lw=0, marker="o", ms=8, mfc="none", mec=style.INK)


def _draw_some(
    panel: Axes, x: np.ndarray, y: np.ndarray, some: np.ndarray, label: str, style: dict[str, Any]
) -> None:
    if some.any():
        panel.plot(x[some], y[some], label=label, **style)


POCKET_VOLUMES = Measured(
    stage="pockets",
    measure=pocket_volumes,
    heading=POCKETS,
    applies=has(PocketVolumes),
    values=_values,
    lines=_lines,
    tables=_tables,
    columns={"pockets": _columns},
    files=write_pocket_frames,
    pictures=[
        Picture(
            "pockets",
            _draw,
            "Room in each pocket, frame by frame. The dashed line is the start, its band the error "
            "of the grid; circles mark the smallest and the largest frame, which are written as "
            "PDB files. A cross is a frame in which the lining has come apart: a gap, which has no "
            "volume. Ligands are taken out before the room is measured.",
            suits=lambda analysis: len(analysis[PocketVolumes].places) > 1,
        )
    ],
    methods={
        "Pocket volumes": (
            "Room for a sphere of 1.4 Å that touches no atom, within the convex hull of the heavy "
            "atoms that line the pocket, on a 1 Å grid, where it is enclosed: at least half of all "
            "directions meet an atom within 8 Å (Halgren 2009). The atoms are within 4.5 Å of a "
            "ligand, or nearest to a pocket of the start (or of a frame where one grows), the same "
            "in all frames. Ligands and water are taken out. The error is the r.m.s. difference "
            "from a grid of 0.5 Å. Where less than half as much of the room is enclosed as at the "
            "start, the lining has come apart: that frame has a gap, and no volume. A pocket opens "
            "if it grows by 100 Å³ from less than 100 Å³ at the start, hardly room for a benzene; "
            "it widens if it was open. Up to 100 frames are measured."
        )
    },
)
