# SPDX-License-Identifier: MIT
"""Frames whose domains turned, of structures with side chains.

How near those of ``reach`` come to the other known state, and how those of ``turns`` are built,
beside those of ``modes`` and the start.
"""

from __future__ import annotations

import numpy as np

from pliant._core import align
from pliant.lab.sources import Files, Source
from pliant.lab.structures import Trace, amino_part, chain_part, read_quietly, trace_of
from pliant.lab.validity.measure import CLASHES
from pliant.lab.validity.rows import Row
from pliant.lab.validity.stereochemistry import Stereochemistry
from pliant.lab.validity.subject import Subject
from pliant.measure import agreement as alike


def state_rows(subject: Subject, goal: Trace, name: str) -> list[Row]:
    """From one state alone to the other, and what was made on the way."""
    turns, modes = (subject.ensemble(sampler=one).look for one in ("turns", "modes"))
    return [nearest_row(subject, goal, name), *built_rows(turns, modes, name)]


def goal_trace(files: Files, source: Source) -> Trace:
    """Alpha carbons of a state. Raises MissingSourceError."""
    return trace_of(chain_part(amino_part(read_quietly(files.find(source))), source.chain))


def nearest_row(subject: Subject, goal: Trace, name: str) -> Row:
    """R.m.s. distance of alpha carbons of the nearest frame of each sampler."""
    pairs = align(subject.trace.sequence, goal.sequence)
    there = goal.positions[pairs[:, 1]]

    def nearest(frames: np.ndarray) -> float:
        apart = alike.superposed(frames[:, pairs[:, 0]], there) - there
        return float(np.sqrt((apart**2).sum(axis=2).mean(axis=1)).min())

    found = {s: nearest(subject.ensemble(sampler=s).frames) for s in ("reach", "turns", "modes")}
    at_start = nearest(subject.trace.positions[None])
    note = (
        f"{at_start:.2f} in the start, {found['turns']:.2f} of turns, {found['modes']:.2f} of modes"
    )
    return Row(name, "nearest frame of reach, Angstrom", found["reach"], note=note)


def built_rows(turns: Stereochemistry, modes: Stereochemistry, name: str) -> list[Row]:
    """Turned frames; those of modes and the start are in the notes."""

    def row(figure: str, values: list[float], start: float, **goals: float | bool) -> Row:
        note = f"{start:.2f} in the start, {values[1]:.2f} in frames of modes"
        return Row(name, f"turns: {figure}", values[0], note=note, **goals)  # type: ignore[arg-type]

    both, percent = (turns, modes), 100.0
    start, clashes = percent * turns.outliers_of_start, turns.clashes_of_start
    found = [
        row("Ramachandran outliers, %", [percent * one.outliers for one in both], start,
            must=start + 1.0, aim=start + 0.5, least=False),
        row("unusual chi1 and chi2, %", [percent * one.rotamers for one in both],
            percent * turns.rotamers_of_start),
        row(CLASHES, [one.clashes for one in both], clashes,
            must=clashes, aim=clashes, least=False),
    ]  # fmt: skip  # a row each
    found[0].error = percent * float(np.std(turns.outliers_of_frames) / np.sqrt(turns.frames))
    return found
