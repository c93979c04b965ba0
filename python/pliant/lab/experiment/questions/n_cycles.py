# SPDX-License-Identifier: MIT
"""n-cycles up to n = 50: what each further cycle costs."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from pliant.base import style
from pliant.lab.experiment.document import Answer, Figure, Table, as_text
from pliant.lab.experiment.settings import label
from pliant.lab.experiment.statistics import number, with_interval
from pliant.lab.experiment.trials import LIMIT, Work, mean_interval, pushed_graphs, work_of

TITLE = "What about more than two cycles?"

JOINTS = 60
TECHNIQUES = (
    ("random", 0.5), ("bfs_cycle", 0.5), ("bfs_reverse", 0.5), ("bfs_cycle", 1.0),
    ("bfs_random", 1.0), ("anderson", 0.5), ("blocks", 0.5),
)  # fmt: skip  # a table: a row a line
COLORS = [style.GREY, style.BLUE, style.SKY, style.VERMILION, style.ORANGE]
COLORS += [style.PURPLE, "black"]
MARKERS = "o^sDvP*"
THESIS = TECHNIQUES[:5]

Results = dict[tuple[int, tuple[str, float]], Work]


def answer(out: Path, seed: int, quick: bool) -> Answer:
    """Trees of 60 joints with n bars between random pairs."""
    cycles = (1, 5) if quick else (0, 1, 2, 3, 5, 10, 20, 30, 40, 50)
    graphs, pushes = (3, 3) if quick else (16, 8)
    found: Results = {}
    shares: dict[int, float] = {}
    for n in cycles:
        trials = pushed_graphs("n-cycle", graphs, pushes, seed, cycles=n, joints=JOINTS)
        facts = [trial.framework.graph_facts() for trial in trials[::pushes]]
        shares[n] = float(np.mean([f.bars_in_blocks / f.bars for f in facts]))
        for combination in TECHNIQUES:
            found[n, combination] = work_of(trials, *combination)
    return Answer(
        TITLE,
        _verdict(found, cycles),
        _paragraphs(),
        as_text([_table(found, shares, seed)]),
        [_draw(found, cycles, seed, out)],
    )


def _mean(found: Results, n: int, combination: tuple[str, float]) -> float:
    return float(found[n, combination].projections.mean())


def _verdict(found: Results, cycles: tuple[int, ...]) -> str:
    few, many = next(n for n in cycles if n > 0), cycles[-1]
    best = min(THESIS, key=lambda c: _mean(found, many, c))
    ours = _mean(found, many, ("blocks", 0.5))
    lost = 100 * np.mean(~found[many, ("bfs_cycle", 1.0)].converged)
    half, one = (_growth(found, few, many, weighting) for weighting in (0.5, 1.0))
    reverse = _mean(found, many, ("bfs_reverse", 0.5)) / _mean(found, many, best)
    return (
        f"From {few} to {many} independent cycles on {JOINTS} joints the work of bfs_cycle grows "
        f"{half} times at weighting 0.5 and {one} times at weighting 1, where {lost:.1f} % of the "
        f"pushes then meet the limit of {LIMIT} sweeps. At {many} the best of the thesis' five "
        f"shown, {label(best)}, takes {number(_mean(found, many, best) / ours)} times the work of "
        f"blocks, and bfs_reverse 0.5 takes {number(reverse)} times that of the best."
    )


def _growth(found: Results, few: int, many: int, weighting: float) -> str:
    combination = ("bfs_cycle", weighting)
    return number(_mean(found, many, combination) / _mean(found, few, combination))


def _paragraphs() -> list[str]:
    return [
        f"Random trees of {JOINTS} joints with n bars between random pairs. The thesis expects "
        'that bfs_reverse "may do increasingly better" with more cycles; counted in sweeps of one '
        "direction, or in work, it does not. A push that meets the limit counts with the work done "
        "until then, so means with failures are lower bounds. A projection of blocks stands for "
        "a bar in one Newton iteration, whose linear algebra costs more than a sweep's projection."
    ]


def _table(found: Results, shares: dict[int, float], seed: int) -> Table:
    table = Table(
        "Mean projections, 95 % of the bootstrap over graphs; + n %: pushes that met the limit.",
        ["n", "bars on cycles", *[label(c) for c in TECHNIQUES]],
    )
    for n, share in shares.items():
        row: list[str | int | float] = [n, f"{100 * share:.0f} %"]
        for combination in TECHNIQUES:
            work = found[n, combination]
            mean = mean_interval(work, seed)
            lost = f" + {100 * np.mean(~work.converged):.0f} %" if work.failures else ""
            row.append(with_interval(mean) + lost)
        table.rows.append(row)
    return table


def _draw(found: Results, cycles: tuple[int, ...], seed: int, out: Path) -> Figure:
    with style.figure(1, 2, panel=(4.8, 3.8)) as (plot, axes):
        left, right = axes[0]
        for combination, color, marker in zip(TECHNIQUES, COLORS, MARKERS, strict=True):
            works = [found[n, combination] for n in cycles]
            means = np.array([mean_interval(work, seed) for work in works])
            look = {"color": color, "marker": marker, "markersize": 4}
            left.plot(cycles, means[:, 0], label=label(combination), **look)
            left.fill_between(
                cycles, means[:, 1], means[:, 2], color=color, alpha=0.12, linewidth=0
            )
            right.plot(cycles, [100 * np.mean(~w.converged) for w in works], **look)
        left.set(yscale="log", xlabel="independent cycles", ylabel="mean projections")
        right.set(xlabel="independent cycles", ylabel=f"pushes that met {LIMIT} sweeps (%)")
        plot.legend(*left.get_legend_handles_labels(), loc="outside upper center", ncols=4)
        style.save(plot, out / "n_cycles.png")
    return Figure(
        out / "n_cycles.png",
        f"Work and failures against the number of independent cycles; {JOINTS} joints, push 0.5 Å, "
        "tolerance 0.01 Å; bands: 95 % of the bootstrap over graphs.",
    )
