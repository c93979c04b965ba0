# SPDX-License-Identifier: MIT
"""The time that a queue grants: how long it is, and what ends before it is over."""

from __future__ import annotations

import re
import time

from pliant._core import OptionError

#: Exit code of what was committed and is to be started again (EX_TEMPFAIL of sysexits.h).
EXIT_AGAIN = 75

#: Seconds before the end in which shards commit and end; less of a short time.
MARGIN = 60.0

_FORMS = (
    r"(?P<minutes>\d+)",
    r"(?P<minutes>\d+):(?P<seconds>\d+)",
    r"(?P<hours>\d+):(?P<minutes>\d+):(?P<seconds>\d+)",
    r"(?P<days>\d+)-(?P<hours>\d+)(:(?P<minutes>\d+)(:(?P<seconds>\d+))?)?",
)
_SECONDS = {"days": 86400, "hours": 3600, "minutes": 60, "seconds": 1}


class OutOfTimeError(Exception):
    """Ended before it was complete, with all that was done committed; the same command goes on."""


def parse_walltime(text: str) -> float:
    """Seconds, of a time as Slurm takes it. Raises OptionError."""
    for form in _FORMS:
        if found := re.fullmatch(form, text):
            parts = found.groupdict()
            seconds = sum(_SECONDS[name] * int(parts[name] or 0) for name in parts)
            if seconds > 0:
                return float(seconds)
    raise OptionError(
        f"--walltime {text}: expected a time as Slurm takes it: minutes, minutes:seconds, "
        "hours:minutes:seconds, days-hours, days-hours:minutes or days-hours:minutes:seconds"
    )


def deadline_of(walltime: str | None, began: float) -> float | None:
    """When shards have to commit and end (time.time()); None for never."""
    if walltime is None:
        return None
    seconds = parse_walltime(walltime)
    return began + seconds - min(MARGIN, seconds / 10)


def seconds_left(deadline: float | None) -> float | None:
    """None for any number."""
    return None if deadline is None else max(0.0, deadline - time.time())
