# SPDX-License-Identifier: MIT
"""What the molecules say together: shares, differences by molecule, at equal numbers and times."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from pliant.lab.conformers.rows import WITHIN, Difference, Fault, Run, Share, Table

Floats = npt.NDArray[np.float64]

OURS = "Pliant"
_ROUNDING = 1e-9  #: of means that should be equal
JUDGED = 1.0  #: Angstrom, of the share in differences


@dataclass(frozen=True)
class Column:
    """All molecules by one contender, in their order."""

    contender: str
    at: str
    asked: int
    nearest: Floats  #: (M,) Angstrom; not-a-number where it failed
    seconds: Floats  #: (M,)
    made: Floats  #: (M,)
    start_seconds: Floats  #: (M,) of `seconds`, for the start


def summarise(table: Table, runs: Sequence[Run]) -> None:
    """Fills the table from what was made."""
    table.runs = list(runs)
    table.rows = [run.row for run in runs]
    columns = columns_of(runs)
    columns += at_equal_time(runs, columns)
    table.shares = [_share(column) for column in columns]
    ours = {column.at: column for column in columns if column.contender == OURS}
    others = [column for column in columns if column.contender != OURS and column.at in ours]
    table.differences = [difference(ours[other.at], other) for other in others]
    table.flaws = [_fault(rows) for rows in _grouped(runs).values()]


def columns_of(runs: Sequence[Run]) -> list[Column]:
    """Each contender at each number of conformers."""
    groups = sorted(_grouped(runs).items(), key=lambda item: item[0][1])
    return [_column(some, f"{asked} conformers", asked) for (_, asked), some in groups]


def at_equal_time(runs: Sequence[Run], columns: Sequence[Column]) -> list[Column]:
    """All with the CPU time that the fastest of the others takes for its most: first conformers.

    How many that pays for is interpolated between the mean times of a contender's runs.
    """
    times = {
        name: [(c.asked, float(np.nanmean(c.seconds))) for c in columns if c.contender == name]
        for name in dict.fromkeys(c.contender for c in columns if np.isfinite(c.nearest).any())
    }
    others = [some[-1][1] for name, some in times.items() if name != OURS]
    budget = min(others, default=np.nan)
    found = []
    for name, some in times.items() if others else ():
        if len({seconds for _, seconds in some}) == 1:  # one run, with all others at its beginning
            some = some[-1:]
        asked, seconds = np.array([(0, 0.0), *some]).T
        paid = np.interp(budget * (1 + _ROUNDING), np.maximum.accumulate(seconds), asked)
        first = max(1, round(float(paid)))
        column = _column(
            _grouped(runs)[name, int(asked[asked >= first].min())],
            f"equal CPU, {budget:.2g} s",
            first,
        )
        spent = min(budget, float(seconds.max()))
        found.append(replace(column, seconds=np.full_like(column.seconds, spent)))
    return found


def _grouped(runs: Sequence[Run]) -> dict[tuple[str, int], list[Run]]:
    """By contender and number, in the order in which they were run."""
    found: dict[tuple[str, int], list[Run]] = {}
    for run in runs:
        found.setdefault((run.row.contender, run.row.asked), []).append(run)
    return found


def _column(runs: Sequence[Run], at: str, first: int) -> Column:
    """The first conformers of each run."""
    seconds = [np.nan if run.row.seconds is None else run.row.seconds for run in runs]
    return Column(
        runs[0].row.contender,
        at,
        first,
        np.array([run.distances[:first].min() if run.row.made else np.nan for run in runs]),
        np.array(seconds),
        np.array([min(run.row.made, first) for run in runs], dtype=np.float64),
        np.array([run.row.start_seconds for run in runs]),
    )


def _share(column: Column) -> Share:
    known = column.nearest[np.isfinite(column.nearest)]
    return Share(
        column.contender,
        column.at,
        column.asked,
        len(column.nearest),
        int(len(column.nearest) - len(known)),
        float(column.made.mean()),
        tuple(float((known <= limit).sum() / len(column.nearest)) for limit in WITHIN),
        *mean_and_error(known),
        float(np.nanmean(column.seconds)) if len(known) else np.nan,
        float(column.start_seconds[np.isfinite(column.nearest)].mean()) if len(known) else np.nan,
    )


def difference(ours: Column, other: Column) -> Difference:
    """Ours less the other's, paired by molecule."""
    both = np.isfinite(ours.nearest) & np.isfinite(other.nearest)
    a, b = ours.nearest[both], other.nearest[both]
    within = (a <= JUDGED).astype(np.float64) - (b <= JUDGED)
    return Difference(
        other.contender, other.at, int(both.sum()), *mean_and_error(a - b), *mean_and_error(within)
    )


def mean_and_error(values: Floats) -> tuple[float, float]:
    """The mean and its standard error; not-a-number where there are too few."""
    mean = float(values.mean()) if len(values) else np.nan
    error = float(values.std(ddof=1) / np.sqrt(len(values))) if len(values) > 1 else np.nan
    return mean, error


def _fault(runs: Sequence[Run]) -> Fault:
    rows = [run.row for run in runs]
    conformers = sum(row.made for row in rows)
    strains = [row.strain for row in rows if row.strain is not None]
    return Fault(
        rows[0].contender,
        rows[0].asked,
        conformers,
        sum(row.handedness for row in rows),
        sum(row.double_bonds for row in rows),
        sum(row.amides for row in rows),
        sum(row.contacts for row in rows) / conformers if conformers else np.nan,
        float(np.median(strains)) if strains else np.nan,
    )
