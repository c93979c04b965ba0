# SPDX-License-Identifier: MIT
"""The table of figures: which part of the analysis each draws, how, and where on the page."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pliant.base.new_file import new_file
from pliant.measure.pockets.pocket_volumes import PocketVolumes
from pliant.measure.shapes.other_shapes import OtherShapes
from pliant.measure.stages.names import has_backbone
from pliant.measure.stages.parts import (
    Components,
    ContactFrequencies,
    Correlations,
    Distances,
    Gyration,
    Part,
    Residuals,
    Rmsd,
    Sweeps,
    Torsions,
    UnitFlexibility,
    Units,
    UnitsInComponents,
)
from pliant.report.figures import flexibility_figures, mobility, series, torsion_figures
from pliant.report.figures.style import styled
from pliant.report.page.section_titles import (
    CHEMISTRY,
    COLLECTIVE,
    EXACT,
    FLEXIBLE,
    OTHER,
    POCKETS,
    SHAPES,
    TOGETHER,
)
from pliant.report.pockets.pocket_figure import pocket_volume_figure
from pliant.report.shapes.shape_pictures import shape_pictures
from pliant.trajectory.kind import ENSEMBLE, PATH, TRANSITION

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from pliant.measure.stages.analysis import Analysis


@dataclass(frozen=True)
class FigureKind:
    """A row of the table of figures."""

    name: str  #: of the PNG file
    section: str  #: of the page
    draw: Callable[[Analysis], Figure]
    needs: type[Part]  #: what is drawn: without this part there is no figure
    text: str  #: what it shows, for the page
    of_a_path: str = ""  #: what must be said beside that of a path of pushes
    of_an_ensemble: str = ""  #: ... of independent frames
    of_a_transition: str = ""  #: what it shows of a path between structures, if something else
    suits: Callable[[Analysis], bool] = lambda analysis: True  #: whether that part can be drawn

    def caption(self, analysis: Analysis) -> str:
        """What the figure shows of this analysis."""
        if analysis.kind == TRANSITION and self.of_a_transition:
            return self.of_a_transition
        more = {PATH: self.of_a_path, ENSEMBLE: self.of_an_ensemble}.get(analysis.kind, "")
        return f"{self.text} {more}".strip()


FIGURES = (
    FigureKind(
        "flexibility", FLEXIBLE, flexibility_figures.flexibility, UnitFlexibility,
        "Root mean square fluctuation about the average place, after superposition. The band (or "
        "error bar) is twice the error, from blocks of frames. A strip along the axis has the "
        "colours of the domains.",
        "Of this path only: with other pushes, or more of them, the profile would be another.",
        "About 19 of 20 values of a much longer run lie within the band. It is the error of having "
        "few frames; errors of the model that made them are not in it.",
        "Root mean square distance from the average place on the way, after superposition: what "
        "must move to get from one structure to the other. A strip along the axis has the colours "
        "of the domains.",
    ),
    FigureKind(
        "correlations", TOGETHER, flexibility_figures.together, Correlations,
        "Correlation of displacements: 1 moves along with, −1 against, 0 neither, or at right "
        "angles, which this measure cannot tell apart. It depends on what was superposed.",
        "Random pushes move neighbours together; far correlations of one path are chance.",
    ),
    FigureKind(
        "motions", COLLECTIVE, flexibility_figures.motions, UnitsInComponents,
        "How far (one standard deviation) each of the three largest motions moves each residue.",
        "Components of a random path look like slow waves: see the cosine content.",
        suits=lambda analysis: analysis[Units].what == "residue",
    ),
    FigureKind(
        "pca", COLLECTIVE, mobility.principal_components, Components,
        "The frames along the two directions of largest motion, and how much of the motion each "
        "direction explains.",
        "Dark to light as the run goes.",
        "Frames are independent: their even spread was an input, and says nothing about free "
        "energy.",
    ),
    FigureKind(
        "shapes", OTHER, shape_pictures, OtherShapes,
        "The frame that stands for each shape, in colour, superposed by its largest piece (blue) "
        "on the start, in grey. Other colours are pieces that turned against it, dots are hinge "
        "residues; seen along the axis of the largest turn. The bar is 10 Å.",
        suits=lambda analysis: bool(analysis[OtherShapes].shapes),
    ),
    FigureKind(
        "pockets", POCKETS, pocket_volume_figure, PocketVolumes,
        "Room in each pocket, frame by frame. The dashed line is the start, its band the error of "
        "the grid; circles mark the smallest and the largest frame, which are written as PDB "
        "files. A cross is a frame in which the lining has come apart: a gap, which has no volume. "
        "Ligands are taken out before the room is measured.",
        suits=lambda analysis: len(analysis[PocketVolumes].places) > 1,
    ),
    FigureKind(
        "contacts", CHEMISTRY, flexibility_figures.contacts, ContactFrequencies,
        "Residues with heavy atoms within 4.5 Å, more than three apart in the chain. Below the "
        "diagonal those of the start, above it the share of frames that have each.",
        "",
        "What the model holds together at the start is held by construction.",
    ),
    FigureKind(
        "distances", SHAPES, flexibility_figures.distances, Distances,
        "The distances that were asked for, between centres of the atoms selected; dashed: mean.",
    ),
    FigureKind(
        "ramachandran", CHEMISTRY, torsion_figures.ramachandran, Torsions,
        "The backbone angles of all residues in all frames. Inside green: favoured, inside red: "
        "allowed, for residues other than glycine and proline, which the plot has too.",
        suits=lambda analysis: has_backbone(analysis[Torsions].measured.torsions),
    ),
    FigureKind(
        "torsions", SHAPES, torsion_figures.torsions, Torsions,
        "How often each angle was taken: areas are shares of the frames, the red line is the "
        "first frame.",
        "", "How often is a matter of the model, not of energies.",
        suits=torsion_figures.are_few,
    ),
    FigureKind(
        "rmsd", SHAPES, series.rmsd, Rmsd,
        "Root mean square distance of the atoms from the first frame, or the start structure of "
        "an ensemble, after superposition.",
    ),
    FigureKind(
        "radius_of_gyration", SHAPES, series.radius_of_gyration, Gyration,
        "How spread out the molecule is; the band is one standard deviation.",
    ),
    FigureKind(
        "residuals", EXACT, series.residuals, Residuals,
        "How far the worst bar of each frame, and the bars overall, are from their rest "
        "lengths: computed anew from the coordinates in the file.",
    ),
    FigureKind(
        "sweeps", EXACT, series.sweeps, Sweeps,
        "How many sweeps over all bars it took to mend each recorded step.",
    ),
)  # fmt: skip  # a table: a row a line


def figures_of(analysis: Analysis) -> list[FigureKind]:
    """The figures whose parts are there, in the order of the page."""
    return [kind for kind in FIGURES if kind.needs in analysis and kind.suits(analysis)]


def picture_path(kind: FigureKind, folder: Path) -> Path:
    """The PNG of a figure."""
    return folder / f"{kind.name}.png"


def save_figure(kind: FigureKind, analysis: Analysis, folder: Path, dpi: int = 150) -> None:
    """Draws a figure and writes its PNG."""
    with styled():
        _save(kind.draw(analysis), picture_path(kind, folder), dpi)


def _save(figure: Figure, path: Path, dpi: int) -> None:
    """What `savefig` writes, drawn once: it draws all twice, first for the layout alone."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    figure.set_dpi(dpi)
    figure.set_facecolor("white")
    canvas: Any = FigureCanvasAgg(figure)
    with new_file(path, overwrite=True) as file:
        canvas.print_png(file, metadata={"Software": None})
