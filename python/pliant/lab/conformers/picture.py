# SPDX-License-Identifier: MIT
"""Conformers drawn: how near they come, and what that costs."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.ticker import LogLocator, NullFormatter

from pliant._core import InputError
from pliant.base.style import PALETTE, figure, save
from pliant.lab.conformers.rows import Run, Table
from pliant.lab.conformers.summary import Column, columns_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_STYLES = ("-", "--", ":", "-.")
_FURTHEST = 3.0  #: Angstrom


def draw(found: Table, path: str | os.PathLike[str]) -> None:
    """Writes a PNG. Raises InputError where nothing was made."""
    runs = found.runs
    columns = [c for c in columns_of(runs) if np.isfinite(c.nearest).any()]
    if not columns:
        raise InputError("--output: no conformer was made")
    names = list(dict.fromkeys(run.row.contender for run in runs))
    colours = dict(zip(names, PALETTE, strict=False))
    with figure(1, 3, panel=(4.2, 3.6)) as (plot, axes):
        share, number, time = axes[0]
        _draw_shares(share, columns, colours)
        for name in names:
            mine = [run for run in runs if run.row.contender == name and run.row.made]
            if mine:
                number.plot(*_by_number(mine), color=colours[name], label=name)
            some = [c for c in columns if c.contender == name]
            time.plot(
                [np.nanmean(c.seconds) for c in some],
                [np.nanmean(c.nearest) for c in some],
                "o-",
                color=colours[name],
                label=name,
            )
        number.set(title="by number", xlabel="conformers", ylabel="mean of nearest (Å)")
        time.set(title="by time", xlabel="CPU time a molecule (s)", ylabel="mean of nearest (Å)")
        for panel in (number, time):
            panel.set_xscale("log")
            panel.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
            panel.xaxis.set_major_formatter("{x:g}")
            panel.xaxis.set_minor_formatter(NullFormatter())
        number.legend(frameon=False)
        save(plot, path)


def _draw_shares(axes: Axes, columns: Sequence[Column], colours: dict[str, str]) -> None:
    counts = sorted({column.asked for column in columns})
    for column in columns:
        near = np.sort(np.nan_to_num(column.nearest, nan=np.inf))
        share = np.arange(1, len(near) + 1) / len(near)
        axes.step(
            np.r_[0, near],
            np.r_[0, share],
            where="post",
            color=colours[column.contender],
            linestyle=_STYLES[counts.index(column.asked) % len(_STYLES)],
            label=f"{column.contender}, {column.asked}",
        )
    axes.set(title="share of molecules", xlim=(0, _FURTHEST), ylim=(0, 1),
             xlabel="nearest conformer (Å)", ylabel="share as near")  # fmt: skip
    axes.legend(frameon=False, loc="lower right", fontsize=8)


def _by_number(runs: Sequence[Run]) -> tuple[list[int], list[float]]:
    """Means of the nearest of the first 1, 2, 5, ... of each molecule's largest run."""
    most = max(run.row.asked for run in runs)
    largest = [run for run in runs if run.row.asked == most]
    steps = [n for k in (1, 10, 100, 1000) for n in (k, 2 * k, 5 * k) if n < most] + [most]
    return steps, [float(np.mean([run.distances[:n].min() for run in largest])) for n in steps]
