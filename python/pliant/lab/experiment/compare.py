# SPDX-License-Identifier: MIT
"""The kinds of statements that claims are made of: below, lowest, worst by far, mode, alike."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from pliant.lab.experiment.settings import Combination, label
from pliant.lab.experiment.statistics import Evidence, Statistics, number, shown
from pliant.lab.experiment.verdict import Statement

# What the thesis says in words; the numbers are ours, and the page gives them.
BY_FAR = 1.5  #: "by far", "much", "significantly worse": times the other
EXTREMELY = 2.0  #: "extremely high": times the other
ALIKE = 1.5  #: "alike", "similar": the larger is at most so many times the smaller


class Court:
    """Makes statements on one family of graphs; those without any data are left out."""

    def __init__(self, evidence: Evidence, family: str) -> None:
        self.evidence = evidence
        self.family = family
        self.statements: list[Statement] = []

    def of(self, combination: Combination) -> Statistics | None:
        """Statistics of a technique with its weighting; None without data."""
        return self.evidence.of(self.family, *combination)

    def below(
        self, what: str, one: Combination, other: Combination, or_equal: bool = False
    ) -> None:
        """`what` (mean or sd) of one is below that of the other."""
        for a, b in self._known(what, one, other):
            relation = "at or below" if or_equal else "below"
            text = f"{what} of {label(one)} {relation} that of {label(other)}"
            self.add(text, f"{shown(a)} and {shown(b)}", a <= b if or_equal else a < b, one)

    def times(self, what: str, one: Combination, other: Combination, factor: float) -> None:
        """`what` of one is at least `factor` times that of the other, which must be above 0."""
        for a, b in self._known(what, one, other):
            text = f"{what} of {label(one)} at least {factor:g} times that of {label(other)}"
            self.add(text, f"{shown(a)} and {shown(b)}", (a >= factor * b) & (a > 0), one)

    def alike(self, what: str, combinations: Sequence[Combination]) -> None:
        """The largest `what` is at most ALIKE times the smallest."""
        for values in self._known(what, *combinations):
            low, high = np.min(values, axis=0), np.max(values, axis=0)
            names = ", ".join(map(label, combinations))
            text = f"{what} of {names} alike (within a factor of {ALIKE:g})"
            self.add(text, ", ".join(map(shown, values)), high <= ALIKE * low, combinations[0])

    def lowest(self, what: str, one: Combination, others: Sequence[Combination]) -> None:
        """No other has as low a `what`."""
        self._extreme(what, one, others, "the lowest", np.less)

    def highest(self, what: str, one: Combination, others: Sequence[Combination]) -> None:
        """No other has as high a `what`."""
        self._extreme(what, one, others, "the highest", np.greater)

    def _extreme(
        self, what: str, one: Combination, others: Sequence[Combination], word: str, wins: np.ufunc
    ) -> None:
        others = [other for other in others if other != one and self.of(other) is not None]
        for mine, *rivals in self._known(what, one, *others) if others else ():
            theirs = np.array(rivals)
            best = int(np.argmin(theirs[:, 0]) if wins is np.less else np.argmax(theirs[:, 0]))
            self.add(
                f"{what} of {label(one)} {word} of {len(others) + 1}",
                f"{shown(mine)}; {word} of the others: {label(others[best])} {shown(theirs[best])}",
                np.all(wins(mine, theirs), axis=0),
                one,
            )

    def mode_is(self, one: Combination, wanted: int) -> None:
        """The most frequent number is this one."""
        for (mode,) in self._known("mode", one):
            self.add(f"mode of {label(one)} is {wanted}", _mode_text(mode), mode == wanted, one)

    def mode_not(self, one: Combination, other: int) -> None:
        """The most frequent number is another one."""
        for (mode,) in self._known("mode", one):
            self.add(f"mode of {label(one)} is not {other}", _mode_text(mode), mode != other, one)

    def mode_above(self, one: Combination, other: Combination, or_equal: bool = False) -> None:
        """The most frequent number is above (or not below) that of the other."""
        for a, b in self._known("mode", one, other):
            relation = "at or above" if or_equal else "above"
            text = f"mode of {label(one)} {relation} that of {label(other)}"
            holds = a >= b if or_equal else a > b
            self.add(text, f"{_mode_text(a)} and {_mode_text(b)}", holds, one)

    def at_most(self, what: str, one: Combination, limit: float) -> None:
        """`what` is no larger than a number."""
        for (value,) in self._known(what, one):
            text = f"{what} of {label(one)} at most {limit:g}"
            self.add(text, shown(value), value <= limit, one)

    def exactly(self, what: str, one: Combination, wanted: float) -> None:
        """`what` is a number, to the last bit."""
        for (value,) in self._known(what, one):
            self.add(f"{what} of {label(one)} is {wanted:g}", shown(value), value == wanted, one)

    def sometimes_more(self, one: Combination, than: int) -> None:
        """Some push takes more."""
        found = self.of(one)
        if found is not None:
            share = np.mean(found.values > than)
            self.add(
                f"{label(one)} sometimes takes more than {than}",
                f"{100 * share:.1f} % of the pushes",
                np.full(len(found.mean), share > 0),
                one,
            )

    def _known(self, what: str, *combinations: Combination) -> list[list[Any]]:
        """(R + 1) values of each, as the only entry of a list, which is empty without data."""
        found = [self.of(combination) for combination in combinations]
        return [[getattr(one, what) for one in found]] if None not in found else []

    def add(self, text: str, numbers: str, holds: np.ndarray, one: Combination) -> None:
        """A statement on a combination."""
        tags = {
            "class": self.family,
            "technique": one[0],
            "weighting": f"{one[1]:g}",
            "yardstick": self.evidence.yardstick,
            "measure": text.split(" of ")[0] if " of " in text else "maximum",
        }
        self.statements.append(Statement(f"{self.family}: {text}", numbers, holds, tags))


def _mode_text(mode: np.ndarray) -> str:
    distinct, counts = np.unique(mode[1:], return_counts=True)
    spread = [
        f"{value} in {100 * count / len(mode[1:]):.0f} %"
        for value, count in zip(distinct, counts, strict=True)
    ]
    return number(mode[0]) + (f" ({', '.join(spread)})" if len(spread) > 1 else "")
