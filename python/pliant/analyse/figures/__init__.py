# SPDX-License-Identifier: MIT
"""One function a figure, and the table that says which figures a study gives."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from pliant.analyse.figures import mobility, series, torsion_figures
from pliant.analyse.figures.style import styled
from pliant.analyse.names import has_backbone

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from pliant.analyse.study import Study


@dataclass(frozen=True)
class FigureKind:
    """A row of the table of figures."""

    name: str  #: of the PNG file
    draw: Callable[[Study], Figure]
    applies: Callable[[Study], bool]  #: of a study: has what is drawn
    caption: str  #: what it shows, for the page


def _has(*attributes: str) -> Callable[[Study], bool]:
    return lambda study: all(getattr(study, name) is not None for name in attributes)


FIGURES = (
    FigureKind(
        "residuals", series.residuals, _has("residuals"),
        "How far the worst bar of each frame, and the bars on the whole, are from their rest "
        "lengths: computed anew from the coordinates in the file.",
    ),
    FigureKind(
        "sweeps", series.sweeps, lambda study: study.observable("sweeps") is not None,
        "How many sweeps over all bars it took to mend each recorded step.",
    ),
    FigureKind(
        "rmsd", series.rmsd, _has("rmsd"),
        "Root mean square distance of the atoms from the first frame, after superposition.",
    ),
    FigureKind(
        "radius_of_gyration", series.radius_of_gyration, _has("radius"),
        "How spread out the molecule is; the band is one standard deviation.",
    ),
    FigureKind(
        "rmsf_residues", mobility.rmsf_residues,
        lambda study: study.rmsf is not None and len(study.rmsf.results.residues) > 1,
        "Root mean square fluctuation of the atoms of each residue about their average place.",
    ),
    FigureKind(
        "rmsf_atoms", mobility.rmsf_atoms, _has("rmsf"),
        "Root mean square fluctuation of each atom about its average place.",
    ),
    FigureKind(
        "torsions", torsion_figures.torsions, _has("torsions"),
        "How often each angle was taken: areas are shares of the frames, the red line is the "
        "first frame.",
    ),
    FigureKind(
        "ramachandran", torsion_figures.ramachandran,
        lambda study: study.torsions is not None and has_backbone(study.torsions.torsions),
        "The backbone angles of all residues in all frames.",
    ),
    FigureKind(
        "pca", mobility.principal_components, _has("pca"),
        "The frames along the two directions of largest motion, from dark to light as the run "
        "goes, and how much of the motion each direction explains.",
    ),
)  # fmt: skip


def save_figures(study: Study, folder: Path, dpi: int = 200) -> list[tuple[FigureKind, Path]]:
    """Writes the PNG of each figure that the study gives; returns [(FigureKind, path)]."""
    written = []
    with styled():
        for kind in FIGURES:
            if not kind.applies(study):
                continue
            path = folder / f"{kind.name}.png"
            kind.draw(study).savefig(path, dpi=dpi, metadata={"Software": None})
            written.append((kind, path))
    return written
