# SPDX-License-Identifier: MIT
"""What a report of an experiment holds and how it is made."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager
from dataclasses import dataclass

from pliant.base import console
from pliant.lab.experiment.statistics import REPLICATES

#: Gives a function (done, total) while something is under way.
Progress = AbstractContextManager[Callable[[int, int], None]]


@dataclass
class Choices:
    """What the report holds and how it is made."""

    sweep: bool = True
    questions: bool = True
    quick: bool = False  #: small sizes: to look at, not to cite
    workers: int = 1
    replicates: int = REPLICATES
    progress: Callable[[str], AbstractContextManager[Callable[[int, int], None]]] = lambda what: (
        console.progress(what, quiet=True)
    )
