# SPDX-License-Identifier: MIT
"""Run time against error, drawn: a few contenders by name, all others as a grey background."""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from pliant.base.style import (
    BLUE,
    DASHED,
    GREEN,
    GREY,
    ORANGE,
    PURPLE,
    SKY,
    VERMILION,
    figure,
    save,
)
from pliant.lab.bench.work_precision_rows import (
    LABELS,
    WHOLE,
    Row,
    WorkPrecision,
    entries,
    label,
    reached,
)
from pliant.lab.peers.gromacs import NAMES

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    Entry = tuple[str, float | None]

OURS = (BLUE, GREEN, SKY, PURPLE, "black", "#555555")
MARKERS = "osD^vP"
THEIRS = {"ccma": (VERMILION, "X"), "ccma_dynamics": (ORANGE, "d")}
GROMACS = {"gromacs_lincs": ("#7A4419", "p"), "gromacs_shake": ("#B9895B", "*")}
FEATURED = ("blocks", "blocks_lanes", "auto", "units", "newton", "shake")  #: if they take part
DEFAULT = ("bfs_cycle", 0.5)
MOST_NAMED = 6  #: of our techniques


def draw(found: WorkPrecision, path: str | os.PathLike[str]) -> None:
    """Writes the diagram as a PNG."""
    with figure(1, 1, panel=(7.2, 4.6)) as (plot, axes):
        draw_on(axes[0][0], found)
        save(plot, path)


def draw_on(axes: Axes, found: WorkPrecision) -> None:
    """The diagram on axes of the caller's."""
    grouped = entries(found.rows)
    named = _named(grouped)
    for entry, rows in grouped.items():
        if entry not in named and entry[0] not in LABELS:
            axes.plot(*reached(rows), color=GREY, alpha=0.35, linewidth=0.8)
    axes.plot([], [], color=GREY, alpha=0.6, linewidth=0.8, label="every other technique")
    for k, entry in enumerate(named):
        style = {"color": OURS[k % len(OURS)], "marker": MARKERS[k % len(MARKERS)]}
        _line(axes, entry, grouped[entry], linestyle="-", **style)
    for method, (colour, marker) in _theirs(grouped).items():
        rows = grouped[method, None]
        _line(axes, (method, None), rows, linestyle=DASHED, color=colour, marker=marker)
    axes.set(
        xscale="log",
        yscale="log",
        xlabel="error left: largest |length - rest| / rest, measured anew",
        ylabel="time for one bar (ns)",
        title=_title(found),
    )
    axes.invert_xaxis()
    axes.yaxis.set_major_formatter(lambda value, _: f"{value:g}")
    _legend_below(axes)


def _theirs(grouped: dict[Entry, list[Row]]) -> dict[str, tuple[str, str]]:
    """Styles of the peers that took part; of GROMACS' precisions the best that did."""
    styles = dict(THEIRS)
    for name, style in GROMACS.items():
        precise = [p for p in NAMES if (f"{name}_{p}", None) in grouped]
        styles |= {f"{name}_{precision}": style for precision in precise[:1]}
    return {method: style for method, style in styles.items() if (method, None) in grouped}


def _line(axes: Axes, entry: Entry, rows: Sequence[Row], **style: Any) -> None:
    axes.plot(*reached(rows), label=label(*entry), markersize=5, **style)


def _legend_below(axes: Axes) -> None:
    axes.legend(frameon=False, ncols=3, loc="upper center", bbox_to_anchor=(0.5, -0.14))


def _title(found: WorkPrecision) -> str:
    return (
        f"{len(found.target.bars)} broken bars made whole (coordinates off by "
        f"{found.displacement:g} Å): run time against error"
    )


def _named(grouped: dict[Entry, list[Row]]) -> list[Entry]:
    """Featured techniques and the default one, then the quickest of the others, to MOST_NAMED."""
    finished = [e for e in grouped if e[0] not in LABELS and _whole(grouped[e])]
    finished.sort(key=lambda entry: _cost(grouped[entry]))
    featured = [e for e in finished if e[0] in FEATURED and e[1] is None]
    chosen: dict[tuple[float, ...], Entry] = {}  # by its answers: who falls back gives another's
    names: set[str] = set()
    for entry in [*featured, *(e for e in finished if e == DEFAULT), *finished]:
        if entry in chosen.values() or entry[0] in names or len(chosen) == MOST_NAMED:
            continue
        answers = (row.displacement for row in grouped[entry])
        chosen.setdefault((grouped[entry][0].walkers, *answers), entry)
        names.add(entry[0])
    return list(chosen.values())


def _whole(rows: Sequence[Row]) -> int:
    return sum(row.outcome == WHOLE for row in rows)


def _cost(rows: Sequence[Row]) -> float:
    times = [row.ns_per_bar for row in rows if row.outcome == WHOLE and row.ns_per_bar > 0]
    return float(np.median(times)) / len(times) if times else math.inf
