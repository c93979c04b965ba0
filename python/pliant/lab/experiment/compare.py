# SPDX-License-Identifier: MIT
"""The kinds of statements that claims are made of: below, lowest, worst by far, mode, alike."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pliant.lab.experiment.settings import Combination
from pliant.lab.experiment.statistics import Evidence, Statistics, number, with_interval
from pliant.lab.experiment.verdict import Statement

# What the thesis says in words; the numbers are ours, and the page gives them.
BY_FAR = 1.5  #: "by far", "much", "significantly worse": times the other
EXTREMELY = 2.0  #: "extremely high": times the other
ALIKE = 1.5  #: "alike", "similar": the larger is at most so many times the smaller


def name_of(combination: Combination) -> str:
    """As a reader writes it: "bfs_cycle 0.5"."""
    technique, weighting = combination
    return f"{technique} {weighting:g}" if weighting >= 0 else technique


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
        a, b = self._both(what, one, other)
        if a is None or b is None:
            return
        relation = "at or below" if or_equal else "below"
        self._add(
            f"{what} of {name_of(one)} {relation} that of {name_of(other)}",
            f"{with_interval(a)} and {with_interval(b)}",
            a <= b if or_equal else a < b,
            one,
        )

    def times(self, what: str, one: Combination, other: Combination, factor: float) -> None:
        """`what` of one is at least `factor` times that of the other, which must be above 0."""
        a, b = self._both(what, one, other)
        if a is None or b is None:
            return
        self._add(
            f"{what} of {name_of(one)} at least {factor:g} times that of {name_of(other)}",
            f"{with_interval(a)} and {with_interval(b)}",
            (a >= factor * b) & (a > 0),
            one,
        )

    def alike(self, what: str, combinations: Sequence[Combination]) -> None:
        """The largest `what` is at most ALIKE times the smallest."""
        values = self._all(what, combinations)
        if len(values) < len(combinations):
            return
        low, high = np.min(values, axis=0), np.max(values, axis=0)
        shown = ", ".join(with_interval(value) for value in values)
        self._add(
            f"{what} of {_listed(combinations)} alike (within a factor of {ALIKE:g})",
            shown,
            high <= ALIKE * low,
            combinations[0],
        )

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
        if self.of(one) is None or not others:
            return
        mine, theirs = getattr(self.of(one), what), np.array(self._all(what, others))
        rival = int(np.argmin(theirs[:, 0]) if wins is np.less else np.argmax(theirs[:, 0]))
        self._add(
            f"{what} of {name_of(one)} {word} of {len(others) + 1}",
            f"{with_interval(mine)}; {word} of the others: {name_of(others[rival])} "
            f"{with_interval(theirs[rival])}",
            np.all(wins(mine, theirs), axis=0),
            one,
        )

    def mode_is(self, one: Combination, wanted: int) -> None:
        """The most frequent number is this one."""
        found = self.of(one)
        if found is not None:
            self._add(
                f"mode of {name_of(one)} is {wanted}",
                self._mode_text(found),
                found.mode == wanted,
                one,
            )

    def mode_not(self, one: Combination, other: int) -> None:
        """The most frequent number is another one."""
        found = self.of(one)
        if found is not None:
            self._add(
                f"mode of {name_of(one)} is not {other}",
                self._mode_text(found),
                found.mode != other,
                one,
            )

    def mode_above(self, one: Combination, other: Combination, or_equal: bool = False) -> None:
        """The most frequent number is above (or not below) that of the other."""
        a, b = self.of(one), self.of(other)
        if a is None or b is None:
            return
        relation = "at or above" if or_equal else "above"
        self._add(
            f"mode of {name_of(one)} {relation} that of {name_of(other)}",
            f"{self._mode_text(a)} and {self._mode_text(b)}",
            a.mode >= b.mode if or_equal else a.mode > b.mode,
            one,
        )

    def at_most(self, what: str, one: Combination, limit: float) -> None:
        """`what` is no larger than a number."""
        found = self.of(one)
        if found is not None:
            value = getattr(found, what)
            self._add(
                f"{what} of {name_of(one)} at most {limit:g}",
                with_interval(value),
                value <= limit,
                one,
            )

    def exactly(self, what: str, one: Combination, wanted: float) -> None:
        """`what` is a number, to the last bit."""
        found = self.of(one)
        if found is not None:
            value = getattr(found, what)
            self._add(
                f"{what} of {name_of(one)} is {wanted:g}",
                with_interval(value),
                value == wanted,
                one,
            )

    def sometimes_more(self, one: Combination, than: int) -> None:
        """Some push takes more."""
        found = self.of(one)
        if found is not None:
            share = np.mean(found.values > than)
            self._add(
                f"{name_of(one)} sometimes takes more than {than}",
                f"{100 * share:.1f} % of the pushes",
                np.full(len(found.mean), share > 0),
                one,
            )

    def add(self, text: str, numbers: str, holds: np.ndarray, tag: Combination) -> None:
        """Any other statement."""
        self._add(text, numbers, holds, tag)

    def _mode_text(self, found: Statistics) -> str:
        distinct, counts = np.unique(found.mode[1:], return_counts=True)
        spread = [
            f"{value} in {100 * count / len(found.mode[1:]):.0f} %"
            for value, count in zip(distinct, counts, strict=True)
        ]
        return number(found.mode[0]) + (f" ({', '.join(spread)})" if len(spread) > 1 else "")

    def _both(
        self, what: str, one: Combination, other: Combination
    ) -> tuple[np.ndarray | None, np.ndarray | None]:
        return self._one(what, one), self._one(what, other)

    def _one(self, what: str, combination: Combination) -> np.ndarray | None:
        found = self.of(combination)
        return None if found is None else getattr(found, what)

    def _all(self, what: str, combinations: Sequence[Combination]) -> list[np.ndarray]:
        found = [self.of(combination) for combination in combinations]
        return [getattr(statistics, what) for statistics in found if statistics is not None]

    def _add(self, text: str, numbers: str, holds: np.ndarray, one: Combination) -> None:
        tags = {
            "class": self.family,
            "technique": one[0],
            "weighting": f"{one[1]:g}",
            "yardstick": self.evidence.yardstick,
            "measure": text.split(" of ")[0] if " of " in text else "maximum",
        }
        self.statements.append(Statement(f"{self.family}: {text}", numbers, holds, tags))


def _listed(combinations: Sequence[Combination]) -> str:
    return ", ".join(name_of(combination) for combination in combinations)
