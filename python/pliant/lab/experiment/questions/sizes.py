# SPDX-License-Identifier: MIT
"""Sizes up to 10^5 joints: sweeps and work against size, for each class."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from pathlib import Path

import numpy as np

from pliant.base import plotting
from pliant.lab.experiment.answer import Answer, Figure, Table
from pliant.lab.experiment.trials import (
    PUSH,
    TOLERANCE,
    Trial,
    Work,
    as_text,
    between,
    digits,
    label,
    pushed_graphs,
    work_of,
)

TITLE = "Do the results hold on large graphs?"
ORDER = 3

#: class -> how many non-tree bars a graph of that many joints gets
KINDS: dict[str, Callable[[int], int]] = {
    "tree": lambda _: 0,
    "1-cycle-bar": lambda _: 1,
    "2-cycle-bars": lambda _: 2,
    "n-cycle": lambda joints: joints // 20,
}
TECHNIQUES = (
    ("random", 0.5),
    ("bfs_cycle", 0.5),
    ("bfs_reverse", 0.5),
    ("bfs_cycle", 1.0),
    ("anderson", 0.5),
    ("blocks", 0.5),
)
THESIS = TECHNIQUES[:4]
COLORS = [plotting.GREY, plotting.BLUE, plotting.SKY, plotting.VERMILION]
COLORS += [plotting.ORANGE, plotting.GREEN]
MARKERS = "o^sDvP"
MOST_SWEEPS = 500
Results = dict[tuple[str, int, tuple[str, float]], Work]


def answer(out: Path, seed: int, quick: bool) -> Answer:
    """One push a graph, several graphs a size; fewer of the large ones."""
    sizes = (30, 300) if quick else (30, 100, 300, 1000, 3000, 10000, 30000, 100000)
    found: Results = {}
    made: dict[int, Counter[int]] = {}  #: joints -> graph -> pushes
    for kind, cycles in KINDS.items():
        for joints in sizes:
            trials = _trials(kind, joints, cycles(joints), seed, quick)
            made[joints] = Counter(trial.graph for trial in trials)
            for combination in TECHNIQUES:
                found[kind, joints, combination] = work_of(trials, *combination, limit=MOST_SWEEPS)
    table, drawing = as_text([_table(found, sizes)]), _draw(found, sizes, out)
    return Answer(TITLE, _verdict(found, sizes), _paragraphs(made), table, [drawing])


def _trials(kind: str, joints: int, cycles: int, seed: int, quick: bool) -> list[Trial]:
    graphs, pushes = (3, 4) if quick else (int(np.clip(30000 // joints, 2, 20)), 10)
    sizes: dict[str, float] = {"joints": joints}
    if kind == "n-cycle":
        sizes["cycles"] = max(1, cycles)
    return pushed_graphs(kind, graphs, pushes, seed, **sizes)


def _verdict(found: Results, sizes: tuple[int, ...]) -> str:
    small, large = sizes[0], sizes[-1]

    def sweeps(kind: str, joints: int) -> float:
        return float(found[kind, joints, ("bfs_cycle", 0.5)].sweeps.mean())

    growth = ", ".join(
        f"{digits(sweeps(k, small))} to {digits(sweeps(k, large))} on {k}" for k in KINDS
    )
    gains = [", ".join(f"{_gain(found, k, n):.1f}" for k in KINDS) for n in (small, large)]
    return (
        f"From {small} to {large} joints the sweeps of bfs_cycle 0.5 go from {growth}: a push is "
        "felt near the pushed joint alone, and work grows with the number of bars for the sole "
        "reason that each sweep looks at all of them. The thesis' best of the four shown takes "
        f"{gains[0]} times the work of blocks at {small} joints, in the same order, and "
        f"{gains[1]} times at {large}, where few pushes reach a cycle."
    )


def _gain(found: Results, kind: str, joints: int) -> float:
    best = min(found[kind, joints, c].projections.mean() for c in THESIS)
    return float(best / found[kind, joints, ("blocks", 0.5)].projections.mean())


def _paragraphs(made: dict[int, Counter[int]]) -> list[str]:
    graphs = between([len(counts) for counts in made.values()])
    pushes = between([count for counts in made.values() for count in counts.values()])
    return [
        "Random trees in which each joint hangs on a random earlier one, with no, one or two bars "
        "between random pairs, or one for every twenty joints (n-cycle). One random joint is "
        f"pushed by {PUSH:g} Å; tolerance {TOLERANCE:g} Å, at most {MOST_SWEEPS} sweeps; {graphs} "
        f"graphs of each class and size with {pushes} pushes each. "
        "Bars of a ring system grow with the graph only in the n-cycle class; there a "
        "sweep of the ring system is a sweep of most of the graph, and what is left to gain is "
        "acceleration."
    ]


def _table(found: Results, sizes: tuple[int, ...]) -> Table:
    table = Table(
        "Mean sweeps (mean projections a bar of the graph); + n: so many pushes met the limit.",
        ["class", "joints", "bars", *[label(c) for c in TECHNIQUES]],
    )
    for kind, cycles in KINDS.items():
        for joints in sizes:
            bars = joints - 1 + (max(1, cycles(joints)) if kind == "n-cycle" else cycles(joints))
            cells = []
            for combination in TECHNIQUES:
                work = found[kind, joints, combination]
                lost = f" + {work.failures}" if work.failures else ""
                cells.append(
                    f"{digits(work.sweeps.mean())} ({digits(work.projections.mean() / bars)}){lost}"
                )
            table.rows.append([kind, joints, bars, *cells])
    return table


def _draw(found: Results, sizes: tuple[int, ...], out: Path) -> Figure:
    with plotting.figure(2, len(KINDS), panel=(2.9, 2.6)) as (plot, axes):
        for column, kind in zip(axes.T, KINDS, strict=True):
            for combination, color, marker in zip(TECHNIQUES, COLORS, MARKERS, strict=True):
                works = [found[kind, n, combination] for n in sizes]
                for axis, values in zip(
                    column,
                    ([w.sweeps.mean() for w in works], [w.projections.mean() for w in works]),
                    strict=True,
                ):
                    look = {"color": color, "marker": marker, "markersize": 3.5}
                    axis.plot(sizes, values, label=label(combination), **look)
                    axis.set(xscale="log")
            column[0].set_title(kind)
            column[0].set_ylim(bottom=0)
            column[1].set(yscale="log", xlabel="joints")
        axes[0][0].set_ylabel("mean sweeps")
        axes[1][0].set_ylabel("mean projections")
        plot.legend(*axes[0][0].get_legend_handles_labels(), loc="outside upper center", ncols=6)
        plotting.save(plot, out / "sizes.png")
    return Figure(
        out / "sizes.png",
        "Sweeps and projections against the number of joints. Sweeps level off; projections grow "
        "in proportion to the bars.",
    )
