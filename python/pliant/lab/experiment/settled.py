# SPDX-License-Identifier: MIT
"""The last word on each claim: this experiment's verdict beside the sweep of settings."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pliant.lab.experiment.claims import CLAIMS, Claim
from pliant.lab.experiment.heat_maps import WORDS, axes_of, shares
from pliant.lab.experiment.settings import Settings
from pliant.lab.experiment.statistics import Evidence
from pliant.lab.experiment.sweep import TOLERANCES, Point
from pliant.lab.experiment.verdict import DEPENDS, FAILS, HOLDS, OPEN, UNTESTED, Verdict

NEARLY_ALL = 0.9  #: share of the settings of the sweep in which a claim that holds must hold
TOO_SMALL = "; whether elsewhere too, a sweep of so few graphs and pushes cannot tell"


@dataclass
class Settled:
    """A claim, what each yardstick says, and the verdict over all."""

    claim: Claim
    by_yardstick: dict[str, Verdict]  #: of this experiment
    here: Verdict  #: of this experiment, all yardsticks together
    held_by: dict[str, int]  #: settings of the sweep in which every statement holds, by yardstick
    settings_held: int  #: the same by all yardsticks at once
    settings: int  #: settings of the sweep in which pushes broke bars
    word: str
    on_what: str


def settle(all_evidence: dict[str, Evidence], points: Sequence[Point]) -> list[Settled]:
    """Every claim, in the order of the table."""
    start = all_evidence["sweeps"].table.settings
    return [_settle_one(claim, all_evidence, list(points), start) for claim in CLAIMS]


def _settle_one(
    claim: Claim, all_evidence: dict[str, Evidence], points: list[Point], start: Settings
) -> Settled:
    by_yardstick = {name: claim.judged(all_evidence[name]) for name in claim.yardsticks}
    here = claim.judged_by_all(all_evidence)
    mine = [point for point in points if point.claim == claim.id and point.statements]
    held, total = _settings_held(mine)
    word, on_what = _last_word(here, mine, held, total)
    if word == DEPENDS and total:
        on_what = "; ".join(filter(None, [on_what, _strongest_axis(mine, start)]))
    counted = _held_by(mine)
    held_by = {name: counted.get(name, 0) for name in claim.yardsticks}
    return Settled(claim, by_yardstick, here, held_by, held, total, word, on_what)


def settings_text(one: Settled) -> str:
    """ "77 of 77", or "sweeps 0, passes 28 of 77" where yardsticks differ; "-" without a sweep."""
    if not one.settings:
        return "-"
    if len(set(one.held_by.values())) == 1 and one.settings_held == one.held_by.get("sweeps"):
        return f"{one.settings_held} of {one.settings}"
    counts = ", ".join(f"{WORDS[name]} {held}" for name, held in one.held_by.items())
    return f"{counts} of {one.settings}"


def _settings_held(points: list[Point]) -> tuple[int, int]:
    """In how many settings every statement holds by every yardstick, and of how many."""
    answers: dict[object, bool] = {}
    for p in points:
        place = (p.tolerance_length, p.force, p.size, p.box, p.consecutive)
        answers[place] = answers.get(place, True) and p.holding == p.statements
    return sum(answers.values()), len(answers)


def _last_word(here: Verdict, points: list[Point], held: int, total: int) -> tuple[str, str]:
    """Holds or fails only if the sweep agrees in nearly all of its settings.

    A sweep that is too small leaves open what it would have to decide: so a quick report never says
    other than a full one.
    """
    if not total or here.word in (DEPENDS, UNTESTED):
        return here.word, here.on_what
    if not all(point.is_full for point in points):
        return OPEN, f"{here.word} here{TOO_SMALL}"
    if here.word == HOLDS and held < NEARLY_ALL * total:
        return DEPENDS, f"holds here, and in {held} of {total} settings of the sweep"
    most = max(_held_by(points).values())
    if here.word == FAILS and most > (1.0 - NEARLY_ALL) * total:
        return DEPENDS, f"fails here, but holds in {most} of {total} settings of the sweep"
    return here.word, here.on_what


def _held_by(points: list[Point]) -> dict[str, int]:
    """By yardstick: in how many settings every statement holds."""
    held: dict[str, int] = {}
    for p in points:
        held[p.yardstick] = held.get(p.yardstick, 0) + (p.holding == p.statements)
    return held


def _strongest_axis(points: list[Point], start: Settings) -> str:
    """Along which axis of the sweep the share of statements that hold changes most."""
    sweeps = [point for point in points if point.yardstick == "sweeps"]
    rows = [("tolerance", *_by_tolerance(sweeps))]
    for label, values, texts, value_of in axes_of(start, sweeps):
        grid = np.ma.masked_less(shares(sweeps, values, value_of), 0.0)
        means = grid.mean(axis=1)
        if not np.ma.getmaskarray(means).all():
            rows.append((label.split(" (")[0].split(",")[0], texts, means))
    label, texts, means = max(rows, key=lambda row: float(np.ma.max(row[2]) - np.ma.min(row[2])))
    low, high = int(np.ma.argmin(means)), int(np.ma.argmax(means))
    if means[high] - means[low] < 0.05:
        return "alike over the whole sweep"
    texts = [text.replace("\n", " ") for text in texts]
    return (
        f"in the sweep most on {label}: {100 * means[low]:.0f} % of its statements hold at "
        f"{texts[low]}, {100 * means[high]:.0f} % at {texts[high]}"
    )


def _by_tolerance(points: list[Point]) -> tuple[list[str], np.ndarray]:
    means = []
    for tolerance in TOLERANCES:
        found = [p.holding / p.statements for p in points if p.tolerance_length == tolerance]
        means.append(np.mean(found) if found else np.nan)
    return [
        f"{tolerance:.0e}".replace("e-0", "e-") for tolerance in TOLERANCES
    ], np.ma.masked_invalid(np.array(means))
