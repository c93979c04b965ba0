# SPDX-License-Identifier: MIT
"""From numbers to a verdict: statements that a bootstrap can affirm, deny or leave open."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

import numpy as np

HOLDS, FAILS, OPEN, DEPENDS, UNTESTED = "holds", "fails", "open", "depends", "untested"
CONFIDENCE = 0.95  #: share of the replicates that must agree with the sample


@dataclass
class Statement:
    """One comparison of numbers. `holds[0]` is the sample's answer, the rest the replicates'."""

    text: str  #: "1-cycle: mean of bfs_cycle 0.5 below that of random 0.5"
    numbers: str  #: the numbers compared, with their intervals
    holds: np.ndarray  #: (R + 1) bool
    tags: dict[str, str] = field(default_factory=dict)  #: class, technique, weighting, yardstick

    @property
    def share(self) -> float:
        """Share of the replicates in which it holds."""
        return float(np.mean(self.holds[1:])) if len(self.holds) > 1 else float(self.holds[0])

    @property
    def verdict(self) -> str:
        """Holds or fails if 95 % of the replicates say what the sample says; else open."""
        if self.holds[0]:
            return HOLDS if self.share >= CONFIDENCE else OPEN
        return FAILS if self.share <= 1.0 - CONFIDENCE else OPEN


@dataclass
class Verdict:
    """What all statements of a claim together say."""

    word: str  #: holds, fails, depends or untested
    on_what: str  #: of depends: what decides
    statements: list[Statement]

    @property
    def share(self) -> float:
        """Share of the statements that hold in the sample; the replicates are not asked."""
        return float(np.mean([bool(s.holds[0]) for s in self.statements]))


def verdict_of(statements: list[Statement]) -> Verdict:
    """Holds if every statement does, fails if none does and one fails, else depends on what."""
    found = {statement.verdict for statement in statements}
    if not found:
        return Verdict(UNTESTED, "the table has no such rows", statements)
    if found == {HOLDS}:
        return Verdict(HOLDS, "", statements)
    if HOLDS not in found and FAILS in found:
        return Verdict(FAILS, _counted(statements) if OPEN in found else "", statements)
    return Verdict(DEPENDS, _deciding(statements), statements)


def _deciding(statements: list[Statement]) -> str:
    """The first tag that sorts what holds from what does not, or the count of each."""
    for tag in ("yardstick", "class", "technique", "weighting", "number"):
        answers = _by_value(statements, tag)
        uniform = all(len(found) == 1 for found in answers.values())
        if len(answers) > 1 and uniform:
            words = {value: found.copy().pop() for value, found in answers.items()}
            return f"on the {tag}: " + _grouped(words)
    return "of its statements " + _counted(statements)


def _by_value(statements: list[Statement], tag: str) -> dict[str, set[str]]:
    answers: dict[str, set[str]] = {}
    for statement in statements:
        answers.setdefault(statement.tags.get(tag, ""), set()).add(statement.verdict)
    return answers


def _grouped(words: dict[str, str]) -> str:
    phrases = []
    for word in (HOLDS, FAILS, OPEN):
        values = [value for value, found in words.items() if found == word]
        if values:
            phrases.append(f"{_verb(word)} {_listed(values)}")
    return "; ".join(phrases)


def _verb(word: str) -> str:
    return {HOLDS: "holds for", FAILS: "fails for", OPEN: "open for"}[word]


def _listed(values: Iterable[str]) -> str:
    values = list(values)
    return ", ".join(values[:-1]) + " and " + values[-1] if len(values) > 1 else values[0]


def _counted(statements: list[Statement]) -> str:
    words = [statement.verdict for statement in statements]
    counts = [(word, words.count(word)) for word in (HOLDS, FAILS, OPEN)]
    verbs = {HOLDS: ("holds", "hold"), FAILS: ("fails", "fail"), OPEN: ("is open", "are open")}
    return ", ".join(f"{count} {verbs[word][count > 1]}" for word, count in counts if count)
