# SPDX-License-Identifier: MIT
"""What a section of the report of one file has besides those of others: it measures."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass

import numpy as np

from pliant.base.verdict import Verdict
from pliant.measure.stages.analysis import Analysis
from pliant.measure.stages.parts import Part
from pliant.report.page.html import sentence
from pliant.report.section import Columns, Section
from pliant.trajectory.chosen_frames import choose_frames
from pliant.trajectory.kind import ENSEMBLE, PATH, TRANSITION


@dataclass(frozen=True)
class Measured(Section[Analysis]):
    """A question that the frames of one file answer."""

    stage: str = ""  #: what is measured: goes by this name where it is left out
    #: returns parts, or raises ValueError with the reason why there are none
    measure: Callable[[Analysis], Iterable[Part]] | None = None
    per_frame: Callable[[Analysis], Columns] = lambda analysis: {}  #: columns of frames.csv


def has(part: type[Part]) -> Callable[[Analysis], bool]:
    """Whether a part is there, for `applies`."""
    return lambda analysis: part in analysis


def told(
    label: str, verdict: Callable[[Analysis], Verdict | None]
) -> Callable[[Analysis], list[tuple[str, str]]]:
    """The sentence of a verdict as a line."""
    return lambda analysis: [(label, one.sentence) for one in [verdict(analysis)] if one]


def caption(
    text: str, *, path: str = "", ensemble: str = "", transition: str = ""
) -> Callable[[Analysis], str]:
    """What a figure shows; what must be said beside that of a path of pushes, and of independent
    frames; and what it shows of a path between structures, if something else."""

    def of(analysis: Analysis) -> str:
        if analysis.kind == TRANSITION and transition:
            return transition
        more = {PATH: path, ENSEMBLE: ensemble}.get(analysis.kind, "")
        return f"{text} {more}".strip()

    return of


def why_skipped(analysis: Analysis, stage: str) -> str:
    """Why something was not measured, as a sentence; "" where it was."""
    why = analysis.skipped.get(stage, "")
    return sentence(why) if why else ""


#: frames whose chemistry and contacts are looked at, spread over all
LOOKED_AT = 100


def spread(analysis: Analysis) -> np.ndarray:
    """Places of at most LOOKED_AT frames, spread over those analysed."""
    return choose_frames(len(analysis.frames), LOOKED_AT)
