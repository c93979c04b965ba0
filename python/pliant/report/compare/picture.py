# SPDX-License-Identifier: MIT
"""The comparison as pictures: fluctuations, modes and bars on one, torsions on another."""

from __future__ import annotations

import pathlib
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.ticker import MaxNLocator

from pliant.base.plotting import BLUE, VERMILION, figure, save
from pliant.report.compare.residue_picture import draw_matrix, draw_residues

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from pliant.report.compare.comparison_report import (
        AtomComparison,
        ComparisonReport,
        Fluctuations,
        TorsionComparison,
    )

MOST_TORSIONS = 24  #: panels; those that differ most are drawn
MOST_NAMES = 30  #: labels on an axis


def draw(report: ComparisonReport, folder: pathlib.Path) -> list[str]:
    """Draws the PNG files into a folder; their paths."""
    stem = pathlib.Path(report.path).stem
    paths = []
    if report.residues is not None:
        paths.append(folder / f"{stem}.compare-residues.png")
        draw_residues(report, paths[-1])
    if report.atoms is not None:
        paths.append(folder / f"{stem}.compare.png")
        _draw_summary(report.atoms, _title(report, report.atoms), paths[-1])
        if report.atoms.torsions:
            paths.append(folder / f"{stem}.compare-torsions.png")
            _draw_torsions(report.atoms, _title(report, report.atoms), paths[-1])
    return [str(path) for path in paths]


def _title(report: ComparisonReport, found: AtomComparison) -> str:
    ensembles = found.ensembles
    ours, theirs = (pathlib.Path(path).name for path in (report.path, report.theirs[0]))
    return (
        f"{ours} ({len(ensembles.ours)} frames) and {theirs} ({len(ensembles.theirs)} frames), "
        f"{len(ensembles.atoms)} atoms"
    )


def _draw_summary(report: AtomComparison, title: str, path: pathlib.Path) -> None:
    shown = report.residue_fluctuations or report.atom_fluctuations
    with figure(2, 2, title=title) as (plot, axes):
        _draw_profile(axes[0][0], shown)
        _draw_scatter(axes[0][1], report.atom_fluctuations)
        _draw_overlaps(axes[1][0], report)
        _draw_bars(axes[1][1], report)
        save(plot, path)


def _draw_profile(axes: Axes, found: Fluctuations) -> None:
    places = np.arange(len(found.labels))
    marker = "o" if len(places) <= 100 else ""
    for values, colour, name in ((found.ours, BLUE, "ours"), (found.theirs, VERMILION, "theirs")):
        axes.plot(places, values, marker=marker, markersize=3.5, color=colour, label=name)
    what = "alpha carbons" if found.kind == "residue" else "atoms"
    axes.set(ylabel="RMSF (Å)", title=f"Fluctuation of {what}", ylim=(0, None))
    step = -(-len(places) // MOST_NAMES)
    axes.set_xticks(places[::step], found.labels[::step], rotation=90, fontsize="x-small")
    axes.legend(frameon=False)


def _draw_scatter(axes: Axes, found: Fluctuations) -> None:
    axes.plot(found.theirs, found.ours, "o", color=BLUE, markersize=4, alpha=0.6)
    top = 1.05 * max(found.ours.max(), found.theirs.max())
    axes.plot([0, top], [0, top], color="black", linewidth=0.8, zorder=0)
    axes.set(
        xlabel="RMSF in theirs (Å)",
        ylabel="RMSF in ours (Å)",
        title=f"Atom by atom: Pearson r = {found.pearson:.2f}",
        xlim=(0, None),
        ylim=(0, None),
    )


def _draw_overlaps(axes: Axes, report: AtomComparison) -> None:
    modes = report.modes
    draw_matrix(axes, modes.overlaps)
    axes.set(
        title=f"Modes: RMSIP {modes.rmsip:.2f} (by chance {modes.chance:.2f}, "
        f"halves of theirs {modes.halves_theirs:.2f})"
    )


def _draw_bars(axes: Axes, report: AtomComparison) -> None:
    bars = report.bars
    if len(bars.labels) == 0:
        axes.text(0.5, 0.5, "no bar among the atoms", ha="center", transform=axes.transAxes)
    least = 1e-17
    for values, colour, name in (
        (bars.spread_ours, BLUE, "ours"),
        (bars.spread_theirs, VERMILION, "theirs"),
    ):
        axes.plot(np.sort(np.maximum(values, least)), color=colour, label=name, linewidth=2.5)
    axes.set(
        yscale="log",
        xlabel="bars, sorted by their spread",
        ylabel="standard deviation of the length (Å)",
        title="Lengths of bars",
    )
    axes.xaxis.set_major_locator(MaxNLocator(integer=True))
    axes.legend(frameon=False)


def _draw_torsions(report: AtomComparison, title: str, path: pathlib.Path) -> None:
    torsions = report.torsions
    if len(torsions) > MOST_TORSIONS:
        largest = sorted(torsions, key=lambda torsion: -torsion.distance)[:MOST_TORSIONS]
        torsions = [torsion for torsion in torsions if torsion in largest]
    columns = min(4, len(torsions))
    rows = -(-len(torsions) // columns)
    with figure(rows, columns, title=title, panel=(3.0, 2.2)) as (plot, axes):
        for place, panel in zip(np.ndindex(rows, columns), axes.flat, strict=True):
            k = place[0] * columns + place[1]
            if k < len(torsions):
                _draw_torsion(panel, torsions[k])
                panel.set_xlabel("angle (degrees)" if k + columns >= len(torsions) else "")
                panel.set_ylabel("share of frames" if place[1] == 0 else "")
            else:
                panel.set_axis_off()
        handles, names = axes[0][0].get_legend_handles_labels()
        plot.legend(handles, names, loc="outside lower center", ncols=2, frameon=False)
        save(plot, path)


def _draw_torsion(axes: Axes, torsion: TorsionComparison) -> None:
    edges = np.linspace(-180, 180, len(torsion.ours) + 1)
    axes.stairs(torsion.theirs, edges, fill=True, color=VERMILION, alpha=0.45, label="theirs")
    axes.stairs(torsion.ours, edges, color=BLUE, linewidth=1.8, label="ours")
    axes.set(
        xlim=(-180, 180),
        xticks=(-180, -90, 0, 90, 180),
        title=f"{torsion.label}: distance {torsion.distance:.2f}",
    )
