# SPDX-License-Identifier: MIT
"""What is flexible: how far each atom, residue or ligand moves, with an error."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pliant._core import node_b_factors
from pliant.base import style
from pliant.base.console import Table
from pliant.base.verdict import Verdict
from pliant.measure.collective import participation
from pliant.measure.flexibility import (
    Flexibility,
    flexibility,
    numbered_blocks,
    path_blocks,
    precision,
)
from pliant.measure.stages.amplitude import asked_amplitude
from pliant.measure.stages.analysis import Analysis
from pliant.measure.stages.parts import Part, ReferenceStructure, Units
from pliant.report.figures.profile import NAMED_BARS, domain_strip, draw_profile
from pliant.report.section import Columns, Fact, Picture, Shown, table_of
from pliant.report.sections.domains import LEAST_CHAIN, RigidDomains, domains, domains_of_units
from pliant.report.sections.headings import FLEXIBLE
from pliant.report.sections.measured import Measured, caption, has, why_skipped
from pliant.report.sections.motions import Components
from pliant.trajectory.frame_store import FrameStore
from pliant.trajectory.kind import ENSEMBLE, PATH, TRANSITION
from pliant.trajectory.superposition import superpose_frames

#: numbers of frames of `pliant sample` are white within blocks of so many
WHITE = 100
#: components whose motion of each unit stands in flexibility.csv
MOTIONS = 3
#: kinds of frames of which fluctuations are no property of the molecule
NO_ENSEMBLES = (PATH, TRANSITION)
#: where frames reached less than this share of the amplitude asked for, the verdict is a warning
LEAST_REACHED = 0.5


@dataclass(frozen=True)
class UnitFlexibility(Part):
    """RMSF of each unit, with its error."""

    found: Flexibility
    #: (n,) B factors of a crystal, over their mean; NaN for units of no chain; None without chains
    b_estimate: np.ndarray | None


def measure(analysis: Analysis) -> Iterator[Part]:
    """RMSF of the units with its error; correlations and domains of their sites.

    Of the frames around the start alone, where others reach further.
    """
    near = analysis.around_start
    if len(analysis.frames if near is None else analysis.frames[near]) < 4:
        raise ValueError("it needs at least 4 frames")
    units, blocks = analysis[Units], _frame_blocks(analysis)
    moved = _superposed(analysis, near)
    found = flexibility(moved, units.unit, blocks)
    yield UnitFlexibility(found, _b_estimate(analysis))
    if len(units.labels) >= 4 and not found.still:
        far = None if near is None else _superposed(analysis, ~near)
        yield from domains(analysis, moved, blocks, far)


def _superposed(analysis: Analysis, some: np.ndarray | None) -> FrameStore:
    """The atoms of the units in some frames (F, bool), or all, once these are superposed."""
    atoms = analysis[Units].atoms
    chosen = np.unique(np.concatenate([atoms, analysis.fitted.ix]))
    moved = analysis.stored_positions(chosen, some)
    superpose_frames(moved, np.searchsorted(chosen, analysis.fitted.ix))
    return moved.of_atoms(np.searchsorted(chosen, atoms))


def _frame_blocks(analysis: Analysis) -> list[np.ndarray]:
    """Blocks of frames that count as independent: the white ones of an ensemble, else stretches
    longer than the memory of the first three principal components."""
    if analysis.kind == ENSEMBLE:
        numbers = np.asarray(analysis.frames if analysis.steps is None else analysis.steps)
        near = analysis.around_start
        return numbered_blocks(numbers if near is None else numbers[near], WHITE)
    components = analysis.get(Components)
    if components is None or components.stride > 1:
        return path_blocks(np.arange(len(analysis.frames), dtype=float))
    return path_blocks(components.found.projections[:, :3])


def _b_estimate(analysis: Analysis) -> np.ndarray | None:
    """(n,) B factors of a crystal of the reference, over their mean; NaN for units of no chain."""
    units = analysis[Units]
    chain = np.flatnonzero(units.of_chain)
    if len(chain) < LEAST_CHAIN:
        return None
    atoms = units.atoms[np.unique(units.unit, return_index=True)[1][chain]]
    values = np.full(len(units.labels), np.nan)
    names = units.chains[chain]
    numbers = np.cumsum(np.append(False, names[1:] != names[:-1]))
    values[chain] = node_b_factors(analysis[ReferenceStructure].positions[atoms], numbers)
    return values


def _convergence(analysis: Analysis) -> Verdict:
    if analysis.kind == TRANSITION:
        return Verdict("open", "A path has an end, and does not converge.", "")
    part = analysis.get(UnitFlexibility)
    if part is None:
        why = why_skipped(analysis, "flexibility")
        return Verdict("open", "Convergence cannot be judged.", why, "convergence")
    found = part.found
    if found.still:
        most = f"Nothing fluctuates by more than {found.rmsf.max():.1g} Å: all frames are alike."
        return Verdict("mixed", "Nothing moves.", most)
    details = (
        f"RMSF profiles of the two halves of the frames correlate at {found.correlation:.3f} and "
        f"differ by {100 * found.difference:.0f} % on average (converged: at least 0.95, at most "
        f"10 %). The precision follows from how far {found.blocks} independent groups of frames "
        "differ. It says how well frames made anew in the same way would repeat these numbers; "
        "accuracy, how near these are to the molecule's, is not known."
    )
    if analysis.kind == ENSEMBLE and len(analysis.frames) < 200:
        details += " Of fewer than 200 frames the precision may be better than said."
    if not found.converged:
        differ = "The flexibility is not converged: the halves differ."
        return Verdict("mixed", differ, details)
    is_ensemble = analysis.kind not in NO_ENSEMBLES
    what = "The flexibility is converged." if is_ensemble else "The halves agree."
    return Verdict("good", what, details, "convergence")


def _amplitude(analysis: Analysis) -> Verdict | None:
    asked, part = _asked(analysis), analysis.get(UnitFlexibility)
    if asked is None or part is None or analysis.kind != ENSEMBLE:
        return None
    reached = float(part.found.rmsf.mean())
    sentence = f"Amplitude: {asked:.2f} Å requested, {reached:.2f} Å reached."
    details = (
        "This is the mean RMSF after superposition. It is an input: which parts move more than "
        "others is a result, how far they move overall is not."
    )
    kind = "mixed" if reached < LEAST_REACHED * asked else "open"
    return Verdict(kind, sentence, details)


def _asked(analysis: Analysis) -> float | None:
    return asked_amplitude(analysis.source.parameters)


def _lines(analysis: Analysis) -> Iterator[tuple[str, str]]:
    found = analysis[UnitFlexibility].found
    size = "; its size is an input" if _amplitude(analysis) else ""
    yield (
        "flexibility",
        f"{found.rmsf.mean():.2f} Å, {precision(found.rmsf, found.error)} (mean RMSF{size})",
    )


def _facts(analysis: Analysis) -> Iterator[Fact]:
    if analysis.kind == TRANSITION:
        return
    found = analysis[UnitFlexibility].found
    what = "n atom" if analysis[Units].what == "atom" else " residue"
    size = "" if _asked(analysis) is None else ", an input"
    meaning = f"mean fluctuation of a{what} (RMSF){size}; {precision(found.rmsf, found.error)}"
    yield Fact(f"{found.rmsf.mean():.2f}", "Å", meaning)


def _tables(analysis: Analysis) -> Iterator[Table]:
    """The most flexible units, and ligands, which are not ranked with them."""
    found, units = analysis[UnitFlexibility].found, analysis[Units]
    order = np.argsort(-found.rmsf, kind="stable")
    share = np.divide(200 * found.error, found.rmsf, out=0 * found.rmsf, where=found.rmsf > 0)
    columns = {"name": units.labels, "rmsf": found.rmsf, "error": share}
    rmsf = ("RMSF (Å)", "{:.3f}".format)
    ranked = order[units.ranked[order]][:8]
    if analysis.kind == TRANSITION:
        caption = f"{units.what.capitalize()}s that move most on the way"
        yield table_of(caption, columns, {"name": (units.what, str), "rmsf": rmsf}, ranked)
        return
    error = ("precision (2 standard errors)", "{:.1f} %".format)
    caption = f"Most flexible {units.what}s" + ("" if found.converged else " (not converged)")
    shown: Shown = {"name": (units.what, str), "rmsf": rmsf, "error": error}
    yield table_of(caption, columns, shown, ranked)
    ligands = order[~units.ranked[order]][:8]
    yield table_of("Ligands", columns, {**shown, "name": ("ligand", str)}, ligands)


def _per_unit(analysis: Analysis) -> Columns:
    """One row per residue, or atom of a small molecule: RMSF with its error, domain, motions."""
    part, units = analysis[UnitFlexibility], analysis[Units]
    found = part.found
    columns: Columns = {
        units.what: units.labels,
        "chain": units.chains,
        "number": units.numbers,
        "of_chain": units.of_chain.astype(int),
        "rmsf_angstrom": np.round(found.rmsf, 4),
        "error_angstrom": np.round(found.error, 4),
        "first_half_angstrom": np.round(found.halves[0], 4),
        "second_half_angstrom": np.round(found.halves[1], 4),
        "converged": [int(found.converged)] * len(units.labels),
    }
    if part.b_estimate is not None:
        columns["b_estimate_over_mean"] = _known(part.b_estimate, 3)
    if RigidDomains in analysis:
        columns["domain"] = analysis[RigidDomains].of_unit + 1  # 0: none
        columns["hinge_share"] = analysis[RigidDomains].hinge_share
    moving = analysis.get(Components)
    if moving and moving.units is not None:
        results = moving.found
        for k, row in enumerate(participation(results.components[:MOTIONS])):
            values = np.full(len(units.labels), np.nan)
            values[moving.units] = np.sqrt(row * results.eigenvalues[k])
            columns[f"pc{k + 1}_angstrom"] = _known(values, 4)
    return columns


def _known(values: np.ndarray, digits: int) -> list[float | str]:
    """Rounded; "" where there is no number."""
    return ["" if value != value else round(value, digits) for value in values.tolist()]


def _draw(analysis: Analysis) -> Figure:
    """RMSF of each unit with twice its error; the halves where they do not agree. The way from one
    structure to another is one: it has neither."""
    found, units = analysis[UnitFlexibility].found, analysis[Units]
    figure, axes = style.new_figure()
    has_error = analysis.kind != TRANSITION
    if len(units.labels) <= NAMED_BARS:
        style.named_bars(axes, units.labels, found.rmsf, style.BLUE)
        axes.set_xlabel(units.what)
        if has_error:
            look = {"fmt": "none", "ecolor": style.INK, "lw": 1, "capsize": 2}
            axes.errorbar(np.arange(len(found.rmsf)), found.rmsf, 2 * found.error, **look)
    else:
        halves = () if found.converged or not has_error else found.halves
        draw_profile(axes, units.chains, found.rmsf, found.error if has_error else None, halves)
        domain_strip(axes, domains_of_units(analysis))
        style.chain_axis(axes, units.numbers, units.chains, units.what)
    _name(axes, analysis)
    return figure


def _name(axes: Axes, analysis: Analysis) -> None:
    found, what = analysis[UnitFlexibility].found, analysis[Units].what
    agree = "halves agree" if found.converged else "not converged: halves differ"
    title, top = (
        f"Flexibility: {agree}, {precision(found.rmsf, found.error)}",
        found.rmsf + 2 * found.error,
    )
    if analysis.kind == TRANSITION:
        title, top = f"How far {what}s move on the way", found.rmsf
    axes.set(ylabel="RMSF (Å)", title=title, ylim=(0, 1.04 * float(top.max()) or 1.0))


FLEXIBILITY = Measured(
    name="convergence",
    stage="flexibility",
    measure=measure,
    heading=FLEXIBLE,
    applies=has(UnitFlexibility),
    verdict=_convergence,
    lines=_lines,
    facts=_facts,
    tables=_tables,
    columns={"flexibility": _per_unit},
    values=lambda analysis: {
        "flexibility_mean": float(analysis[UnitFlexibility].found.rmsf.mean()),
        "flexibility_error_mean": float(analysis[UnitFlexibility].found.error.mean()),
        "flexibility_blocks": analysis[UnitFlexibility].found.blocks,
        "halves_correlation": analysis[UnitFlexibility].found.correlation,
        "halves_difference": analysis[UnitFlexibility].found.difference,
        "converged": analysis[UnitFlexibility].found.converged,
    },
    pictures=[
        Picture(
            "flexibility",
            _draw,
            caption(
                "Root mean square fluctuation about the average place, after superposition. The "
                "band (or error bar) is the precision: two standard errors. A strip along the "
                "axis has the colours of the domains.",
                path="Of this path only: with other pushes, or more of them, the profile would be "
                "another.",
                ensemble="About 19 of 20 values of a much longer run lie within the band. It is "
                "the error of having few frames; accuracy, how far the model is off, is not in it.",
                transition="Root mean square distance from the average place on the way, after "
                "superposition: what must move to get from one structure to the other. A strip "
                "along the axis has the colours of the domains.",
            ),
        )
    ],
    methods={
        "Flexibility": (
            "RMSF of each residue's CA (or P; else of its atoms but hydrogens) about the average, "
            "after superposition on it. Errors come from independent blocks of frames: those of a "
            "hundred that pliant sample makes, else stretches of ten correlation lengths. Relative "
            "variances of few blocks are shrunk towards their mean over all residues (Smyth 2004), "
            "and widened by Student's t."
        ),
        "Converged": (
            "The profiles of the two halves of the frames correlate by 0.95 or more and differ by "
            "10 % or less."
        ),
    },
)

AMPLITUDE = Measured(name="amplitude", verdict=_amplitude)
