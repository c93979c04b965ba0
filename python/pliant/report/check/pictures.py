# SPDX-License-Identifier: MIT
"""The picture of a check: residuals, what OpenMM moves, how frames are repaired, energies."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import LogLocator, NullLocator

from pliant.base.style import BLUE, DASHED, GREEN, GREY, PALETTE, VERMILION, figure, save
from pliant.checks.contest import Method
from pliant.checks.force_field.minimised import LONG, SHORT, ForceFieldReport, Minimised
from pliant.checks.force_field.verdicts import MOST_ABOVE, MOST_MOVED
from pliant.report.check.check_report import CheckReport

LEAST_RESIDUAL = 1e-17  #: where exact zeros are drawn
LOST = 3.0  #: residuals from here on are drawn as lost
MARKERS = "osD^v"


def draw(report: CheckReport, path: str) -> None:
    """Draws the report as a PNG."""
    minimised = report.force_field if report.force_field and report.force_field.usable else None
    rows = 1 + bool(report.methods) + (minimised is not None)
    with figure(rows, 2, title=_title(report)) as (plot, axes):
        _draw_residuals(axes[0][0], report)
        _draw_moves(axes[0][1], report)
        if report.methods:
            _draw_times(axes[1][0], report.methods)
            _draw_left(axes[1][1], report)
            handles, names = axes[1][0].get_legend_handles_labels()
            plot.legend(handles, names, loc="outside lower center", ncols=3)
        if minimised is not None:
            _draw_energies(axes[-1][0], minimised)
            _draw_shifts(axes[-1][1], minimised)
        save(plot, path)


def _title(report: CheckReport) -> str:
    recording = report.recording
    state = "all checks passed" if report.passed else "a check failed"
    name = recording.name.rsplit("/", 1)[-1]
    return (
        f"{name}: {recording.atom_count} atoms, {len(recording.bars)} bars, "
        f"{len(recording)} frames - {state}"
    )


def _draw_residuals(axes: Axes, report: CheckReport) -> None:
    recording, residual = report.recording, report.remeasured.residual
    if recording.tolerance.length == 0:
        _draw_tolerance(axes, recording.tolerance.relative)
    least = _least_shown(residual)
    shown = np.maximum(np.nan_to_num(residual, nan=1.0), least)
    below, whole = shown <= least, recording.converged
    for mask, marker, colour, label in (
        (whole & ~below, "o", BLUE, "converged"),
        (~whole & ~below, "^", VERMILION, "recorded as not converged"),
        (below, "v", BLUE, "this or less"),
    ):
        if mask.any():
            size = 3 if len(shown) > 100 else 5
            x, y = recording.steps[mask], shown[mask]
            axes.plot(x, y, marker, color=colour, label=label, markersize=size)
    axes.set(
        yscale="log",
        ylim=(least / 2, None),
        xlabel="step",
        ylabel="largest |length - rest| / rest",
        title="Worst bar of each frame, measured anew",
    )
    if below.any() or not whole.all():
        axes.legend(loc="center left")


def _least_shown(residual: np.ndarray) -> float:
    """The start is often exact: the scale is that of all but the smallest residuals."""
    usual = residual[np.isfinite(residual) & (residual > 0)]
    return max(float(np.quantile(usual, 0.1)) / 30, LEAST_RESIDUAL) if len(usual) else 1e-9


def _draw_tolerance(axes: Axes, tolerance: float) -> None:
    axes.axhline(tolerance, color="black", linestyle=DASHED, linewidth=1)
    _note(axes, "tolerance", (0.99, tolerance), ha="right")


def _draw_moves(axes: Axes, report: CheckReport) -> None:
    moves = {f.name: f.figures.get("moves", ()) for f in report.findings}
    groups = [moves.get("frames_stay", ()), moves.get("broken_copies_move", ())]
    finite = [m for group in groups for m in group if np.isfinite(m) and m > 0]
    zero = 10.0 ** np.floor(np.log10(min(finite, default=1e-5)) - 2)
    beyond = 10.0 ** np.ceil(np.log10(min(max(finite, default=1e-4), 1e2)) + 1)
    for x, (group, colour) in enumerate(zip(groups, (BLUE, VERMILION), strict=True)):
        values = np.nan_to_num(np.asarray(group, float), nan=np.inf)
        values = np.clip(np.where(values == 0, zero, values), zero, beyond)
        spread = x + 0.5 * (np.arange(len(values)) / max(len(values) - 1, 1) - 0.5)
        axes.plot(spread, values, "o", color=colour, alpha=0.8, zorder=3)
        if len(values) == 0:
            axes.text(x, np.sqrt(zero * beyond), "no answer", ha="center")
    axes.set(
        yscale="log",
        xlim=(-0.5, 1.5),
        ylim=(zero / 3, beyond * 3),
        ylabel="furthest move of an atom (Å)",
        title="What OpenMM's constraints move",
    )
    _label_ends(axes, zero, beyond, any(not m < beyond for group in groups for m in group))
    axes.set_xticks([0, 1], ["our frames", "copies with one bar too long"])


def _label_ends(axes: Axes, zero: float, beyond: float, reached: bool) -> None:
    first, last = np.log10(zero) + 1, np.log10(beyond)
    exponents = np.arange(first, last, max(1, np.ceil((last - first) / 5)))
    ticks = [zero, *10.0**exponents]
    names = ["0 exactly", *(f"$10^{{{int(e)}}}$" for e in exponents)]
    if reached:
        ticks, names = [*ticks, beyond], [*names, "more, or\nno number"]
    axes.set_yticks(ticks, names)
    axes.set_yticks([], minor=True)


def _draw_times(axes: Axes, methods: list[Method]) -> None:
    for k, method in enumerate(methods):
        whole = [r.structures > 0 and r.whole == r.structures for r in method.results]
        y = [r.seconds * 1e6 if w else np.nan for r, w in zip(method.results, whole, strict=True)]
        axes.plot(_places(k, method), y, label=method.name, **_style(k, method))
    axes.set(
        xscale="log",
        yscale="log",
        ylabel="time for one structure (µs)",
        title="Repairing broken frames: time, where all were repaired",
    )
    axes.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axes.yaxis.set_major_formatter(lambda value, _: f"{value:g}")
    axes.yaxis.set_minor_locator(NullLocator())
    _tick_at_displacements(axes, methods)


def _draw_left(axes: Axes, report: CheckReport) -> None:
    for k, method in enumerate(report.methods):
        x = _places(k, method)
        y = np.array([r.worst_residual_after for r in method.results])
        lost = ~(y < LOST)
        style = _style(k, method)
        axes.plot(x, np.where(lost, np.nan, np.maximum(y, LEAST_RESIDUAL)), **style)
        axes.plot(x[lost], np.full(lost.sum(), 3.0 * LOST), **(style | {"linestyle": "none"}))
    axes.set(
        xscale="log",
        yscale="log",
        ylabel="largest residual left",
        title="Repairing broken frames: what is left",
    )
    axes.set_ylim(min(axes.get_ylim()[0], report.tolerance / 10), 10.0 * LOST)
    axes.axhspan(LOST, 10.0 * LOST, color=GREY, alpha=0.25, linewidth=0)
    _note(axes, "diverged, or no number", (0.01, LOST), up=-11)
    _draw_tolerance(axes, report.tolerance)
    _tick_at_displacements(axes, report.methods)


def _places(k: int, method: Method) -> np.ndarray:
    """Displacements, moved a little for each method so that no marker hides another."""
    return np.array([r.displacement for r in method.results]) * 1.05 ** (k - 2)


def _style(k: int, method: Method) -> dict[str, Any]:
    return {
        "color": PALETTE[k % len(PALETTE)],
        "marker": MARKERS[k % len(MARKERS)],
        "linestyle": "-" if method.whose == "pliant" else DASHED,
        "markersize": 6,
    }


def _tick_at_displacements(axes: Axes, methods: list[Method]) -> None:
    sizes = [r.displacement for r in methods[0].results]
    axes.set_xticks(sizes, [f"{size:g}" for size in sizes], minor=False)
    axes.set_xticks([], minor=True)
    axes.set_xlabel("coordinates displaced by (Å, standard deviation)")


def _note(axes: Axes, text: str, place: tuple[float, float], up: int = 3, **look: Any) -> None:
    """Small text at a share of the width and a height of the data, some points above it."""
    axes.annotate(
        text,
        place,
        (0, up),
        textcoords="offset points",
        fontsize="small",
        **({"xycoords": ("axes fraction", "data")} | look),
    )


def _draw_energies(axes: Axes, report: ForceFieldReport) -> None:
    """Strips of frames and of MD, after 100 and after 500 steps, with the limits."""
    places = {(SHORT, 0): 0.0, (SHORT, 1): 0.8, (LONG, 0): 2.0, (LONG, 1): 2.8}
    for (steps, kind), x in places.items():
        structures, colour, _ = _groups(report)[kind]
        values = report.above_start(structures, steps)
        _strip(axes, x, values, colour)
        if len(values) == 0:
            axes.text(x, 0.1, "none", ha="center", fontsize="small", color=GREY)
    for steps, x in ((SHORT, 0.4), (LONG, 2.4)):
        ends, limit = [x - 0.75, x + 0.75], [MOST_ABOVE[steps]] * 2
        axes.plot(ends, limit, color="black", linewidth=1, linestyle=DASHED)
        _note(axes, "limit", (x + 0.75, MOST_ABOVE[steps]), xycoords="data", ha="right")
    axes.axhline(0, color=GREY, linewidth=1)
    axes.set(
        ylabel="kJ/mol a residue above the start",
        title="Energy once minimised, start minimised alike",
        xlim=(-0.6, 3.4),
    )
    axes.set_xticks(
        list(places.values()), [f"{_groups(report)[k][2]}\n{s} steps" for s, k in places]
    )


def _draw_shifts(axes: Axes, report: ForceFieldReport) -> None:
    """How far 100 steps move the alpha carbons of frames, of MD, and of the start."""
    groups = _groups(report)
    for x, (structures, colour, _) in enumerate(groups):
        _strip(axes, x, report.moved(structures), colour)
    if np.isfinite(report.start.moved):
        axes.axhline(report.start.moved, color=VERMILION, linewidth=1.2)
        _note(axes, "the start", (0.01, report.start.moved), color=VERMILION)
    axes.axhline(MOST_MOVED, color="black", linewidth=1, linestyle=DASHED)
    _note(axes, "limit", (0.99, MOST_MOVED), ha="right")
    top = axes.get_ylim()[1]
    axes.set(
        ylabel="RMSD of alpha carbons (Å)",
        title="What 100 steps of minimising move",
        xlim=(-0.6, 1.6),
        ylim=(0, max(top, 1.2 * MOST_MOVED)),
    )
    axes.set_xticks([0, 1], [name for _, _, name in groups])


def _groups(report: ForceFieldReport) -> list[tuple[Sequence[Minimised], str, str]]:
    return [(report.frames, BLUE, "frames"), (report.dynamics, GREEN, "MD")]


def _strip(axes: Axes, x: float, values: np.ndarray, colour: str) -> None:
    """Points beside each other, their mean as a line; what has no number is left out."""
    finite = values[np.isfinite(values)]
    if len(finite) == 0:
        return
    spread = x + 0.4 * (np.arange(len(finite)) / max(len(finite) - 1, 1) - 0.5)
    axes.plot(spread, finite, "o", color=colour, alpha=0.75, markersize=5, zorder=3)
    axes.plot([x - 0.27, x + 0.27], [finite.mean()] * 2, color=colour, linewidth=2.4, zorder=4)
