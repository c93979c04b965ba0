# SPDX-License-Identifier: MIT
"""What the frames are, how they were drawn, and a table with what was measured of each."""

from __future__ import annotations

import numpy as np

from pliant.base.console import listed
from pliant.base.verdict import Verdict
from pliant.measure.stages.analysis import Analysis
from pliant.report.section import Columns
from pliant.report.sections.flexible import NO_ENSEMBLES
from pliant.report.sections.measured import Measured
from pliant.trajectory.drawn_by import DRAWN_BY
from pliant.trajectory.kind import ENSEMBLE, MEANING

#: share of frames that may have been drawn again
MOST_DRAWN_AGAIN = 0.05
#: so many of them are named
NAMED = 10
#: observables of a recording that go into the table of frames as they are
RECORDED = tuple(
    "sweeps projections root_joint redraws contacts_held contacts_broken contacts_off".split()
)


def _what_it_is(analysis: Analysis) -> Verdict:
    sentence, details = MEANING[analysis.kind]
    kind = "mixed" if analysis.kind in NO_ENSEMBLES else "open"
    return Verdict(kind, f"{sentence}.", details)


def frame_numbers(analysis: Analysis) -> Columns:
    """With which the table of frames begins."""
    steps = {} if analysis.steps is None else {"step": analysis.steps}
    return {"frame": analysis.frames, **steps, "time_ps": analysis.times}


def drawn_by(analysis: Analysis, places: np.ndarray | None = None) -> Columns:
    """How frames were drawn, where that is not the same of all. places: of some frames alone."""
    kinds = analysis.observable("sampler")
    if kinds is None or not kinds.any():
        return {}
    return {"drawn_by": [DRAWN_BY[k] for k in (kinds if places is None else kinds[places])]}


def _recorded(analysis: Analysis) -> Columns:
    every = {name: analysis.observable(name) for name in RECORDED}
    return {name: values for name, values in every.items() if values is not None}


def _draws(analysis: Analysis) -> Verdict | None:
    """Which frames are none of the first draw, and so not quite what the network asked for."""
    redraws = analysis.observable("redraws")
    if redraws is None or analysis.kind != ENSEMBLE:
        return None
    again, count = analysis.frames[redraws > 0], len(redraws)
    sentence, details = "No frame had to be redrawn.", ""
    if len(again):
        sentence = f"{len(again)} of {count} frames had to be redrawn."
        details = (
            f"The first attempts at frames {listed([str(frame) for frame in again], NAMED)} "
            f"failed; each took up to {int(redraws.max()) + 1} attempts. Motions in these "
            "directions are under-represented."
        )
    missing = _missing_frames(analysis)
    if missing:
        details += f" {missing} frames could not be resolved at all and are left out."
    share = (len(again) + missing) / (count + missing)
    kind = "good" if share <= MOST_DRAWN_AGAIN else "mixed"
    return Verdict(kind, sentence, details.strip(), "few frames redrawn")


def _missing_frames(analysis: Analysis) -> int:
    if analysis.steps is None or analysis.options.step not in (None, 1):
        return 0
    return int(analysis.steps[-1] - analysis.steps[0] + 1 - len(analysis.steps))


KIND = Measured(
    name="what it is",
    verdict=_what_it_is,
    methods={
        "Frames": (
            "All counts of frames and atoms begin at 0. A step of a geometric run is a push and "
            "its resolution, not a time."
        ),
        "Superposition": "Frames are fitted by least squares (Kabsch) with equal weights.",
    },
)

DRAWS = Measured(
    name="draws",
    verdict=_draws,
    per_frame=lambda analysis: _recorded(analysis) | drawn_by(analysis),
)
