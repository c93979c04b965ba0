# SPDX-License-Identifier: MIT
"""What the molecules say together: shares, differences by molecule, at equal numbers and times."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from pliant.lab.conformers.rows import WITHIN, Difference, Fault, Made, Share, Table

Floats = npt.NDArray[np.float64]

OURS = "Pliant"
JUDGED = 1.0  #: Angstrom, of the share in differences


@dataclass(frozen=True)
class Run:
    """What one contender made of one molecule, in the order in which it came."""

    row: Made
    distances: Floats = field(default_factory=lambda: np.zeros(0))  #: (F,) Angstrom
    frames: Floats = field(default_factory=lambda: np.zeros((0, 0, 3)))  #: (F, N, 3) Angstrom


@dataclass(frozen=True)
class Column:
    """All molecules by one contender, in their order."""

    contender: str
    at: str
    asked: int
    nearest: Floats  #: (M,) Angstrom; not-a-number where it failed
    seconds: Floats  #: (M,)
    made: Floats  #: (M,)


def summarise(table: Table, runs: Sequence[Run]) -> None:
    """Fills the table from what was made."""
    table.made = [run.row for run in runs]
    columns = columns_of(runs)
    columns += at_equal_time(runs, columns)
    table.shares = [_share(column) for column in columns]
    ours = {column.at: column for column in columns if column.contender == OURS}
    others = [column for column in columns if column.contender != OURS and column.at in ours]
    table.differences = [difference(ours[other.at], other) for other in others]
    table.faults = [_fault(rows) for rows in _grouped(runs).values()]


def columns_of(runs: Sequence[Run]) -> list[Column]:
    """Each contender at each number of conformers."""
    return [
        _column(some, f"{asked} conformers", asked, asked)
        for (_, asked), some in _grouped(runs, order=1).items()
    ]


def at_equal_time(runs: Sequence[Run], columns: Sequence[Column]) -> list[Column]:
    """All with the CPU time of the slowest run of the peer that is fastest: the first conformers.

    How many that pays for is interpolated between the mean times of a contender's runs.
    """
    peers = {c.contender: float(np.nanmean(c.seconds)) for c in columns if c.contender != OURS}
    if not peers or not np.isfinite(min(peers.values())):
        return []
    budget = min(peers.values())
    found = []
    for contender in dict.fromkeys(column.contender for column in columns):
        mine = [c for c in columns if c.contender == contender]
        times = [float(np.nanmean(c.seconds)) for c in mine]
        if len(set(times)) == 1:  # one run, whose first conformers are all columns
            mine, times = mine[-1:], times[-1:]
        paid = float(np.interp(budget * 1.000001, [0.0, *times], [0, *(c.asked for c in mine)]))
        first = max(1, round(paid))
        asked = min(c.asked for c in mine if c.asked >= first)
        some = _grouped(runs)[contender, asked]
        found.append(_column(some, f"equal CPU, {budget:.2g} s", asked, first))
    return found


def _grouped(runs: Sequence[Run], order: int = 0) -> dict[tuple[str, int], list[Run]]:
    """By contender and number, in the order in which they were run or by number."""
    found: dict[tuple[str, int], list[Run]] = {}
    for run in runs:
        found.setdefault((run.row.contender, run.row.asked), []).append(run)
    return dict(sorted(found.items(), key=lambda item: item[0][1])) if order else found


def _column(runs: Sequence[Run], at: str, asked: int, first: int) -> Column:
    def each(value: float | None) -> float:
        return np.nan if value is None else value

    return Column(
        runs[0].row.contender,
        at,
        min(asked, first),
        np.array([run.distances[:first].min() if run.row.made else np.nan for run in runs]),
        np.array([each(run.row.seconds) for run in runs]) * min(1.0, first / asked),
        np.array([min(run.row.made, first) for run in runs], dtype=np.float64),
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
