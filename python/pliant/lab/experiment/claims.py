# SPDX-License-Identifier: MIT
"""The claims of the thesis' chapter 5, each as statements that numbers can affirm or deny.

Where the thesis says "by far", "alike" or "very close", compare.py has the number that stands for
it; the page repeats it. Each claim is judged by every yardstick that can matter to it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from pliant.checks.weightings import WEIGHTINGS
from pliant.lab.experiment.compare import ALIKE, BY_FAR, EXTREMELY, Court
from pliant.lab.experiment.settings import reverse_techniques
from pliant.lab.experiment.statistics import YARDSTICKS, Evidence, shown
from pliant.lab.experiment.verdict import Statement, Verdict, verdict_of

RAGDOLL = ("random", 0.5)
CYCLE = ("random", "bfs_cycle", "dfs_cycle")
REVERSE = ("bfs_reverse", "dfs_reverse")
VERY_CLOSE = 1.1  #: "very close to 1"
LOW_SD = 0.5  #: "low standard deviation" of random 1.0 on trees


@dataclass(frozen=True)
class Claim:
    """A row of the table of claims."""

    id: str
    families: tuple[str, ...]
    section: str  #: of the thesis
    text: str  #: what it claims
    judge: Callable[[Court], None]  #: makes the statements on one family
    measured_as: str = ""  #: numbers that stand for the thesis' words
    contradiction: str = ""  #: where the thesis says otherwise itself
    techniques: tuple[str, ...] = ()
    effort_matters: bool = True  #: False: about modes only, which projections do not have

    @property
    def yardsticks(self) -> tuple[str, ...]:
        """By which it is judged."""
        passes = ("passes",) if set(self.techniques) & reverse_techniques() else ()
        return ("sweeps", *passes, *(("projections",) if self.effort_matters else ()))

    def judged(self, evidence: Evidence) -> Verdict:
        """The verdict by the yardstick of `evidence`."""
        return verdict_of(self._statements(evidence))

    def judged_by_all(self, all_evidence: dict[str, Evidence]) -> Verdict:
        """The verdict over all yardsticks that can matter to it."""
        found = [self._statements(all_evidence[yardstick]) for yardstick in self.yardsticks]
        return verdict_of([statement for statements in found for statement in statements])

    def _statements(self, evidence: Evidence) -> list[Statement]:
        statements: list[Statement] = []
        for family in self.families:
            court = Court(evidence, family)
            self.judge(court)
            statements += court.statements
        if evidence.yardstick != "projections":
            return statements
        return [s for s in statements if _about_effort(s)]


def _about_effort(statement: Statement) -> bool:
    """Not about single counts: those of projections follow the size of the graph."""
    return statement.tags["measure"] in ("mean", "spread") and " is " not in statement.text


def _t1(court: Court) -> None:
    for technique in ("bfs_tree", "dfs_tree"):
        court.exactly("mean", (technique, 1.0), 1)
        court.mode_is((technique, 1.0), 1)
        court.exactly("sd", (technique, 1.0), 0)


def _t2(court: Court) -> None:
    one = ("random", 1.0)
    court.at_most("mean", one, VERY_CLOSE)
    court.sometimes_more(one, 1)
    court.at_most("sd", one, LOW_SD)


def _t3(court: Court) -> None:
    for technique in ("bfs_tree", "dfs_tree", "random"):
        court.below("mean", (technique, 1.0), RAGDOLL)


def _t4(court: Court) -> None:
    """Main effects of a two-way table of means: spread over weightings against orderings."""
    found = [
        [court.of((technique, w)) for w in WEIGHTINGS]
        for technique in ("bfs_tree", "dfs_tree", "random")
    ]
    known = [[cell.mean for cell in row if cell is not None] for row in found]
    if any(len(row) < len(WEIGHTINGS) for row in known):
        return
    means = np.array(known)
    of_weighting, of_ordering = np.std(means.mean(0), axis=0), np.std(means.mean(1), axis=0)
    court.add(
        "spread of the mean over weightings above that over orderings",
        f"{shown(of_weighting)} and {shown(of_ordering)}",
        of_weighting > of_ordering,
        ("bfs_tree", 1.0),
    )


def _all_of(techniques: tuple[str, ...]) -> list[tuple[str, float]]:
    return [(technique, w) for technique in techniques for w in WEIGHTINGS]


def _c1(court: Court) -> None:
    court.lowest("mean", ("bfs_cycle", 0.5), _all_of(CYCLE))


def _c2(court: Court) -> None:
    for technique in ("dfs_cycle", "random"):
        court.lowest("mean", (technique, 0.5), _all_of((technique,)))


def _c3(court: Court) -> None:
    court.highest("mean", ("bfs_cycle", 1.0), _all_of(CYCLE))
    for w in (0.5, 0.75):
        court.times("mean", ("bfs_cycle", 1.0), ("bfs_cycle", w), BY_FAR)


def _c4(court: Court) -> None:
    for technique in ("bfs_cycle", "dfs_cycle"):
        court.below("mean", (technique, 0.5), RAGDOLL, or_equal=True)


def _c5(court: Court) -> None:
    for one in _all_of(("dfs_cycle", "random")):
        court.mode_is(one, 3)


def _c6(court: Court) -> None:
    for w in WEIGHTINGS:
        court.mode_is(("bfs_cycle", w), 1)
        for technique in ("dfs_cycle", "random"):
            court.mode_above((technique, w), ("bfs_cycle", w), or_equal=True)


def _c7(court: Court) -> None:
    court.times("sd", ("bfs_cycle", 1.0), ("bfs_cycle", 0.5), EXTREMELY)
    court.alike("sd", [(technique, 0.5) for technique in CYCLE])
    if court.family == "1-cycle":
        court.times("sd", ("bfs_cycle", 0.75), ("bfs_cycle", 0.5), BY_FAR)


def _r1(court: Court) -> None:
    court.lowest("mean", ("bfs_reverse", 0.5), _all_of(CYCLE + REVERSE))
    court.times("mean", ("bfs_reverse", 1.0), ("bfs_reverse", 0.5), BY_FAR)
    for technique in ("bfs", "dfs"):
        for w in WEIGHTINGS:
            court.alike("mean", [(f"{technique}_reverse", w), (f"{technique}_cycle", w)])


def _r2(court: Court) -> None:
    for w in WEIGHTINGS:
        if court.family == "2-cycle" and w == 0.5:
            court.mode_not(("dfs_reverse", w), 2)
        else:
            court.mode_is(("dfs_reverse", w), 2)
        court.mode_is(("bfs_reverse", w), 1 if w == 1.0 else 2)


def _r3(court: Court) -> None:
    for technique in ("bfs", "dfs"):
        court.below("sd", (f"{technique}_reverse", 0.5), (f"{technique}_cycle", 0.5))


def _a1(court: Court) -> None:
    for w in WEIGHTINGS:
        earlier = [(technique, w) for technique in CYCLE + REVERSE]
        court.highest("mean", ("bfs_adapt", w), [*earlier, RAGDOLL])
    for w in (0.5, 0.75):
        court.mode_above(("bfs_adapt", w), ("bfs_adapt", 1.0))
    for w in (0.75, 1.0):
        court.below("sd", ("bfs_adapt", 0.5), ("bfs_adapt", w))


def _b1(court: Court) -> None:
    for w in WEIGHTINGS:
        court.below("mean", ("bfs_random", w), ("bfs_adapt", w))
        court.alike("mean", [("bfs_random", w), ("bfs_cycle", w)])
    court.lowest("mean", ("bfs_random", 0.5), _all_of(("bfs_random",)))
    court.mode_is(("bfs_random", 1.0), 1)


BOTH = ("1-cycle", "2-cycle")

CLAIMS = (
    Claim("T1", ("tree",), "5.1.1", "bfs_tree and dfs_tree at 1.0: mean 1, mode 1, sd 0", _t1,
          techniques=("bfs_tree", "dfs_tree"), effort_matters=False),
    Claim("T2", ("tree",), "5.1.1",
          "random at 1.0: mean very close to 1, not always 1, low standard deviation", _t2,
          f"very close: at most {VERY_CLOSE:g}; low: at most {LOW_SD:g}",
          techniques=("random",), effort_matters=False),
    Claim("T3", ("tree",), "5.1.1",
          "three techniques beat Ragdoll: bfs_tree 1.0, dfs_tree 1.0, random 1.0", _t3,
          "a lower mean",
          techniques=("bfs_tree", "dfs_tree", "random")),
    Claim("T4", ("tree",), "5.1.1", "the weighting matters more than the ordering", _t4,
          "spread (standard deviation) of the mean over the three weightings against that over "
          "bfs_tree, dfs_tree and random",
          techniques=("bfs_tree", "dfs_tree", "random")),
    Claim("C1", BOTH, "5.2.1",
          "bfs_cycle 0.5 has the lowest mean among random, bfs_cycle and dfs_cycle at all "
          "weightings", _c1, techniques=CYCLE),
    Claim("C2", BOTH, "5.2.1", "dfs_cycle is best at 0.5; random is best at 0.5", _c2,
          "the lowest mean of its three weightings", techniques=("dfs_cycle", "random")),
    Claim("C3", BOTH, "5.2.1", "bfs_cycle 1.0 has by far the worst mean", _c3,
          f"the highest of nine means, and at least {BY_FAR:g} times that of bfs_cycle at 0.5 and "
          "0.75", techniques=CYCLE),
    Claim("C4", BOTH, "5.2.1", "bfs_cycle 0.5 and dfs_cycle 0.5 are at or below Ragdoll", _c4,
          contradiction="Section 5.2.2 begins: the average of dfs_cycle \"is still too high to be "
          "superior to Ragdoll\".", techniques=CYCLE),
    Claim("C5", ("1-cycle",), "5.2.1", "dfs_cycle and random have mode 3 at every weighting", _c5,
          techniques=("dfs_cycle", "random"), effort_matters=False),
    Claim("C6", BOTH, "5.2.1", "bfs_cycle has the lowest mode at every weighting, mode 1", _c6,
          "mode 1, and neither dfs_cycle nor random below it at the same weighting",
          "Section 5.2.2 says that bfs_reverse \"has dropped to a mode of 2\" at 0.5 and 0.75: "
          "from 1 that would be a rise.", techniques=CYCLE, effort_matters=False),
    Claim("C7", BOTH, "5.2.1",
          "sd of bfs_cycle 1.0 is extremely high; at 0.5 all sds are low and alike; bfs_cycle is "
          "inconsistent at 0.75 and 1.0 (1-cycle), 1.0 (2-cycle)", _c7,
          f"extremely high: {EXTREMELY:g} times that at 0.5; alike: within a factor of {ALIKE:g}; "
          f"inconsistent: {BY_FAR:g} times that at 0.5", techniques=CYCLE, effort_matters=False),
    Claim("R1", BOTH, "5.2.2",
          "reverse resembles cycle; bfs_reverse 0.5 is best of all, 1.0 far worse", _r1,
          f"resembles: means within a factor of {ALIKE:g} at each weighting; best: the lowest of "
          f"15 means; far worse: {BY_FAR:g} times",
          "Section 5.2.2 says that bfs_reverse 0.5 \"outperforms the other techniques\", and in "
          "the next sentence that bfs_cycle 0.5 \"is currently the technique with the lowest "
          "mean\". It calls the gain nominal there; section 5.3.1 calls it large. Whether one "
          "iteration is one direction (figure 5.5 prints the turning bar once for BFS) or the "
          "concatenated pair (twice for DFS) is not said.", techniques=CYCLE + REVERSE),
    Claim("R2", BOTH, "5.2.2",
          "modes: dfs_reverse 2 except 0.5 on 2-cycles; bfs_reverse 2 at 0.5 and 0.75, 1 at 1.0",
          _r2, techniques=REVERSE, effort_matters=False),
    Claim("R3", BOTH, "5.2.2", "sd of reverse at 0.5 below that of cycle at 0.5", _r3,
          techniques=("bfs_cycle", "dfs_cycle", *REVERSE), effort_matters=False),
    Claim("A1", ("1-cycle",), "5.3.1",
          "bfs_adapt is worse than all before, Ragdoll included; mode high except 1.0; sd high "
          "except 0.5", _a1,
          "worse: the highest mean at its weighting, and above Ragdoll; mode and sd: high beside "
          "those of the excepted weighting",
          techniques=("bfs_adapt", *CYCLE, *REVERSE)),
    Claim("B1", ("1-cycle",), "5.3.2",
          "bfs_random better than bfs_adapt, like bfs_cycle; best at 0.5; mode 1 at 1.0", _b1,
          f"like: means within a factor of {ALIKE:g}",
          techniques=("bfs_random", "bfs_adapt", "bfs_cycle")),
)  # fmt: skip  # a table: a row a line


def claim(identity: str) -> Claim:
    """The claim of that id."""
    return next(row for row in CLAIMS if row.id == identity)


def evidence_by_yardstick(evidence: Evidence) -> dict[str, Evidence]:
    """The same table by every yardstick."""
    return {name: evidence.with_yardstick(name) for name in YARDSTICKS}
