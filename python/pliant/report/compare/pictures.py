# SPDX-License-Identifier: MIT
"""The pictures of a comparison: how far residues and atoms move, modes, lengths, torsions."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from pliant.base import style
from pliant.base.console import listed
from pliant.measure.compared.residue_report import Profile, ResidueComparison, Subspaces
from pliant.report.compare.comparison_report import (
    AtomComparison,
    ComparisonReport,
    Fluctuations,
    TorsionComparison,
)
from pliant.report.compare.conclusions import figure_text
from pliant.report.figures.draw_in_parallel import save_picture
from pliant.report.figures.profile import chain_parts
from pliant.report.section import Picture

MOST_TORSIONS = 24  #: panels; those that differ most are drawn
NAMES = 30  #: labels on an axis, about


def draw_residues(report: ComparisonReport) -> Figure:
    """How far residues move, and the modes of both."""
    found = report.residues
    assert found is not None
    both = found.subspaces
    has_modes = both is not None and both.overlaps.size > 0
    count = found.theirs.frames if found.theirs else 1
    title = f"{_title(report, found.ours.frames, count)}, {len(found.labels)} residues"
    plot, axes = style.panels(1, 3 if has_modes else 1, title, panel=(5.6, 4.0))
    _draw_profiles(axes[0][0], found)
    if has_modes:
        assert both is not None
        _draw_modes(axes[0][1], both)
        _draw_covered(axes[0][2], both)
    return plot


def _title(report: ComparisonReport, ours: int, theirs: int) -> str:
    """Both files, with how many frames each has."""
    others = listed([Path(path).name for path in report.theirs], 1)
    return f"{Path(report.path).name} ({ours} frames) and {others} ({theirs})"


def _draw_profiles(axes: Axes, found: ResidueComparison) -> None:
    places = np.arange(len(found.labels))
    if found.theirs is None:
        _band(axes, places, found.ours, 1.0, style.BLUE, "ours")
        title = "How far residues of ours move"
    else:
        _band(axes, places, found.theirs, 1.0, style.VERMILION, "theirs")
        scaled = "ours" if found.scale == 1.0 else f"ours, times {found.scale:.2f}"
        _band(axes, places, found.ours, found.scale, style.BLUE, scaled)
        title = f"How far residues move: r = {figure_text(found.r)}"
    for part in chain_parts(found.core):
        if not found.core[part.start]:
            axes.axvspan(part.start - 0.5, part.stop - 0.5, color=style.GREY, alpha=0.18, lw=0)
    for edge in np.flatnonzero(found.chains[1:] != found.chains[:-1]):
        axes.axvline(edge + 0.5, color="black", linewidth=0.6, linestyle=":")
    _name_places(axes, found.labels)
    axes.set(ylabel="RMSF (Å), two standard errors", title=title, ylim=(0, _top(found)))
    if not found.core.all():
        axes.set_xlabel("grey: free ends, left out of r", fontsize="small")
    axes.legend()


def _band(
    axes: Axes, places: np.ndarray, profile: Profile, scale: float, colour: str, label: str
) -> None:
    middle, error = scale * profile.rmsf, scale * np.nan_to_num(profile.error)
    axes.fill_between(
        places,
        np.maximum(middle - 2 * error, 0),
        middle + 2 * error,
        color=colour,
        alpha=0.25,
        linewidth=0,
    )
    axes.plot(places, middle, color=colour, label=label)


def _top(found: ResidueComparison) -> float:
    """Above all of the core; free ends may go out of the picture."""
    tops = [(found.ours, 1.0 if found.theirs is None else found.scale)]
    if found.theirs is not None:
        tops.append((found.theirs, 1.0))
    return 1.25 * max(
        float((scale * (one.rmsf + 2 * np.nan_to_num(one.error)))[found.core].max())
        for one, scale in tops
    )


def _draw_modes(axes: Axes, both: Subspaces) -> None:
    _draw_matrix(axes, both.overlaps)
    ceiling = f", halves of theirs {both.ceiling:.2f}" if math.isfinite(both.ceiling) else ""
    axes.set(title=f"Modes: RMSIP {figure_text(both.rmsip)} (chance {both.chance:.2f}{ceiling})")


def _draw_matrix(axes: Axes, overlaps: np.ndarray) -> None:
    """Overlaps (K, L) of our modes and theirs as an image."""
    rows, columns = overlaps.shape
    extent = (0.5, rows + 0.5, 0.5, columns + 0.5)
    image = axes.imshow(
        overlaps.T, origin="lower", vmin=0, vmax=1, cmap=style.MAP, aspect="auto", extent=extent
    )
    axes.figure.colorbar(image, ax=axes, label="overlap |u · v|")
    axes.grid(False)
    axes.set_xticks(np.arange(1, rows + 1))
    axes.set_yticks(np.arange(1, columns + 1))
    axes.set(xlabel="mode of ours", ylabel="mode of theirs")


def _draw_covered(axes: Axes, both: Subspaces) -> None:
    for shift, values, colour, label in (
        (-0.2, both.covered_theirs, style.VERMILION, "of theirs, in ours"),
        (0.2, both.covered_ours, style.BLUE, "of ours, in theirs"),
    ):
        axes.bar(np.arange(1, len(values) + 1) + shift, values, 0.4, color=colour, label=label)
    axes.axhline(both.chance, color="black", linewidth=1.0, linestyle=":", label="by chance")
    axes.xaxis.set_major_locator(MaxNLocator(integer=True))
    axes.set(
        xlabel="mode",
        ylabel="share in the other's first modes",
        ylim=(0, 1.19),
        title="What each has of the other's modes",
    )
    axes.set_yticks(np.linspace(0, 1, 6))
    axes.legend(ncols=3, loc="upper center", columnspacing=1.0, handlelength=1.2)


def draw_atoms(report: ComparisonReport) -> Figure:
    """How far atoms move, the modes of both, and lengths of bars."""
    found = report.atoms
    assert found is not None
    plot, axes = style.panels(2, 2, _atoms_title(report, found))
    _draw_profile(axes[0][0], found.residue_fluctuations or found.atom_fluctuations)
    _draw_scatter(axes[0][1], found.atom_fluctuations)
    _draw_overlaps(axes[1][0], found)
    _draw_bars(axes[1][1], found)
    return plot


def _atoms_title(report: ComparisonReport, found: AtomComparison) -> str:
    both = found.ensembles
    frames = _title(report, len(both.ours), len(both.theirs))
    return f"{frames}, {len(both.atoms)} atoms"


def _draw_profile(axes: Axes, found: Fluctuations) -> None:
    places = np.arange(len(found.labels))
    marker = "o" if len(places) <= 100 else ""
    for values, colour, name in (
        (found.ours, style.BLUE, "ours"),
        (found.theirs, style.VERMILION, "theirs"),
    ):
        axes.plot(places, values, marker=marker, markersize=3.5, color=colour, label=name)
    what = "alpha carbons" if found.kind == "residue" else "atoms"
    axes.set(ylabel="RMSF (Å)", title=f"Fluctuation of {what}", ylim=(0, None))
    _name_places(axes, found.labels)
    axes.legend()


def _draw_scatter(axes: Axes, found: Fluctuations) -> None:
    axes.plot(found.theirs, found.ours, "o", color=style.BLUE, markersize=4, alpha=0.6)
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
    _draw_matrix(axes, modes.overlaps)
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
        (bars.spread_ours, style.BLUE, "ours"),
        (bars.spread_theirs, style.VERMILION, "theirs"),
    ):
        axes.plot(np.sort(np.maximum(values, least)), color=colour, label=name, linewidth=2.5)
    axes.set(
        yscale="log",
        xlabel="bars, sorted by their spread",
        ylabel="standard deviation of the length (Å)",
        title="Lengths of bars",
    )
    axes.xaxis.set_major_locator(MaxNLocator(integer=True))
    axes.legend()


def _name_places(axes: Axes, labels: list[str]) -> None:
    step = -(-len(labels) // NAMES)
    places = np.arange(len(labels))[::step]
    axes.set_xticks(places, labels[::step], rotation=90, fontsize="x-small")


def draw_torsions(report: ComparisonReport) -> Figure:
    """Distributions of torsion angles."""
    found = report.atoms
    assert found is not None
    torsions = found.torsions
    if len(torsions) > MOST_TORSIONS:
        largest = sorted(torsions, key=lambda torsion: -torsion.distance)[:MOST_TORSIONS]
        torsions = [torsion for torsion in torsions if torsion in largest]
    columns = min(4, len(torsions))
    rows = -(-len(torsions) // columns)
    plot, axes = style.panels(rows, columns, _atoms_title(report, found), panel=(3.0, 2.2))
    for k, panel in enumerate(axes.flat):
        if k < len(torsions):
            _draw_torsion(panel, torsions[k])
            panel.set_xlabel("angle (degrees)" if k + columns >= len(torsions) else "")
            panel.set_ylabel("share of frames" if k % columns == 0 else "")
        else:
            panel.set_axis_off()
    handles, names = axes[0][0].get_legend_handles_labels()
    plot.legend(handles, names, loc="outside lower center", ncols=2)
    return plot


def _draw_torsion(axes: Axes, torsion: TorsionComparison) -> None:
    edges = np.linspace(-180, 180, len(torsion.ours) + 1)
    axes.stairs(torsion.theirs, edges, fill=True, color=style.VERMILION, alpha=0.45, label="theirs")
    axes.stairs(torsion.ours, edges, color=style.BLUE, linewidth=1.8, label="ours")
    axes.set(
        xlim=(-180, 180),
        xticks=(-180, -90, 0, 90, 180),
        title=f"{torsion.label}: distance {torsion.distance:.2f}",
    )


def draw(report: ComparisonReport, folder: Path) -> list[str]:
    """Draws the PNG files into a folder; their paths."""
    folder.mkdir(parents=True, exist_ok=True)
    paths = []
    for picture in PICTURES:
        if picture.suits(report):
            paths.append(folder / f"{Path(report.path).stem}.{picture.name}.png")
            save_picture(picture, report, paths[-1], style.DPI)
    return [str(path) for path in paths]


PICTURES = (
    Picture("compare-residues", draw_residues, suits=lambda report: report.residues is not None),
    Picture("compare", draw_atoms, suits=lambda report: report.atoms is not None),
    Picture(
        "compare-torsions",
        draw_torsions,
        suits=lambda report: bool(report.atoms and report.atoms.torsions),
    ),
)
