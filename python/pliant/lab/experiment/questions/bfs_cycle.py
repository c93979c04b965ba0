# SPDX-License-Identifier: MIT
"""Why bfs_cycle with weighting 1 is inconsistent: the spectral radius of one sweep on a cycle."""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.ticker import NullFormatter, ScalarFormatter

import pliant
from pliant.base import style
from pliant.checks.weightings import WEIGHTINGS
from pliant.lab.experiment.document import Answer, Figure, Table, as_text
from pliant.lab.experiment.statistics import number
from pliant.lab.experiment.sweep_matrix import closing_rate, spectral_radius, sweep_matrix
from pliant.lab.experiment.trials import LIMIT, PUSH, TOLERANCE, Trial, pushed_graphs

TITLE = "Why is bfs_cycle with weighting 1 inconsistent?"

POLYGONS = (3, 4, 5, 6, 8, 12, 20, 50)
COLORS = {0.5: style.BLUE, 0.75: style.ORANGE, 1.0: style.VERMILION}
LINES = {0.5: "-", 0.75: (0, (5, 3)), 1.0: (0, (1, 2))}
BINS = (0.0, 0.5, 0.9, 0.99, 1.0 + 1e-9)


@dataclass(frozen=True)
class Observed:
    """One trial with one weighting."""

    rate: float  #: spectral radius of a sweep where the framework came to rest
    sweeps: int
    predicted: float  #: sweeps, from the rate and the error after the first sweep
    converged: bool


def polygon(size: int) -> tuple[pliant.Framework, np.ndarray]:
    """A regular polygon with bars of length 1, in a plane."""
    turn = 2 * np.pi * np.arange(size) / size
    radius = 0.5 / np.sin(np.pi / size)
    positions = np.column_stack([radius * np.cos(turn), radius * np.sin(turn), 0 * turn])
    bars = [(i, (i + 1) % size) for i in range(size)]
    return pliant.Framework(bars, positions=positions), positions


def measured_rate(framework: pliant.Framework, whole: np.ndarray, weighting: float) -> float:
    """The factor by which errors shrink a sweep in the end, seen on a slightly broken framework."""
    draws = np.random.Generator(np.random.Philox(key=1))
    positions = whole + 1e-4 * draws.standard_normal(whole.shape)
    resolver = pliant.Resolver(framework, "bfs_cycle", weighting, tolerance=1e-15, max_sweeps=1)
    errors = [_largest_error(framework, positions)]
    while len(errors) < 900 and errors[-1] > 1e-13:
        resolver.resolve(positions, 0)
        errors.append(_largest_error(framework, positions))
    last = len(errors) - 2  # the very last may be rounding
    half = last // 2
    return (errors[last] / errors[half]) ** (1.0 / (last - half)) if last > half else 0.0


def _largest_error(framework: pliant.Framework, positions: np.ndarray) -> float:
    return float(np.max(np.abs(pliant.residuals(framework, positions))))


def observe(trial: Trial, weighting: float) -> Observed | None:
    """None if one sweep was enough (or none): there is then nothing to predict."""
    options: dict[str, Any] = {
        "technique": "bfs_cycle",
        "weighting": weighting,
        "tolerance_length": TOLERANCE,
    }
    first, rest = trial.pushed(), trial.pushed()
    pliant.resolve(trial.framework, first, root=trial.root, max_sweeps=1, **options)
    summary = pliant.resolve(trial.framework, rest, root=trial.root, max_sweeps=LIMIT, **options)
    if summary.sweeps < 2:
        return None
    rate = spectral_radius(sweep_matrix(trial.framework, rest, trial.root, weighting))
    error = _largest_error(trial.framework, first)
    more = np.log(error / TOLERANCE) / -np.log(min(max(rate, 1e-9), 1 - 1e-9))
    return Observed(rate, summary.sweeps, 1 + max(1.0, float(np.ceil(more))), summary.converged)


def answer(out: Path, seed: int, quick: bool) -> Answer:
    """Rates of polygons in closed form, then of random 1-cycles against the sweeps they take."""
    graphs, pushes = (6, 6) if quick else (60, 25)
    trials = pushed_graphs("1-cycle-ring", graphs, pushes, seed)
    trials += pushed_graphs("1-cycle-bar", graphs, pushes, seed)
    found = {w: [seen for trial in trials if (seen := observe(trial, w))] for w in WEIGHTINGS}
    formula = _formula_error(trials[: 6 * pushes])
    return Answer(
        TITLE,
        _verdict(found, len(trials)),
        _paragraphs(formula),
        as_text([_polygon_table(), _rate_table(found, len(trials)), _bin_table(found[1.0])]),
        [_draw_rates(found, out), _draw_prediction(found, out)],
    )


