# SPDX-License-Identifier: MIT
"""Torsions of the rotatable bonds: how far each turns, and the Ramachandran plot."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.projections.polar import PolarAxes

from pliant.base import style
from pliant.base.console import Table
from pliant.measure.ramachandran import judged
from pliant.measure.rotatable import Torsion
from pliant.measure.stages.analysis import Analysis
from pliant.measure.stages.names import atom_labels, greek, has_backbone, phi_psi_pairs
from pliant.measure.stages.parts import Measurement
from pliant.measure.torsions import TorsionDistributions
from pliant.report.section import Columns, Fact, Picture, table_of
from pliant.report.sections.headings import CHEMISTRY, SHAPES
from pliant.report.sections.measured import Measured, caption, has

#: a table of more torsion angles than this is not written
MAX_ANGLES = 250_000
#: roses drawn at most; tables have all torsions
ROSES = 12
#: of a molecule with more torsions none are drawn: the most mobile are side chains at its surface
MOST_TORSIONS = 100


@dataclass(frozen=True)
class Torsions(Measurement):
    """Angles of the rotatable bonds."""

    measured: TorsionDistributions


def _measure(analysis: Analysis) -> Iterator[Torsions]:
    """Of bars, where the file has no bonds."""
    source, bonds = analysis.source, None
    if not hasattr(analysis.universe, "bonds"):
        if source.joints_of_whole:
            raise ValueError("there are no bonds among the recorded atoms")
        bonds = source.bars if len(source.bars) else None
    measured = TorsionDistributions(analysis.atoms, bonds=bonds, heavy_only=True)
    if not measured.torsions:
        raise ValueError("no bond is rotatable: each is in a ring or at an end of the molecule")
    size = analysis.run(measured).angles.size
    notes = []
    if bonds is not None:
        notes.append("the file has no bonds: torsions are those of its bars")
    if size > MAX_ANGLES:
        notes.append(f"the table torsion_angles.csv is left out: {size:,} numbers")
    yield Torsions(measured, notes=tuple(notes))


def _per_torsion(analysis: Analysis) -> Columns:
    torsions, found = analysis[Torsions].measured.torsions, analysis[Torsions].found
    atoms = np.array([t.atoms for t in torsions])
    names = atom_labels(analysis.universe.atoms)
    return {
        "torsion": [t.label for t in torsions],
        "kind": [t.kind for t in torsions],
        **dict(zip("ijkl", atoms.T, strict=True)),
        "bond": [f"{names[t.atoms[1]]} – {names[t.atoms[2]]}" for t in torsions],
        "mean_degrees": found.mean,
        "spread_degrees": found.spread,
    }


def _histograms(analysis: Analysis) -> Columns:
    """One row per bin, one column per torsion: share of the frames per degree."""
    part = analysis[Torsions]
    edges = part.found.edges
    columns: Columns = {"from_degrees": edges[:-1], "to_degrees": edges[1:]}
    return columns | _one_column_each(part.measured.torsions, part.found.density)


def _angles(analysis: Analysis) -> Columns:
    """One row per frame, one column per torsion, degrees; none if that were too many numbers."""
    part = analysis[Torsions]
    if part.found.angles.size > MAX_ANGLES:
        return {}
    columns: Columns = {"frame": analysis.frames}
    return columns | _one_column_each(part.measured.torsions, part.found.angles.T)


def _one_column_each(torsions: Sequence[Torsion], rows: np.ndarray) -> Columns:
    """Columns by label; where a label occurs twice the atoms are added."""
    labels = [t.label for t in torsions]
    if len(set(labels)) < len(labels):
        labels = [f"{t.label} ({'-'.join(map(str, t.atoms))})" for t in torsions]
    return dict(zip(labels, rows, strict=True))


def _tables(analysis: Analysis) -> Iterator[Table]:
    spread = analysis[Torsions].found.spread
    degrees = "{:.0f}°".format
    shown = {
        "torsion": ("torsion", greek),
        "mean_degrees": ("circular mean", degrees),
        "spread_degrees": ("spread", degrees),
    }
    rows = np.argsort(-spread, kind="stable")[:8]
    yield table_of("Most mobile torsions", _per_torsion(analysis), shown, rows)


def _draw_roses(analysis: Analysis) -> Figure:
    """A rose (circular histogram) for each of the most mobile torsions, in their own order."""
    measured = analysis[Torsions].measured
    chosen = np.sort(np.argsort(-measured.results.spread, kind="stable")[:ROSES])
    columns = min(3, len(chosen))
    rows = -(-len(chosen) // columns)
    polar = {"squeeze": False, "subplot_kw": {"projection": "polar"}}
    figure, axes = style.new_figure((style.WIDE[0], 2.1 * rows + 0.4), rows, columns, **polar)
    for place, rose in enumerate(axes.flat):
        if place < len(chosen):
            _draw_rose(rose, measured, chosen[place])
        else:
            rose.set_visible(False)
    style.pad(figure, 0.12)
    total = len(measured.torsions)
    shown = "" if len(chosen) == total else f": the {len(chosen)} most mobile of {total}"
    title = f"Torsions of rotatable bonds{shown}"
    figure.suptitle(title, x=0.01, ha="left", fontsize=10.5, fontweight="bold")
    return figure


def _draw_rose(axes: PolarAxes, torsions: TorsionDistributions, k: int) -> None:
    """Areas are proportional to the share of frames, hence radii to its root."""
    found = torsions.results
    width = np.radians(found.edges[1] - found.edges[0])
    share = found.density[k] * (found.edges[1] - found.edges[0])
    centres = np.radians(0.5 * (found.edges[:-1] + found.edges[1:]))
    axes.set_theta_zero_location("N")
    axes.set_theta_direction(-1)
    axes.bar(centres, np.sqrt(share), width=width, color=style.BLUE, alpha=0.85, linewidth=0)
    top = np.sqrt(share.max()) * 1.02
    start = np.radians(found.angles[0, k])
    axes.plot([start, start], [0, top], color=style.VERMILION, lw=1.4)
    axes.set_ylim(0, top)
    axes.set_yticks([])
    axes.set_xticks(np.radians([0, 90, 180, 270]), ["0°", "90°", "180°", "−90°"], fontsize=7.5)
    axes.tick_params(pad=-1, colors=style.GREY)
    axes.spines["polar"].set_color(style.GREY)
    axes.spines["polar"].set_linewidth(0.6)
    label = greek(torsions.torsions[k].label)
    axes.set_title(label, fontsize=8.5, fontweight="normal", loc="center", pad=7)


def _draw_ramachandran(analysis: Analysis) -> Figure:
    """All phi, psi of a protein in all frames, and where the first frame has them."""
    torsions = analysis[Torsions].measured
    phi, psi = phi_psi_pairs(torsions.torsions)
    angles = torsions.results.angles
    figure, axes = style.new_figure((4.7, 4.1))
    pairs, ends = (angles[:, phi].ravel(), angles[:, psi].ravel()), [[-180, 180]] * 2
    counts, *_ = np.histogram2d(*pairs, bins=72, range=ends)
    shares = np.ma.masked_equal(counts.T / counts.sum() / 25.0 * 1e4, 0)
    squares: dict[str, Any] = {
        "origin": "lower",
        "extent": 2 * (-180, 180),
        "interpolation": "nearest",
    }
    image = axes.imshow(shares, cmap=style.MAP + "_r", **squares)
    middle = np.linspace(-180, 180, 361)[:-1] + 0.5
    regions = {"levels": [0.5, 1.5], "colors": [style.VERMILION, style.GREEN], "linewidths": 0.8}
    axes.contour(middle, middle, judged(*np.meshgrid(middle, middle)), **regions)
    ring = {"s": 7, "facecolors": "none", "edgecolors": style.INK, "linewidths": 0.5}
    axes.scatter(angles[0, phi], angles[0, psi], label="first frame", **ring)
    axes.set(xlabel="φ (degrees)", ylabel="ψ (degrees)", title="Ramachandran plot", aspect="equal")
    axes.set_xticks(range(-180, 181, 60))
    axes.set_yticks(range(-180, 181, 60))
    axes.legend(loc="lower right", bbox_to_anchor=(1, 1.01))
    style.colour_bar(axes, image, "share (10⁻⁴ per square degree)")
    return figure


TORSIONS = Measured(
    stage="torsions",
    measure=_measure,
    heading=SHAPES,
    applies=has(Torsions),
    values=lambda analysis: {"rotatable_bonds": len(analysis[Torsions].measured.torsions)},
    facts=lambda analysis: [
        Fact(str(len(analysis[Torsions].measured.torsions)), "", "rotatable bonds")
    ],
    tables=_tables,
    columns={
        "torsions": _per_torsion,
        "torsion_histograms": _histograms,
        "torsion_angles": _angles,
    },
    pictures=[
        Picture(
            "torsions",
            _draw_roses,
            caption(
                "How often each angle was taken: areas are shares of the frames, the red line is "
                "the first frame.",
                ensemble="How often is a matter of the model, not of energies.",
            ),
            suits=lambda analysis: len(analysis[Torsions].measured.torsions) <= MOST_TORSIONS,
        )
    ],
    methods={
        "Torsions": (
            "A bond is rotatable when it is in no ring and both ends have another neighbour. Mean "
            "and spread are circular; beyond 180° it means that all angles are equally likely."
        )
    },
)

RAMACHANDRAN = Measured(
    heading=CHEMISTRY,
    applies=lambda analysis: (
        Torsions in analysis and has_backbone(analysis[Torsions].measured.torsions)
    ),
    pictures=[
        Picture(
            "ramachandran",
            _draw_ramachandran,
            "The backbone angles of all residues in all frames. Inside green: favoured, inside "
            "red: allowed, for residues other than glycine and proline, which the plot has too.",
        )
    ],
)
