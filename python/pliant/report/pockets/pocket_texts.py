# SPDX-License-Identifier: MIT
"""The volumes of pockets as rows of a table, columns, a line and JSON."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from pliant.measure.pockets.pocket_volumes import LEAST_VOLUME, Pocket, PocketVolumes
from pliant.measure.stages.names import chains_of
from pliant.report.shapes.shape_texts import residues_text
from pliant.trajectory.drawn_by import DRAWN_BY

if TYPE_CHECKING:
    from pliant.measure.stages.analysis import Analysis

HEADERS = (
    *("pocket", "at the start (Å³)", "smallest, frame", "largest, frame"),
    *("frames with a gap instead", "lined by"),
)
CAPTION = (
    "Volumes come from geometry alone. A frame in which a pocket is open shows that it can open, "
    f"not how often it does. A pocket that opens has less than {LEAST_VOLUME:g} Å³ at the start, "
    "one that widens is open there. Where the lining has come apart there is a gap, and no volume."
)


def frame_of(analysis: Analysis, place: int) -> int:
    """The number in the file of a frame looked at."""
    return int(analysis.frames[analysis[PocketVolumes].places[place]])


def lined_by(analysis: Analysis, pocket: Pocket) -> str:
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


def pocket_table_rows(analysis: Analysis) -> list[Sequence[str]]:
    """Rows of the page."""

    def at(pocket: Pocket, place: int) -> str:
        return f"{pocket.volumes[place]:.0f}, {frame_of(analysis, place)}"

    return [
        (
            pocket.name,
            f"{pocket.at_start:.0f} ± {pocket.error:.0f}",
            at(pocket, pocket.smallest),
            at(pocket, pocket.largest),
            f"{np.count_nonzero(pocket.is_gap)}",
            lined_by(analysis, pocket),
        )
        for pocket in analysis[PocketVolumes].pockets
    ]


def pocket_line(found: dict[str, Any]) -> str:
    """The first pocket in one line, from its JSON."""
    first, *others = found["volumes"]
    low, high = first["smallest"]["volume"], first["largest"]["volume"]
    gaps = f", a gap in {first['gaps']}" if first["gaps"] else ""
    more = f"; {len(others)} more in the report" if others else ""
    return (
        f"{first['name']}: {first['at_start']:.0f} ± {first['error']:.0f} Å³ at the start, "
        f"{low:.0f} to {high:.0f} in {found['frames'] - first['gaps']} frames{gaps}{more}"
    )


def volume_columns(analysis: Analysis) -> dict[str, Any]:
    """One row per frame looked at, Angstrom^3; empty where there is a gap."""
    part = analysis[PocketVolumes]
    columns: dict[str, Any] = {"frame": analysis.frames[part.places]}
    drawn_by = analysis.observable("sampler")
    if drawn_by is not None and drawn_by.any():
        columns["drawn_by"] = [DRAWN_BY[value] for value in drawn_by[part.places]]
    for pocket in part.pockets:
        volumes = np.round(pocket.volumes).astype(int).tolist()
        columns[f"{pocket.name} (angstrom3)"] = [
            "" if gap else volume for volume, gap in zip(volumes, pocket.is_gap, strict=True)
        ]
    return columns


def pockets_json(analysis: Analysis) -> dict[str, Any]:
    """JSON-ready values."""

    def at(pocket: Pocket, place: int) -> dict[str, Any]:
        return {"frame": frame_of(analysis, place), "volume": float(pocket.volumes[place])}

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