def _rates(found: list[Observed]) -> np.ndarray:
    return np.array([seen.rate for seen in found])


def _sweeps(found: list[Observed]) -> np.ndarray:
    return np.array([seen.sweeps for seen in found])


def _verdict(found: dict[float, list[Observed]], trials: int) -> str:
    half, one = found[0.5], found[1.0]
    slow, sweeps = _rates(one) > 0.9, _sweeps(one)
    spread = (sweeps - sweeps.mean()) ** 2
    share, variance = 100 * slow.sum() / trials, 100 * spread[slow].sum() / spread.sum()
    slow_half = 100 * np.sum(_rates(half) > 0.9) / trials
    return (
        "With weighting 1 a cycle is mended at one place alone, its closing bar: the whole error "
        "sits there, and each sweep multiplies it by (cos² a + cos² b) / 2, a and b being the "
        "angles between that bar and its two neighbours, by chance anything from 0 to 1. "
        f"The {share:.1f} % of {trials} pushes where that is above 0.9 make {variance:.0f} % of "
        f"the variance of the sweeps; the slowest took {sweeps.max()}. With weighting 0.5 such "
        f"factors are met by {slow_half:.1f} %, but all bars share the error, and the slowest took "
        f"{_sweeps(half).max()}."
    )


def _paragraphs(formula: float) -> list[str]:
    return [
        "Near whole bars a sweep is a matrix that acts on the length errors of the bars, and its "
        "spectral radius is the factor by which the error falls a sweep in the end. With weighting "
        "1 every tree bar is made whole by moving its far joint, so after a forward sweep only the "
        "two bars beside the closing bar are broken, by half its error times a cosine each. The "
        "rest of the cycle never takes part: two angles decide. The cycles that fail are those "
        "whose closing bar lies nearly in line with both neighbours, whatever the size of the "
        "ring; and since breadth-first search puts the closing bar opposite to the pushed joint, "
        "one graph is fast or slow by where it is pushed. The closed form agrees with the "
        f"eigenvalues to {formula:.0e} on these graphs, and the sweeps that follow from it with "
        "those taken (second table, last columns).",
        "With weighting 0.5 the sweep is Gauss-Seidel on the symmetric matrix J Jᵀ. Its spectral "
        "radius is often larger, for long chains are slow, but little of a push lies in the slow "
        "modes: most of its error is gone before they count, and the number of sweeps that the "
        "spectral radius predicts is too large. Regular polygons of five and more joints have the "
        "same rate, cos²(2π/n), at every weighting: large ones are slow whatever is done, for "
        "their bars all lie nearly in line with their neighbours.",
    ]


def _formula_error(trials: list[Trial]) -> float:
    worst = 0.0
    for trial in trials:
        formula = closing_rate(trial.framework, trial.positions, trial.root)
        if formula is None:
            continue
        matrix = sweep_matrix(trial.framework, trial.positions, trial.root, 1.0)
        worst = max(worst, abs(spectral_radius(matrix) - formula))
    return worst


def _polygon_table() -> Table:
    columns = ["joints"] + [f for w in ("0.5", "0.75", "1") for f in (f"rate {w}", "observed")]
    table = Table(
        "Regular polygons of unit bars: spectral radius of one sweep of bfs_cycle, beside the "
        "factor observed on positions broken by 1e-4; at weighting 1 it is cos²(2π/n).",
        [*columns, "cos²(2π/n)"],
    )
    for size in POLYGONS:
        framework, positions = polygon(size)
        row: list[str | int | float] = [size]
        for weighting in WEIGHTINGS:
            rate = spectral_radius(sweep_matrix(framework, positions, 0, weighting))
            row += [f"{rate:.4f}", f"{measured_rate(framework, positions, weighting):.4f}"]
        table.rows.append([*row, f"{np.cos(2 * np.pi / size) ** 2:.4f}"])
    return table


