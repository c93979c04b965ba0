# SPDX-License-Identifier: MIT
"""From numbers to a verdict: statements that a bootstrap can affirm, deny or leave open."""

from __future__ import annotations

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


TAGS = ("yardstick", "class", "technique", "weighting", "measure")


def _deciding(statements: list[Statement]) -> str:
    """The tag that sorts best what holds from what does not, with how many of its values hold."""
    gain, tag = max(((_gain(statements, tag), tag) for tag in TAGS), key=lambda pair: pair[0])
    answers = _by_value(statements, tag)
    if all(len(set(words)) == 1 for words in answers.values()) and len(answers) > 1:
        return f"on the {tag}: " + _grouped({value: words[0] for value, words in answers.items()})
    if gain < CLEAR_GAIN:
        return "on no single thing: " + _counted(statements)
    return f"mostly on the {tag}: " + _shares(answers)


#: share of the spread of answers that a tag must explain to be named
CLEAR_GAIN = 0.1


def _by_value(statements: list[Statement], tag: str) -> dict[str, list[str]]:
    answers: dict[str, list[str]] = {}
    for statement in statements:
        answers.setdefault(statement.tags.get(tag, ""), []).append(statement.verdict)
    return answers


def _gain(statements: list[Statement], tag: str) -> float:
    """Share of the variance of "it holds" that lies between the values of a tag."""
    holds = np.array([statement.verdict == HOLDS for statement in statements], float)
    if holds.std() == 0.0:
        return 0.0
    groups = [
        np.array([word == HOLDS for word in words], float)
        for words in _by_value(statements, tag).values()
    ]
    between = sum(len(group) * (group.mean() - holds.mean()) ** 2 for group in groups)
    return float(between / len(holds) / holds.var())


def _shares(answers: dict[str, list[str]]) -> str:
    """ "12 of 16 statements hold for passes, 0 of 32 for sweeps and projections"."""
    groups: dict[float, list[str]] = {}
    for value, words in answers.items():
        groups.setdefault(words.count(HOLDS) / len(words), []).append(value)
    phrases: list[str] = []
    for share in sorted(groups, reverse=True):
        count = sum(len(answers[value]) for value in groups[share])
        what = " statements hold" if not phrases else ""
        phrases.append(f"{round(share * count)} of {count}{what} for {_listed(groups[share])}")
    return ", ".join(phrases)


def _grouped(words: dict[str, str]) -> str:
    phrases = []
    for word in (HOLDS, FAILS, OPEN):
        values = [value for value, found in words.items() if found == word]
        if values:
            phrases.append(f"{_verb(word)} {_listed(values)}")
    return "; ".join(phrases)


def _verb(word: str) -> str:
    return {HOLDS: "holds for", FAILS: "fails for", OPEN: "open for"}[word]


def _listed(values: list[str]) -> str:
    return ", ".join(values[:-1]) + " and " + values[-1] if len(values) > 1 else values[0]


def _counted(statements: list[Statement]) -> str:
    words = [statement.verdict for statement in statements]
    counts = [(word, words.count(word)) for word in (HOLDS, FAILS, OPEN)]
    verbs = {HOLDS: ("holds", "hold"), FAILS: ("fails", "fail"), OPEN: ("is open", "are open")}
    shown = [f"{count} {verbs[word][count > 1]}" for word, count in counts if count]
    return f"of {len(words)} statements " + ", ".join(shown)
