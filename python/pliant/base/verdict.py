# SPDX-License-Identifier: MIT
"""What to believe: the answer to one question, and one verdict made from all answers."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

#: what checks that passed say, and what they do not
SCOPE = (
    "Checks show that the frames are sound and that another draw would give much the same numbers. "
    "They do not show that the molecule itself moves like this."
)


@dataclass(frozen=True)
class Verdict:
    """The answer to one question."""

    kind: str  #: "good", "mixed", "bad" or "open" (nothing is judged)
    sentence: str  #: all that has to be known, in words of the field
    details: str
    #: what it is called among others that passed, or, if it is open, that were not checked
    brief: str = ""


def verdict_of_all(made: Iterable[Verdict]) -> Verdict:
    """One verdict from all: good only if no answer is bad or doubtful, and it names what is."""
    every = list(made)
    bad, doubtful, good = (
        [v for v in every if v.kind == kind] for kind in ("bad", "mixed", "good")
    )
    passed = _listed("Checks passed", good)
    unchecked = _listed("Not checked", [v for v in every if v.kind == "open"])
    wrong = " ".join(v.sentence for v in [*bad, *doubtful])
    if bad:
        return Verdict("bad", f"Do not use these frames as they are. {wrong}", passed + unchecked)
    if doubtful:
        return Verdict("mixed", wrong, passed + unchecked)
    if not good:
        return Verdict("open", "There is nothing here to check.", "")
    return Verdict("good", f"All {passed[0].lower()}{passed[1:]}{unchecked}".strip(), SCOPE)


def _listed(what: str, some: Iterable[Verdict]) -> str:
    names = ", ".join(v.brief for v in some if v.brief)
    return f"{what}: {names}. " if names else ""
