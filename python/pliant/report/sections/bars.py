# SPDX-License-Identifier: MIT
"""Whether every bar (fixed distance) of every frame is as long as it should be."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter

from pliant.base import style
from pliant.base.console import Table
from pliant.base.verdict import Verdict
from pliant.measure.residuals import BarResiduals
from pliant.measure.stages.analysis import Analysis
from pliant.measure.stages.names import bar_labels
from pliant.measure.stages.parts import Measurement
from pliant.report.section import Columns, Fact, Picture, Shown, Values, table_of
from pliant.report.sections.headings import EXACT
from pliant.report.sections.measured import Measured, has, why_skipped

BRIEF = "fixed distances"  #: what bars are to those who do not know the word
#: what a residual of 0 is drawn as on a logarithmic axis
SMALLEST = 1e-17


@dataclass(frozen=True)
class Residuals(Measurement):
    """How far the bars of each frame are from their rest lengths."""

    measured: BarResiduals
    #: (F,) bool: the run says converged, but a bar is beyond the tolerance; None: it says nothing
    broken_promises: np.ndarray | None


def _measure(analysis: Analysis) -> Iterator[Residuals]:
    source = analysis.source
    if len(source.bars) == 0:
        raise ValueError("the trajectory holds no bars with rest lengths")
    numbers = None if analysis.held is None else analysis.frames
    measured = BarResiduals(analysis.universe, frames=source, numbers=numbers)
    within, converged = analysis.run(measured).within, analysis.converged
    notes, cautions = [], []
    if measured.precision == "float32" and measured.tolerance < 1e-5:
        notes.append(
            "coordinates are stored as 32-bit floats, so residuals are known to a few 1e-6 only"
        )
    if unit := measured.rounded_to:
        cautions.append(f"bars are judged after rounding of coordinates to {unit:.1g} Angstrom")
    broken = None if converged is None else converged & ~within
    yield Residuals(measured, broken, notes=tuple(notes), cautions=tuple(cautions))


def _verdict(analysis: Analysis) -> Verdict:
    """Judges the bars of all frames analysed, from the coordinates."""
    residuals = analysis.get(Residuals)
    if residuals is None:
        why = why_skipped(analysis, "bar residuals")
        return Verdict("open", "There are no bars in this file to judge.", why, BRIEF)
    within, broken = residuals.found.within, residuals.broken_promises
    details = _worst(analysis, residuals)
    if within.all():
        return Verdict("good", "Every bar of every frame is within tolerance.", details, BRIEF)
    some = f"{np.count_nonzero(~within)} of {len(within)} frames have a bar beyond tolerance"
    if broken is None:
        return Verdict("bad", f"{some}.", details)
    if broken.any():
        called = f"{np.count_nonzero(broken)} of which the run calls converged"
        return Verdict("bad", f"{some}, {called}.", details)
    return Verdict("mixed", f"{some}; the run says so of each.", details)


def _tolerance(residuals: BarResiduals) -> str:
    """The tolerance with its unit."""
    if residuals.tolerance_length > 0:
        return f"{residuals.tolerance_length:g} Å"
    return scientific(residuals.tolerance, 0)


def scientific(value: float, digits: int = 2) -> str:
    """A small number for readers: 9.97 × 10⁻⁷; for 10⁻⁶ sharp only the power."""
    mantissa, exponent = f"{value:.{digits}e}".split("e")
    power = "10" + str(int(exponent)).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
    if value == 0:
        return "0"
    return power if mantissa == "1" else f"{mantissa} × {power}"


def _worst(analysis: Analysis, part: Residuals) -> str:
    residuals, found = part.measured, part.found
    k = int(np.argmax(found.max_relative))
    bar = residuals.bars[found.worst_bar[k]]
    (name,) = bar_labels(analysis.universe.atoms, [bar])
    where = f"frame {analysis.frames[k]}"
    if analysis.steps is not None:
        where += f" (step {analysis.steps[k]})"
    rounded, unit = "", residuals.rounded_to
    if unit:
        rounded = f", which are rounded to {scientific(unit)} Å; that much is allowed for"
    return (
        f"The worst is off by {scientific(found.max_relative[k])} of its length (tolerance "
        f"{_tolerance(residuals)}): bar {name} in {where}. Measured from the "
        f"{'double' if residuals.precision == 'float64' else 'single'}-precision "
        f"coordinates in the file{rounded}."
    )


def _values(analysis: Analysis) -> Values:
    part = analysis[Residuals]
    measured, found = part.measured, part.found
    values = {
        "bars": len(measured.bars),
        "tolerance": measured.tolerance,
        "tolerance_length": measured.tolerance_length,
        "precision": measured.precision,
        "rounded_to": measured.rounded_to,
        "max_residual": float(found.max_relative.max()),
        "frames_beyond_tolerance": int(np.count_nonzero(~found.within)),
    }
    if analysis.converged is not None and part.broken_promises is not None:
        values["frames_not_converged"] = int(np.count_nonzero(~analysis.converged))
        values["converged_but_beyond"] = int(np.count_nonzero(part.broken_promises))
    return values


def _facts(analysis: Analysis) -> Iterator[Fact]:
    residuals = analysis[Residuals]
    text = f"largest relative residual; tolerance {_tolerance(residuals.measured)}"
    yield Fact(scientific(residuals.found.max_relative.max()), "", text)


def _per_frame(analysis: Analysis) -> Columns:
    part = analysis[Residuals]
    found, ends = part.found, part.measured.bars[part.found.worst_bar]
    columns: Columns = {
        "max_relative_residual": found.max_relative,
        "rms_relative_residual": found.rms_relative,
        "max_residual_angstrom": found.max_length,
        "worst_bar": found.worst_bar,
        "worst_bar_i": ends[:, 0],
        "worst_bar_j": ends[:, 1],
        "within_tolerance": found.within.astype(int),
    }
    if analysis.converged is not None:
        columns["converged"] = analysis.converged.astype(int)
    return columns


def _per_bar(analysis: Analysis) -> Columns:
    part = analysis[Residuals]
    bars = part.measured.bars
    return {
        "bar": np.arange(len(bars)),
        "i": bars[:, 0],
        "j": bars[:, 1],
        "name": bar_labels(analysis.universe.atoms, bars),
        "rest_length_angstrom": part.measured.rest_lengths,
        "max_relative_residual": part.found.bar_max_relative,
    }


def _tables(analysis: Analysis) -> Iterator[Table]:
    worst = np.argsort(-analysis[Residuals].found.bar_max_relative, kind="stable")[:8]
    shown: Shown = {
        "name": ("bar", str),
        "rest_length_angstrom": ("rest length (Å)", "{:.4f}".format),
        "max_relative_residual": ("largest residual", scientific),
    }
    yield table_of("Bars that were furthest off", _per_bar(analysis), shown, worst)


def _draw(analysis: Analysis) -> Figure:
    """Largest and RMS residual of each frame, the tolerance, and frames beyond it."""
    measured = analysis[Residuals].measured
    found = measured.results
    x, label = analysis.axis
    figure, axes = style.new_figure()
    width = style.line_width(len(x))
    largest = np.maximum(found.max_relative, SMALLEST)
    axes.plot(x, largest, color=style.BLUE, lw=width, label="largest")
    axes.plot(x, np.maximum(found.rms_relative, SMALLEST), color=style.SKY, lw=width, label="RMS")
    if measured.tolerance_length == 0:
        axes.axhline(measured.tolerance, color=style.INK, lw=1.1, ls=(0, (5, 3)), label="tolerance")
    _mark_frames(axes, x, largest, analysis)
    axes.set_yscale("log")
    # matplotlib's own text takes longer to read than the whole figure to draw
    axes.yaxis.set_major_formatter(lambda value, _: scientific(value, 0))
    axes.yaxis.set_minor_formatter(NullFormatter())
    every = np.concatenate([found.max_relative, found.rms_relative, [measured.tolerance]])
    shown = every[every > SMALLEST]
    axes.set_ylim(shown.min() / 3, shown.max() * 4)
    axes.set(xlabel=label, ylabel="|length − rest| / rest", title="Bar residuals")
    style.legend_above(axes)
    return figure


def _mark_frames(axes: Axes, x: np.ndarray, largest: np.ndarray, analysis: Analysis) -> None:
    beyond = ~analysis[Residuals].found.within
    given_up = ~analysis.converged if analysis.converged is not None else np.zeros_like(beyond)
    size = style.mark_size(int(np.count_nonzero(beyond | given_up))) + 14
    groups = (
        (given_up, "x", style.ORANGE, "not converged"),
        (beyond & ~given_up, "o", style.VERMILION, "beyond tolerance"),
    )
    for chosen, marker, colour, label in groups:
        if chosen.any():
            place = x[chosen], largest[chosen]
            axes.scatter(*place, s=size, marker=marker, color=colour, label=label, zorder=4)


BARS = Measured(
    name="bars",
    stage="bar residuals",
    measure=_measure,
    heading=EXACT,
    applies=has(Residuals),
    verdict=_verdict,
    values=_values,
    facts=_facts,
    tables=_tables,
    per_frame=_per_frame,
    columns={"bars": _per_bar},
    pictures=[
        Picture(
            "residuals",
            _draw,
            "How far the worst bar of each frame, and the bars overall, are from their rest "
            "lengths: computed anew from the coordinates in the file.",
        )
    ],
    methods={
        "Residuals": (
            "|length − rest length| / rest length of every bar in every frame, from the "
            "coordinates as they are stored. A frame is within tolerance when all its bars are."
        )
    },
)
