# SPDX-License-Identifier: MIT
"""Mean, mode and standard deviation of a sample, each with its bootstrap over graphs.

The pushes of one graph are no independent draws: what is resampled are whole graphs, with all
pushes of each (cluster bootstrap; Davison and Hinkley, "Bootstrap methods and their application",
1997, section 3.8). One resampling serves all techniques, so differences are paired.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, field

import numpy as np

from pliant.lab.experiment.settings import families
from pliant.lab.experiment.table import Table

REPLICATES = 2000
YARDSTICKS = ("sweeps", "passes", "projections")


@dataclass
class Sample:
    """Numbers of sweeps (or another yardstick) of one technique on one family of graphs."""

    values: np.ndarray  #: (n) whole numbers
    graphs: np.ndarray  #: (n) which graph each is of, from 0
    counts: np.ndarray  #: (R + 1, G) how often each graph is in a replicate; row 0: once each


@dataclass
class Statistics:
    """(R + 1) of each: first of the sample itself, then of the replicates."""

    mean: np.ndarray
    mode: np.ndarray  #: the smallest of the most frequent
    sd: np.ndarray  #: n - 1 in the denominator; 0 of one value
    values: np.ndarray  #: the sample


def statistics_of(sample: Sample) -> Statistics:
    """All three at once; sums are exact, being of whole numbers."""
    shift = sample.values.min()
    offsets = sample.values - shift
    per_graph = [_sum_by_graph(sample, power) for power in (offsets**0, offsets, offsets**2)]
    count, total, squares = (sample.counts @ sums for sums in per_graph)
    count = np.maximum(count, 1)  # a replicate of graphs without any push
    mean = total / count
    variance = (squares - total * mean) / np.maximum(count - 1, 1)
    return Statistics(
        shift + mean, _modes(sample), np.sqrt(np.maximum(variance, 0.0)), sample.values
    )


def _sum_by_graph(sample: Sample, weights: np.ndarray) -> np.ndarray:
    size = sample.counts.shape[1]
    return np.bincount(sample.graphs, weights.astype(float), minlength=size)


def _modes(sample: Sample) -> np.ndarray:
    distinct, place = np.unique(sample.values, return_inverse=True)
    histogram = np.zeros((sample.counts.shape[1], len(distinct)))
    np.add.at(histogram, (sample.graphs, place.reshape(-1)), 1.0)
    modes: np.ndarray = distinct[np.argmax(sample.counts @ histogram, axis=1)]
    return modes


def resampling(graphs: int, replicates: int, seed: int) -> np.ndarray:
    """(R + 1, G) counts: as many graphs drawn with replacement, but for the first row, all once."""
    draws = np.random.Generator(np.random.Philox(key=seed))
    counts = np.ones((replicates + 1, graphs))
    for row in counts[1:]:
        row[:] = np.bincount(draws.integers(graphs, size=graphs), minlength=graphs)
    return counts


@dataclass
class Evidence:
    """What the claims are judged on: pushes that broke a bar, by family of graphs and technique.

    A push that breaks nothing takes 0 sweeps with every technique and is left out.
    """

    table: Table
    yardstick: str = "sweeps"
    replicates: int = REPLICATES
    _known: dict[tuple[str, str, float], Statistics | None] = field(
        default_factory=dict, repr=False
    )

    def __post_init__(self) -> None:
        columns = self.table.columns
        names, family_names = np.array(sorted(families())), families()
        owner = {name: family_names[name].encode() for name in names}
        kinds, place = np.unique(columns["class"], return_inverse=True)
        self._family = np.array([owner[kind.decode()] for kind in kinds])[place]
        self._graph = place * (int(columns["graph"].max()) + 1) + columns["graph"]
        self._broken = columns["sweeps"] > 0
        self._counts = {name: self._resampling(name) for name in np.unique(self._family)}

    def with_yardstick(self, yardstick: str) -> Evidence:
        """The same with another measure of effort."""
        return Evidence(self.table, yardstick, self.replicates)

    def _resampling(self, family: bytes) -> tuple[np.ndarray, np.ndarray]:
        graphs = np.unique(self._graph[self._family == family])
        return graphs, resampling(len(graphs), self.replicates, self.table.settings.seed)

    def rows_of(self, family: str, technique: str, weighting: float) -> np.ndarray:
        """Which rows of the table: all pushes, also those that broke nothing."""
        columns = self.table.columns
        rows: np.ndarray = self._family == family.encode()
        rows &= columns["technique"] == technique.encode()
        rows &= columns["weighting"] == weighting
        return rows

    def has(self, family: str, technique: str, weighting: float) -> bool:
        """There are pushes that broke a bar, resolved with this technique."""
        return self.of(family, technique, weighting) is not None

    def of(self, family: str, technique: str, weighting: float) -> Statistics | None:
        """Statistics over the pushes that broke a bar; None if there are none."""
        key = (family, technique, weighting)
        if key not in self._known:
            self._known[key] = self._measure(*key)
        return self._known[key]

    def _measure(self, family: str, technique: str, weighting: float) -> Statistics | None:
        rows = self.rows_of(family, technique, weighting) & self._broken
        if not rows.any():
            return None
        graphs, counts = self._counts[family.encode()]
        place = np.searchsorted(graphs, self._graph[rows])
        return statistics_of(Sample(self.table.columns[self.yardstick][rows], place, counts))


def interval(values: np.ndarray) -> tuple[float, float]:
    """95 % percentile interval of the replicates."""
    low, high = np.percentile(values[1:], (2.5, 97.5)) if len(values) > 1 else values[[0, 0]]
    return float(low), float(high)


def shown(values: np.ndarray) -> str:
    """ "3.14 [2.9, 3.4]": the sample's value, and the interval of the replicates."""
    return with_interval((float(values[0]), *interval(values)))


def with_interval(found: tuple[float, float, float]) -> str:
    """ "3.14 [2.9, 3.4]" of a value and its interval."""
    return f"{number(found[0])} [{number(found[1])}, {number(found[2])}]"


def number(value: float) -> str:
    """Three digits, or the whole number if it has more."""
    value, size = float(value), abs(value)
    if value == int(value) and size < 1e7:
        return str(int(value))
    return f"{value:.0f}" if size >= 100 else f"{value:.1f}" if size >= 10 else f"{value:.3g}"


def between(counts: Collection[int]) -> str:
    """The smallest and the largest: "2 to 20", or "10" where all are alike."""
    low, high = min(counts), max(counts)
    return str(low) if low == high else f"{low} to {high}"
