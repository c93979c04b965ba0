# SPDX-License-Identifier: MIT
"""The conformers of one molecule: starts, candidates, energies, and those that are kept."""

from __future__ import annotations

import time
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from pliant._core import InputError, PliantWarning
from pliant.base.console import counted
from pliant.base.said import noted
from pliant.jobs.conformers import core
from pliant.jobs.conformers.axes import Axis, axes_of, hands_text, said_of
from pliant.jobs.conformers.energies import OWN, energy_of
from pliant.jobs.conformers.options import ConformerOptions
from pliant.jobs.conformers.subject import Subject


@dataclass
class Made:
    """What was made of one molecule, lowest energy first."""

    subject: Subject
    positions: npt.NDArray[np.float64]  #: (n, N, 3) Angstrom
    starts: npt.NDArray[np.int64]  #: (n,) from 0
    energies: npt.NDArray[np.float64] | None  #: (n,) kcal/mol
    energy_name: str  #: in words; "" where none was asked for
    rest: npt.NDArray[np.float64]  #: (S, N, 3) Angstrom, the starts: lengths at rest
    worst_bar: float  #: relative; nan once a force field has minimised
    asked: int
    minimised: bool = False
    notes: list[str] = field(default_factory=list)
    seconds: dict[str, float] = field(default_factory=dict)  #: by stage
    axes: list[Axis] = field(default_factory=list)  #: that cannot turn


def make(subject: Subject, options: ConformerOptions, threads: int = 1) -> Made:
    """The conformers of a molecule. Raises InputError and OptionError as the library does."""
    seconds: dict[str, float] = {}
    with noted() as notes:
        with _timed(seconds, "draw"):
            axes = axes_of(subject.structure, lambda: subject.molecule)
            drawn = core.draw(subject.structure, options, threads, both_hands=subject.hands_open)
        if len(drawn.positions) == 0:
            raise InputError(f"none of {options.frames} candidates is whole")
        with _timed(seconds, "energy"):
            energy = energy_of(
                options.energy, subject.structure, lambda: subject.molecule, options.minimise
            )
            energies = drawn.score if options.energy != "none" else np.zeros_like(drawn.score)
            if energy is not None:
                energies = energy.own_share * drawn.score
                energies += [energy.of(one) for one in drawn.positions]
        positions, of_start = drawn.positions, drawn.start
        with _timed(seconds, "choose"):
            kept = core.choose(subject.structure, positions, energies, options)
            positions, of_start, energies = positions[kept], of_start[kept], energies[kept]
        if energy is not None and (options.minimise or energy.of_kept):
            with _timed(seconds, "minimise" if options.minimise else "energy"):
                if options.minimise:
                    positions = np.array([energy.minimised(one) for one in positions])
                energies = np.array([(energy.of_kept or energy.of)(one) for one in positions])
                kept = _with_energy(energies, energy.name)
                chosen = core.choose(subject.structure, positions[kept], energies[kept], options)
                kept = kept[chosen]
                positions, of_start, energies = positions[kept], of_start[kept], energies[kept]
    has_energy = options.energy != "none"
    name = energy.name if energy is not None else OWN if has_energy else ""
    minimised = options.minimise and energy is not None
    return Made(
        subject,
        positions,
        of_start,
        energies if has_energy else None,
        name,
        drawn.starts,
        np.nan if minimised else drawn.worst_bar,
        options.max,
        minimised,
        subject.notes
        + said_of(axes, subject.structure.positions, is_open=subject.hands_open)
        + notes,
        seconds,
        axes,
    )


def as_sdf(made: Made) -> str:
    """The conformers as records of an SDF, with the data items of the molecule and of ours."""
    subject = made.subject
    parts = []
    for k, positions in enumerate(made.positions):
        parts += [subject.text(positions), subject.block.items]
        parts += [f"> <{name}>\n{value}\n\n" for name, value in items_of(made, k)]
        parts.append("$$$$\n")
    return "".join(parts)


def items_of(made: Made, k: int) -> list[tuple[str, str]]:
    """Name and value of each data item of conformer k."""
    items = [("pliant_conformer", str(k + 1)), ("pliant_start", str(made.starts[k] + 1))]
    if made.axes:
        items.append(("pliant_axes", hands_text(made.axes, made.positions[k])))
    if made.energies is not None:
        items.append(("pliant_energy", f"{made.energies[k]:.3f}"))
        items.append(("pliant_energy_name", made.energy_name))
    if made.minimised:
        items.append(("pliant_lengths", "minimised: lengths and angles are the force field's"))
    else:
        items.append(("pliant_worst_bar", f"{made.worst_bar:.1e}"))
        if made.starts[k] not in made.starts[:k]:
            items.append(("pliant_start_positions", _table(made.rest[made.starts[k]])))
    return items


def _table(positions: npt.NDArray[np.float64]) -> str:
    """A line for each atom, Angstrom."""
    return "\n".join(f"{x:.4f} {y:.4f} {z:.4f}" for x, y, z in positions)


def _with_energy(energies: npt.NDArray[np.float64], name: str) -> npt.NDArray[np.int64]:
    """Numbers of those that have one; a note counts others. Raises InputError if none has."""
    kept = np.flatnonzero(np.isfinite(energies))
    without, method = len(energies) - len(kept), name.split(",")[0]
    if len(kept) == 0:
        raise InputError(f"{method}: no energy of {counted(without, 'conformer')}")
    if without:
        left = f"{counted(without, 'conformer')} left out: {method} does not converge"
        warnings.warn(left, PliantWarning, stacklevel=2)
    return kept


@contextmanager
def _timed(seconds: dict[str, float], stage: str) -> Iterator[None]:
    began = time.process_time()
    yield
    seconds[stage] = seconds.get(stage, 0.0) + time.process_time() - began