def _rate_table(found: dict[float, list[Observed]], trials: int) -> Table:
    columns = ["weighting", "pushes", "median rate", "90 % below", "largest rate", "mean sweeps"]
    columns += ["sd", "most sweeps", "met the limit", "predicted / taken, median"]
    table = Table(
        f"{trials} pushes of random 1-cycles (both ways of making them; push {PUSH:g} Å, tolerance "
        f"{TOLERANCE:g} Å, at most {LIMIT} sweeps): those that took more than one sweep.",
        [*columns, "within a factor 1.5"],
    )
    for weighting, seen in found.items():
        rates, sweeps = _rates(seen), _sweeps(seen)
        ratio = np.array([s.predicted / s.sweeps for s in seen if s.converged])
        near = np.mean((ratio < 1.5) & (ratio > 1 / 1.5))
        row: list[str | int | float] = [f"{weighting:g}", len(seen), f"{np.median(rates):.3f}"]
        row += [f"{np.percentile(rates, 90):.3f}", f"{rates.max():.5f}", number(sweeps.mean())]
        row += [number(sweeps.std(ddof=1)), int(sweeps.max()), sum(not s.converged for s in seen)]
        table.rows.append([*row, f"{np.median(ratio):.2f}", f"{100 * near:.0f} %"])
    return table


def _bin_table(seen: list[Observed]) -> Table:
    table = Table(
        "Which cycles fail at weighting 1: sweeps by the spectral radius at the closing bar.",
        ["rate from", "to", "pushes", "mean sweeps", "most sweeps"],
    )
    for low, high in itertools.pairwise(BINS):
        sweeps = np.array([s.sweeps for s in seen if low <= s.rate < high])
        if sweeps.size:
            edges = f"{low:g}", f"{min(high, 1.0):g}"
            table.rows.append([*edges, len(sweeps), number(sweeps.mean()), int(sweeps.max())])
    return table


def _draw_rates(found: dict[float, list[Observed]], out: Path) -> Figure:
    with style.figure(1, 2, panel=(5.0, 3.5)) as (plot, axes):
        left, right = axes[0]
        sizes = range(3, 51)
        for weighting in WEIGHTINGS:
            rates = [_polygon_rate(size, weighting) for size in sizes]
            color, line = COLORS[weighting], LINES[weighting]
            name = f"weighting {weighting:g}"
            left.plot(sizes, rates, color=color, linestyle=line, linewidth=2.2, label=name)
            seen = np.sort(_rates(found[weighting]))
            right.plot(seen, 100 * (1 - np.arange(len(seen)) / len(seen)), color=COLORS[weighting])
        left.set(
            xlabel="joints of a regular polygon",
            ylabel="spectral radius of a sweep",
            ylim=(0, 1.02),
            title="Regular polygons",
        )
        left.legend()
        right.set(
            xlabel="spectral radius of a sweep",
            ylabel="pushes with a larger one (%)",
            yscale="log",
            title="Random 1-cycles",
        )
        style.save(plot, out / "rates.png")
    return Figure(
        out / "rates.png",
        "Left: the factor by which a sweep reduces errors on regular polygons. Right: how often "
        "random 1-cycles have a larger factor, among pushes that took more than one sweep.",
    )


def _polygon_rate(size: int, weighting: float) -> float:
    framework, positions = polygon(size)
    return spectral_radius(sweep_matrix(framework, positions, 0, weighting))


def _draw_prediction(found: dict[float, list[Observed]], out: Path) -> Figure:
    with style.figure(1, 1, panel=(9.0, 4.0)) as (plot, axes):
        axis = axes[0][0]
        top = 2.0
        for weighting, marker in zip(WEIGHTINGS, "o^s", strict=True):
            seen = [s for s in found[weighting] if s.converged]
            predicted, sweeps = [s.predicted for s in seen], [s.sweeps for s in seen]
            top = max(top, *sweeps, *predicted)
            name, color = f"weighting {weighting:g}", COLORS[weighting]
            axis.scatter(
                predicted, sweeps, s=14, marker=marker, color=color, alpha=0.5, lw=0, label=name
            )
        axis.plot((2, top), (2, top), color="black", linewidth=0.8)
        axis.set(
            xscale="log",
            yscale="log",
            xlabel="sweeps predicted from the spectral radius",
            ylabel="sweeps taken",
        )
        for side in (axis.xaxis, axis.yaxis):
            side.set_major_formatter(ScalarFormatter())
            side.set_minor_formatter(NullFormatter())
        axis.legend()
        style.save(plot, out / "prediction.png")
    return Figure(
        out / "prediction.png",
        "Sweeps predicted from the error after the first sweep and the spectral radius where the "
        "framework came to rest, against the sweeps that it took; one mark a push.",
    )
