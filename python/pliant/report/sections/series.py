# SPDX-License-Identifier: MIT
"""Numbers of each frame: RMSD, radius of gyration, distances that were asked for."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from pliant._core import OptionError
from pliant.base import style
from pliant.base.console import Table
from pliant.measure.gyration import RadiusOfGyration
from pliant.measure.rmsd import RmsdToStart
from pliant.measure.stages.analysis import Analysis
from pliant.measure.stages.parts import Part, ReferenceStructure
from pliant.report.section import Columns, Fact, Picture, Values
from pliant.report.sections.headings import SHAPES
from pliant.report.sections.measured import Measured, has
from pliant.trajectory.kind import ENSEMBLE
from pliant.trajectory.superposition import superpose_onto

#: frames that are superposed at a time, and bytes of their positions
AT_ONCE = 32
AT_ONCE_BYTES = 1 << 22


@dataclass(frozen=True)
class Rmsd(Part):
    """RMSD of each frame from the first, or from the start structure of an ensemble, Angstrom."""

    fitted: np.ndarray  #: (F,) of the atoms that are superposed
    analysed: np.ndarray | None  #: (F,) of all atoms analysed, if there are others


def _rmsd(analysis: Analysis) -> Iterator[Rmsd]:
    """From the first frame; of independent frames, from the reference structure."""
    if analysis.kind == ENSEMBLE:
        yield _rmsd_to_reference(analysis)
        return
    atoms, fitted, first = analysis.atoms, analysis.fitted, analysis.first
    of_fitted = analysis.run(RmsdToStart(fitted, reference_frame=first)).rmsd
    if set(atoms.ix) == set(fitted.ix):
        yield Rmsd(of_fitted, None)
    else:
        every = RmsdToStart(atoms, superpose_on=fitted, reference_frame=first)
        yield Rmsd(of_fitted, analysis.run(every).rmsd)


def _rmsd_to_reference(analysis: Analysis) -> Rmsd:
    """RMSD of the fitted atoms, and of all that are analysed if there are others."""
    atoms = analysis.atoms.ix
    fitted = np.isin(atoms, analysis.fitted.ix)
    target = analysis[ReferenceStructure].positions[atoms]
    values = np.empty((2, len(analysis.frames)))
    size = min(AT_ONCE, max(1, AT_ONCE_BYTES // (24 * len(atoms))))
    for first in range(0, len(analysis.frames), size):
        part = range(first, min(first + size, len(analysis.frames)))
        frames = np.array([analysis.positions(k)[atoms] for k in part])
        squares = np.sum((superpose_onto(frames, fitted, target[fitted]) - target) ** 2, axis=2)
        values[:, part] = np.sqrt([squares[:, fitted].mean(axis=1), squares.mean(axis=1)])
    return Rmsd(values[0], None if fitted.all() else values[1])


def _rmsd_facts(analysis: Analysis) -> Iterator[Fact]:
    values = analysis[Rmsd].fitted
    if analysis.kind == ENSEMBLE:
        text = f"mean RMSD from {analysis[ReferenceStructure].name}, {analysis.fitted_name}"
        yield Fact(f"{values.mean():.2f}", "Å", text)
    else:
        text = f"RMSD of the last frame from the first, {analysis.fitted_name}"
        yield Fact(f"{values[-1]:.2f}", "Å", text)


def _rmsd_per_frame(analysis: Analysis) -> Columns:
    found = analysis[Rmsd]
    more = {} if found.analysed is None else {"rmsd_all_angstrom": found.analysed}
    return {"rmsd_angstrom": found.fitted, **more}


def _draw_rmsd(analysis: Analysis) -> Figure:
    found, (x, label) = analysis[Rmsd], analysis.axis
    figure, axes = style.new_figure()
    look, selected = _style(analysis), analysis.options.select
    if found.analysed is not None:
        name = "all atoms" if selected == "all" else f"atoms '{selected}'"
        axes.plot(x, found.analysed, color=style.SKY, label=name, **look)
    axes.plot(x, found.fitted, color=style.BLUE, label=analysis.fitted_name, **look)
    axes.set(xlabel=label, ylabel="RMSD (Å)", title="Distance from the start")
    axes.set_ylim(bottom=0)
    style.legend_above(axes)
    return figure


def _style(analysis: Analysis) -> dict[str, Any]:
    """A line along a path; dots for frames that do not follow each other."""
    if analysis.kind == ENSEMBLE:
        size = 0.5 * style.mark_size(len(analysis.frames)) ** 0.5
        return {"lw": 0, "marker": "o", "mew": 0, "ms": size}
    return {"lw": style.line_width(len(analysis.frames))}


RMSD = Measured(
    stage="RMSD",
    measure=_rmsd,
    heading=SHAPES,
    applies=has(Rmsd),
    facts=_rmsd_facts,
    per_frame=_rmsd_per_frame,
    values=lambda analysis: {
        "rmsd_last": float(analysis[Rmsd].fitted[-1]),
        "rmsd_max": float(analysis[Rmsd].fitted.max()),
    },
    pictures=[
        Picture(
            "rmsd",
            _draw_rmsd,
            "Root mean square distance of the atoms from the first frame, or the start structure "
            "of an ensemble, after superposition.",
        )
    ],
    methods={
        "RMSD": (
            "Root mean square distance from the first frame analysed, of an ensemble from the "
            "start structure."
        )
    },
)


@dataclass(frozen=True)
class Gyration(Part):
    """Radius of gyration of each frame."""

    radius: np.ndarray  #: (F,) Angstrom
    weights: str  #: "mass", or "equal" where there are no masses


def _gyration(analysis: Analysis) -> Iterator[Gyration]:
    atoms = analysis.atoms
    weights = "mass" if hasattr(atoms, "masses") and atoms.masses.sum() > 0 else None
    measured = RadiusOfGyration(atoms, weights=weights)
    yield Gyration(analysis.run(measured).radius, weights or "equal")


def _gyration_facts(analysis: Analysis) -> Iterator[Fact]:
    radius = analysis[Gyration].radius
    meaning = f"radius of gyration, standard deviation {radius.std():.2g} Å"
    yield Fact(f"{radius.mean():.2f}", "Å", meaning)


def _draw_gyration(analysis: Analysis) -> Figure:
    """Along the run, with its mean and standard deviation."""
    found, (x, label) = analysis[Gyration], analysis.axis
    mean, spread = found.radius.mean(), found.radius.std()
    figure, axes = style.new_figure()
    axes.axhspan(mean - spread, mean + spread, color=style.FAINT, lw=0, zorder=0.5)
    axes.axhline(
        mean,
        color=style.GREY,
        lw=1,
        zorder=1,
        label=f"mean {mean:.2f} Å, standard deviation {spread:.2g}",
    )
    axes.plot(x, found.radius, color=style.GREEN, **_style(analysis))
    what = "mass-weighted" if found.weights == "mass" else "equal weights"
    axes.set(xlabel=label, ylabel="radius of gyration (Å)", title=f"Size ({what})")
    style.legend_above(axes)
    return figure


GYRATION = Measured(
    stage="radius of gyration",
    measure=_gyration,
    heading=SHAPES,
    applies=has(Gyration),
    facts=_gyration_facts,
    per_frame=lambda analysis: {"radius_of_gyration_angstrom": analysis[Gyration].radius},
    values=lambda analysis: {
        "radius_of_gyration_mean": float(analysis[Gyration].radius.mean()),
        "radius_of_gyration_sd": float(analysis[Gyration].radius.std()),
    },
    pictures=[
        Picture(
            "radius_of_gyration",
            _draw_gyration,
            "How spread out the molecule is; the band is one standard deviation.",
        )
    ],
)


@dataclass(frozen=True)
class Distances(Part):
    """Distances that were asked for."""

    ends: tuple[tuple[str, str], ...]  #: pairs of selections
    values: tuple[np.ndarray, ...]  #: (F,) of each pair, Angstrom

    def __iter__(self) -> Iterator[tuple[str, str, np.ndarray]]:
        for (first, second), values in zip(self.ends, self.values, strict=True):
            yield first, second, values


def _distances(analysis: Analysis) -> Iterator[Distances]:
    """Of the centres of the selections that were asked for."""
    asked = analysis.options.distances
    if asked:
        ends = [[_centres(analysis, selection) for selection in pair] for pair in asked]
        yield Distances(asked, tuple(np.linalg.norm(b - a, axis=1) for a, b in ends))


def _centres(analysis: Analysis, selection: str) -> np.ndarray:
    """(F, 3) centres of the atoms selected, Angstrom."""
    try:
        atoms = analysis.universe.select_atoms(selection)
    except Exception as error:  # MDAnalysis raises many kinds for a wrong selection
        reason = " ".join(str(error).split())
        raise OptionError(f"--distance '{selection}': {reason}") from error
    if len(atoms) == 0:
        raise OptionError(f"--distance '{selection}': selects no atoms")
    blocks = analysis.some_positions(atoms.ix)
    return np.concatenate([block.astype(np.float64).mean(axis=1) for block in blocks])


def _distance_values(analysis: Analysis) -> Values:
    found = [
        {"from": first, "to": second, "mean": float(values.mean()), "sd": float(values.std())}
        | {"smallest": float(values.min()), "largest": float(values.max())}
        for first, second, values in analysis[Distances]
    ]
    return {"distances": found}


def _distance_tables(analysis: Analysis) -> Iterator[Table]:
    rows = [
        (f"{a} to {b}", f"{x.mean():.2f}", f"{x.std():.2f}", f"{x.min():.2f} to {x.max():.2f}")
        for a, b, x in analysis[Distances]
    ]
    columns = ("distance", "mean (Å)", "standard deviation", "range")
    yield Table("Distances asked for", columns, rows)


def _draw_distances(analysis: Analysis) -> Figure:
    """How often each distance was taken."""
    found = analysis[Distances]
    count = len(found.ends)
    figure, axes = style.new_figure((style.WIDE[0], 1.9 * count + 0.4), count, 1, squeeze=False)
    for row, (first, second, values) in zip(axes[:, 0], found, strict=True):
        row.hist(values, bins="sqrt", color=style.BLUE, rwidth=0.92)
        row.axvline(values.mean(), color=style.INK, lw=1.1, ls=(0, (5, 3)))
        row.set(xlabel="distance (Å)", ylabel="frames", title=f"{first} to {second}")
    return figure


DISTANCES = Measured(
    stage="distances",
    measure=_distances,
    heading=SHAPES,
    applies=has(Distances),
    values=_distance_values,
    lines=lambda analysis: [
        ("distance", f"{values.min():.1f} to {values.max():.1f} Å: {first} to {second}")
        for first, second, values in analysis[Distances]
    ],
    tables=_distance_tables,
    per_frame=lambda analysis: {
        f"distance {first} to {second} (angstrom)": values
        for first, second, values in analysis[Distances]
    },
    pictures=[
        Picture(
            "distances",
            _draw_distances,
            "The distances that were asked for, between centres of the atoms selected; dashed: "
            "mean.",
        )
    ],
)
