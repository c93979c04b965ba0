# SPDX-License-Identifier: MIT
"""Side by side: the same broken structures, repaired by us and by OpenMM, measured by one ruler."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np

from pliant.checks.findings import SKIPPED, Finding, verdict
from pliant.checks.sample import Sample
from pliant.measure import bars as _bars
from pliant.trajectory.chosen_frames import choose_frames

DISPLACEMENTS = (0.01, 0.03, 0.1, 0.3)  #: Angstrom, standard deviation of each coordinate
MOST_STRUCTURES = 5
REPEATS = 5
BUDGET_SECONDS = 20.0  #: for one method at one displacement


@dataclass
class Result:
    """One method on the structures broken by one displacement."""

    displacement: float  #: Angstrom
    structures: int = 0
    whole: int = 0  #: repaired to the tolerance, as measured by us
    residual_before: float = float("nan")  #: median
    residual_after: float = float("nan")  #: median; not a number if most have none
    worst_residual_after: float = float("nan")
    seconds: float = float("nan")  #: median over structures of the median over repeats
    ready_seconds: float = float("nan")  #: once, before the first structure
    outcome: str = ""  #: "whole", or what became of those that are not
    failures: dict[str, int] = field(default_factory=dict)  #: how many of each kind are not whole
    claimed: int | None = None  #: ours: said to have converged
    false_claims: int | None = None  #: ours: of these, not whole as measured


@dataclass
class Method:
    """A way of repairing, and what it did."""

    name: str
    whose: str  #: "pliant" or "openmm"
    description: str
    results: list[Result] = field(default_factory=list)


@dataclass
class Contest:
    """Broken structures and the intact ones that they were made of."""

    sample: Sample
    tolerance: float  #: relative
    displacements: Sequence[float]
    intact: np.ndarray  #: (S, N, 3) Angstrom
    broken: np.ndarray  #: (D, S, N, 3) Angstrom, by each displacement
    note: str = ""


def prepare_contest(sample: Sample, displacements: Sequence[float], seed: int) -> Contest:
    """Breaks some of the sampled frames, whole ones if there are, by each displacement."""
    pool = sample.positions[sample.converged] if sample.converged.any() else sample.positions
    intact = pool[choose_frames(len(pool), MOST_STRUCTURES)]
    broken = np.array(
        [_bars.displaced(intact, size, seed + k) for k, size in enumerate(displacements)]
    )
    return Contest(
        sample, sample.openmm_tolerance(sample.positions), tuple(displacements), intact, broken
    )


def describe(contest: Contest, j: int, after: np.ndarray, seconds: np.ndarray) -> Result:
    """Measures structures (S, N, 3) Angstrom that were made of contest.broken[j]."""
    before = contest.sample.residuals(contest.broken[j])
    result = Result(contest.displacements[j], residual_before=float(np.median(before)))
    if len(after) == 0:
        return result
    residual = contest.sample.residuals(after)
    accepted = contest.tolerance * (1 + 1e-9) + _float_floor(contest)
    whole = residual <= accepted  # false for what is not a number
    result.structures, result.whole = len(after), int(whole.sum())
    result.residual_after = float(np.median(residual))
    result.worst_residual_after = float(np.max(residual))
    result.seconds = float(np.median(seconds))
    result.failures = _failures_of(residual, before[: len(after)], whole)
    words = [f"{count} of {len(after)} {kind}" for kind, count in result.failures.items()]
    result.outcome = ", ".join(words) or "whole"
    return result


def _float_floor(contest: Contest) -> float:
    recording = contest.sample.recording
    triangles = _bars.isolated_triangles(recording.bars, recording.atom_count)
    return 2 * _bars.FLOAT_ROUNDING if len(triangles) else 0.0


def _failures_of(residual: np.ndarray, before: np.ndarray, whole: np.ndarray) -> dict[str, int]:
    finite = np.isfinite(residual)
    kinds = {
        "not finite": ~finite,
        "diverged": finite & ~whole & (residual > before),
        "stopped short": finite & ~whole & (residual <= before),
    }
    return {kind: int(mask.sum()) for kind, mask in kinds.items() if mask.any()}


def check_honesty(methods: Sequence[Method]) -> Finding:
    """What we call converged is whole when measured anew, and nothing is not a number."""
    title = "what our resolver calls converged is whole"
    mine = [r for method in methods if method.whose == "pliant" for r in method.results]
    total, whole = sum(r.structures for r in mine), sum(r.whole for r in mine)
    if not total:
        return Finding("resolver_honest", title, SKIPPED, notes=["the framework has no bar"])
    claimed, false = sum(r.claimed or 0 for r in mine), sum(r.false_claims or 0 for r in mine)
    finding = Finding(
        "resolver_honest",
        title,
        verdict(false == 0),
        measured=f"{claimed - false} of {claimed}",
        allowed="all",
        figures={"structures": total, "claimed": claimed, "whole": whole, "false_claims": false},
    )
    if claimed < total:
        finding.notes.append(
            f"ours did not converge on {total - claimed} of {total} broken structures, and said so"
        )
    return finding


def as_json(methods: Sequence[Method]) -> list[dict[str, Any]]:
    """The methods and their results as JSON has them."""
    made = [asdict(method) for method in methods]
    for result in (result for method in made for result in method["results"]):
        del result["failures"]  # as text in the outcome
    return made
