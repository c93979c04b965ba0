# SPDX-License-Identifier: MIT
"""The comparison residue by residue as a picture: both profiles with errors, overlaps of modes."""

from __future__ import annotations

import math
import pathlib
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.ticker import MaxNLocator

from pliant.base.plotting import BLUE, GREY, VERMILION, figure, save
from pliant.report.compare.conclusions import figure_text

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from pliant.measure.compared.residue_report import Profile, ResidueComparison, Subspaces
    from pliant.report.compare.comparison_report import ComparisonReport

TICKS = 24  #: residues named on the axis, about


def draw_residues(report: ComparisonReport, path: pathlib.Path) -> None:
    """Writes a PNG."""
    found = report.residues
    assert found is not None
    has_modes = found.subspaces is not None and found.subspaces.overlaps.size > 0
    with figure(1, 3 if has_modes else 1, title=_title(report), panel=(5.6, 4.0)) as (plot, axes):
        _draw_profiles(axes[0][0], found)
        if has_modes:
            assert found.subspaces is not None
            _draw_modes(axes[0][1], found.subspaces)
            _draw_covered(axes[0][2], found.subspaces)
        save(plot, path)


def _title(report: ComparisonReport) -> str:
    found = report.residues
    assert found is not None
    theirs = pathlib.Path(report.theirs[0]).name
    if len(report.theirs) > 1:
        theirs += f" and {len(report.theirs) - 1} more"
    count = found.theirs.frames if found.theirs else 1
    return (
        f"{pathlib.Path(report.path).name} ({found.ours.frames} frames) and {theirs} ({count}), "
        f"{len(found.labels)} residues"
    )


def _draw_profiles(axes: Axes, found: ResidueComparison) -> None:
    places = np.arange(len(found.labels))
    if found.theirs is None:
        _band(axes, places, found.ours, 1.0, BLUE, "ours")
        title = "How far residues of ours move"
    else:
        _band(axes, places, found.theirs, 1.0, VERMILION, "theirs")
        scaled = "ours" if found.scale == 1.0 else f"ours, times {found.scale:.2f}"
        _band(axes, places, found.ours, found.scale, BLUE, scaled)
        title = f"How far residues move: r = {figure_text(found.r)}"
    for start, stop in _runs(~found.core):
        axes.axvspan(start - 0.5, stop - 0.5, color=GREY, alpha=0.18, linewidth=0)
    for edge in np.flatnonzero(found.chains[1:] != found.chains[:-1]):
        axes.axvline(edge + 0.5, color="black", linewidth=0.6, linestyle=":")
    step = max(1, -(-len(places) // TICKS))
    axes.set_xticks(places[::step], found.labels[::step], rotation=90, fontsize="x-small")
    axes.set(ylabel="RMSF (Å), two standard errors", title=title, ylim=(0, _top(found)))
    if not found.core.all():
        axes.set_xlabel("grey: free ends, left out of r", fontsize="small")
    axes.legend(frameon=False)


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


def _runs(flags: np.ndarray) -> list[tuple[int, int]]:
    edges = np.flatnonzero(np.diff(np.concatenate([[False], flags, [False]]).astype(int)))
    return [(int(a), int(b)) for a, b in edges.reshape(-1, 2)]


def _draw_modes(axes: Axes, both: Subspaces) -> None:
    draw_matrix(axes, both.overlaps)
    ceiling = f", halves of theirs {both.ceiling:.2f}" if math.isfinite(both.ceiling) else ""
    axes.set(title=f"Modes: RMSIP {figure_text(both.rmsip)} (chance {both.chance:.2f}{ceiling})")


def draw_matrix(axes: Axes, overlaps: np.ndarray) -> None:
    """Overlaps (K, L) of our modes and theirs as an image."""
    rows, columns = overlaps.shape
    extent = (0.5, rows + 0.5, 0.5, columns + 0.5)
    image = axes.imshow(
        overlaps.T, origin="lower", vmin=0, vmax=1, cmap="cividis", aspect="auto", extent=extent
    )
    axes.figure.colorbar(image, ax=axes, label="overlap |u · v|")
    axes.grid(False)
    axes.set_xticks(np.arange(1, rows + 1))
    axes.set_yticks(np.arange(1, columns + 1))
    axes.set(xlabel="mode of ours", ylabel="mode of theirs")


def _draw_covered(axes: Axes, both: Subspaces) -> None:
    for shift, values, colour, label in (
        (-0.2, both.covered_theirs, VERMILION, "of theirs, in ours"),
        (0.2, both.covered_ours, BLUE, "of ours, in theirs"),
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
    axes.legend(frameon=False, ncols=3, loc="upper center", columnspacing=1.0, handlelength=1.2)
