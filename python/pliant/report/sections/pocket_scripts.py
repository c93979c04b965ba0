# SPDX-License-Identifier: MIT
"""The frames in which each pocket is smallest and largest, as PDB files and in scripts."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from pliant.measure.pockets.pocket_volumes import Pocket, PocketVolumes
from pliant.measure.stages.analysis import Analysis
from pliant.measure.stages.parts import ReferenceStructure
from pliant.report.multi_model import write_models
from pliant.trajectory.superposition import Superposition

ENDS = ("smallest", "largest")


def file_name(number: int, end: str) -> str:
    """Of the PDB file, without .pdb."""
    return f"pocket{number}_{end}"


def write_pocket_frames(analysis: Analysis, folder: Path) -> list[Path]:
    """Writes both frames of each pocket, superposed on the start by the atoms that line it.

    B is 1 in the residues that line it, else 0.
    """
    written = []
    for number, pocket in enumerate(analysis[PocketVolumes].pockets, 1):
        for end in ENDS:
            path = folder / f"{file_name(number, end)}.pdb"
            _write(analysis, pocket, end, path)
            written.append(path)
    return written


def _write(analysis: Analysis, pocket: Pocket, end: str, path: Path) -> None:
    atoms, lining = analysis.atoms, pocket.lining
    place = getattr(pocket, end)
    number = analysis[PocketVolumes].places[place]
    positions, frame = analysis.positions(number), analysis.frames[number]
    start = analysis[ReferenceStructure].positions
    fit = Superposition(start[lining], np.ones(len(lining)))
    moved = fit.apply(positions[atoms.ix], positions[lining])
    lines = np.isin(atoms.resindices, pocket.residues).astype(float)
    volume = f"{pocket.volumes[place]:.0f} Angstrom^3"
    remarks = [
        f"frame {frame}: {pocket.name}, {volume}: {end} of those looked at",
        "B is 1 in the residues that line it",
    ]
    write_models(path, atoms, moved[None], lines, remarks)


def pymol_lines(analysis: Analysis, first: int) -> list[str]:
    """Scenes from F`first` on, one a pocket: its smallest frame in grey, its largest in orange."""
    lines = []
    part = analysis.get(PocketVolumes)
    for number, pocket in enumerate(part.pockets if part else (), 1):
        both = f"pocket{number}_*"
        key = f"F{number + first - 1}"
        lines.append(f"# scene {key}: {pocket.name}, smallest (grey) and largest (orange)")
        for end, colour in zip(ENDS, ("grey70", "orange"), strict=True):
            name = file_name(number, end)
            lines += [f"load {name}.pdb, {name}", f"color {colour}, {name}"]
        lines += [
            f"hide everything, {both}",
            f"show cartoon, {both}",
            f"show sticks, {both} and (b > 0.5 or organic)",
            "disable all",
            f"enable {both}",
            f"zoom {both} and b > 0.5, 4",
            f"scene {key}, store",
        ]
    return lines


def chimerax_lines(analysis: Analysis, first: int) -> list[str]:
    """Models from #`first` on: both frames of each pocket, hidden until they are asked for."""
    lines: list[str] = []
    part = analysis.get(PocketVolumes)
    for number, pocket in enumerate(part.pockets if part else (), 1):
        for k, (end, colour) in enumerate(zip(ENDS, ("gray", "orange"), strict=True)):
            model = f"#{2 * (number - 1) + k + first}"
            lines += [
                f"# show {model} models: {pocket.name}, {end}",
                f"open {file_name(number, end)}.pdb id {model[1:]}",
                f"hide {model} atoms",
                f"show {model}@@bfactor>0.5 atoms",
                f"show {model} & ligand atoms",
                f"color {model} {colour}",
                f"hide {model} models",
            ]
    return lines
