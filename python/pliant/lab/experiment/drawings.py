# SPDX-License-Identifier: MIT
"""The figures of the thesis' chapter 5 and appendix C, drawn anew from our table."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle
from matplotlib.ticker import MaxNLocator

from pliant.base import style
from pliant.checks.weightings import WEIGHTINGS
from pliant.lab.experiment.document import Figure
from pliant.lab.experiment.settings import reverse_techniques
from pliant.lab.experiment.statistics import Evidence, Statistics, interval

LAST_BIN = 20  #: histograms gather what is above
# Distinct by hue for most, by lightness for all (Okabe and Ito 2008), and by hatching in print.
LOOKS = (
    (style.GREY, ""),
    (style.BLUE, ""),
    (style.SKY, "///"),
    (style.VERMILION, ""),
    (style.ORANGE, "///"),
)
SHADES = {0.5: style.BLUE, 0.75: style.ORANGE, 1.0: style.VERMILION}


@dataclass(frozen=True)
class BarChart:
    """A figure of chapter 5: mean, mode and standard deviation of some techniques."""

    number: str
    family: str
    techniques: tuple[str, ...]


@dataclass(frozen=True)
class Histogram:
    """A figure of appendix C: the numbers of sweeps of one technique at three weightings."""

    number: str
    technique: str
    family: str


CYCLE = ("random", "bfs_cycle", "dfs_cycle")
REVERSE = ("random", "bfs_cycle", "bfs_reverse", "dfs_cycle", "dfs_reverse")
BAR_CHARTS = (
    BarChart("5.1", "tree", ("random", "bfs_tree", "dfs_tree")),
    BarChart("5.3", "1-cycle", CYCLE),
    BarChart("5.4", "2-cycle", CYCLE),
    BarChart("5.6", "1-cycle", REVERSE),
    BarChart("5.7", "2-cycle", REVERSE),
    BarChart("5.9", "1-cycle", ("random", "bfs_cycle", "bfs_reverse", "bfs_adapt", "bfs_random")),
)
_ONE = ("bfs_adapt", "bfs_cycle", "dfs_cycle", "bfs_reverse", "dfs_reverse", "bfs_random", "random")
_TWO = ("bfs_cycle", "dfs_cycle", "bfs_reverse", "dfs_reverse", "random")
HISTOGRAMS = tuple(
    Histogram(f"C.{k}", technique, family)
    for k, (technique, family) in enumerate(
        [(technique, "tree") for technique in ("bfs_tree", "dfs_tree", "random")]
        + [(technique, "1-cycle") for technique in _ONE]
        + [(technique, "2-cycle") for technique in _TWO],
        start=1,
    )
)

_MEASURES = (("mean", "mean"), ("mode", "mode"), ("sd", "standard deviation"))


def draw_bars(chart: BarChart, all_evidence: dict[str, Evidence], folder: Path) -> Figure | None:
    """One row of mean, mode and sd in sweeps; a second in passes if a reverse one is among them.

    None if the table has nothing of it.
    """
    techniques = [
        t for t in chart.techniques if all_evidence["sweeps"].has(chart.family, t, WEIGHTINGS[0])
    ]
    if not techniques:
        return None
    reverse = bool(set(techniques) & reverse_techniques())
    yardsticks = ("sweeps", "passes") if reverse else ("sweeps",)
    with style.figure(len(yardsticks), 3, panel=(3.1, 2.7)) as (figure, axes):
        for row, yardstick in zip(axes, yardsticks, strict=True):
            for axis, (what, words) in zip(row, _MEASURES, strict=True):
                group_bars(axis, all_evidence[yardstick], chart.family, techniques, what)
                axis.set_title(f"{words}, {yardstick}")
                axis.set_xlabel("weighting")
                axis.set_ylabel(yardstick)
        handles, labels = axes[0][0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="outside upper center", ncols=len(labels))
        path = folder / f"figure-{chart.number}.png"
        style.save(figure, path)
    return Figure(path, _bar_caption(chart, reverse))


def _bar_caption(chart: BarChart, reverse: bool) -> str:
    text = (
        f"Figure {chart.number} of the thesis: {', '.join(chart.techniques)} on {chart.family} "
        "graphs. Whiskers: 95 % of the bootstrap over graphs."
    )
    if reverse:
        text += " Lower row: there and back counts as one for the reverse techniques."
    return text


def group_bars(
    axis: Axes, evidence: Evidence, family: str, techniques: Sequence[str], what: str
) -> None:
    """Bars of one measure: weightings side by side, one bar a technique, whiskers of 95 %."""
    width = 0.82 / len(techniques)
    for k, technique in enumerate(techniques):
        color, hatch = LOOKS[k % len(LOOKS)]
        places, heights, errors = [], [], []
        for place, weighting in enumerate(WEIGHTINGS):
            found = evidence.of(family, technique, weighting)
            if found is None:
                continue
            values = getattr(found, what)
            low, high = interval(values)
            places.append(place + (k - 0.5 * (len(techniques) - 1)) * width)
            heights.append(values[0])
            errors.append((max(values[0] - low, 0.0), max(high - values[0], 0.0)))
        edge: dict[str, Any] = {"hatch": hatch, "edgecolor": "white", "linewidth": 0.4}
        edge["error_kw"] = {"ecolor": "black", "elinewidth": 0.8, "capsize": 1.6}
        axis.bar(
            places,
            heights,
            width * 0.92,
            label=technique,
            color=color,
            yerr=np.array(errors).T,
            **edge,
        )
    _finish_bars(axis)


def _finish_bars(axis: Axes) -> None:
    axis.set_xticks(range(len(WEIGHTINGS)), [f"{weighting:g}" for weighting in WEIGHTINGS])
    axis.grid(axis="x", visible=False)
    heights = [bar.get_height() for bar in axis.patches if isinstance(bar, Rectangle)]
    tallest = max(heights, default=0.0)
    shortest = min((height for height in heights if height > 0), default=1.0)
    if tallest > 30.0 * shortest:
        axis.set_yscale("symlog", linthresh=max(1.0, shortest))
        axis.set_ylim(bottom=0.0)


def draw_histogram(chart: Histogram, evidence: Evidence, folder: Path) -> Figure | None:
    """How many pushes took how many sweeps, one panel a weighting; None without data."""
    found = {w: evidence.of(chart.family, chart.technique, w) for w in WEIGHTINGS}
    if all(statistics is None for statistics in found.values()):
        return None
    with style.figure(1, 3, panel=(3.1, 2.5)) as (figure, axes):
        for axis in axes[0][1:]:
            axis.sharey(axes[0][0])
        for axis, (weighting, statistics) in zip(axes[0], found.items(), strict=True):
            axis.set_title(f"{chart.technique} {weighting:g}")
            axis.set_xlabel("sweeps")
            if statistics is not None:
                _columns(axis, statistics, SHADES[weighting])
        axes[0][0].set_ylabel("share of pushes (%)")
        path = folder / f"figure-{chart.number}.png"
        style.save(figure, path)
    return Figure(
        path,
        f"Figure {chart.number} of the thesis: sweeps of {chart.technique} on "
        f"{chart.family} graphs.",
    )


def _columns(axis: Axes, statistics: Statistics, color: str) -> None:
    values = np.minimum(statistics.values, LAST_BIN)
    places, counts = np.unique(values, return_counts=True)
    axis.bar(places, 100.0 * counts / len(values), 0.86, color=color)
    axis.set_xlim(0.3, LAST_BIN + 0.7)
    ticks = [1, 5, 10, 15, LAST_BIN]
    axis.set_xticks(ticks, [*map(str, ticks[:-1]), f"{LAST_BIN}+"])
    axis.yaxis.set_major_locator(MaxNLocator(5, integer=True))
    axis.grid(axis="x", visible=False)
    worst = int(statistics.values.max())
    text = (
        f"mean {statistics.mean[0]:.2f}\nmode {int(statistics.mode[0])}\n"
        f"sd {statistics.sd[0]:.2f}\nmost {worst}"
    )
    axis.text(0.97, 0.95, text, transform=axis.transAxes, ha="right", va="top", fontsize=8.5)


def draw_all(all_evidence: dict[str, Evidence], folder: Path) -> tuple[list[Figure], list[Figure]]:
    """All figures of chapter 5, and all of appendix C, that the table has data for."""
    folder.mkdir(parents=True, exist_ok=True)
    bars = [draw_bars(chart, all_evidence, folder) for chart in BAR_CHARTS]
    histograms = [draw_histogram(chart, all_evidence["sweeps"], folder) for chart in HISTOGRAMS]
    return [f for f in bars if f is not None], [f for f in histograms if f is not None]
