# SPDX-License-Identifier: MIT
"""How flexible each unit of a molecule is, with an error, and whether the frames suffice."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.special import stdtrit

from pliant.trajectory.frame_store import FrameStore, variance_of

#: halves agree where their profiles correlate at least so well ...
LEAST_CORRELATION = 0.95
#: ... and differ on average by at most this share of the mean
MOST_DIFFERENCE = 0.10

#: blocks of a path hold at least so many correlation lengths, and there are at most so many blocks
LENGTHS_A_BLOCK = 10
MOST_BLOCKS = 10

#: units that fluctuate by less do not move: Angstrom, the last digit of a PDB file
STILL = 1e-3

#: degrees of freedom that the error common to all units counts for, beside a unit's own
PRIOR_FREEDOM = 6


@dataclass(frozen=True)
class Flexibility:
    """RMSF of n units (residues, or atoms), its error, and how halves of the frames agree."""

    rmsf: np.ndarray  #: (n,) Angstrom
    error: np.ndarray  #: (n,) twice this on either side is a 95 % interval, Angstrom
    halves: np.ndarray  #: (2, n) RMSF within the first and within the second half of the blocks
    blocks: int  #: number of blocks of frames that the error comes from
    correlation: float  #: Pearson's r of the two halves; 1 where there is a single unit
    difference: float  #: mean |difference| of the halves over their mean

    @property
    def still(self) -> bool:
        """Whether nothing moves."""
        return bool(np.all(self.rmsf < STILL))

    @property
    def converged(self) -> bool:
        """Whether the halves agree."""
        return self.correlation >= LEAST_CORRELATION and self.difference <= MOST_DIFFERENCE


def flexibility(
    positions: np.ndarray | FrameStore, units: np.ndarray, blocks: Sequence[np.ndarray]
) -> Flexibility:
    """RMSF of units of atoms, with the error that independent blocks of frames give.

    positions: (F, m, 3) superposed, Angstrom; units: (m,) number from 0 of each atom's unit;
    blocks: two or more arrays of frame numbers. Of a unit RMSF is the root of the mean of its
    atoms' squares. Of B blocks that fluctuate by f_b about their own averages, the error is

        error^2 = (t / 2)^2 s^2 / B + (f - <f_b^2>^(1/2))^2

    with s the standard deviation of f_b and t Student's for 95 %; the second term is what averages
    of blocks are apart, which a drift shows in. A few blocks know s badly, so relative variances
    (s / f)^2 are drawn towards their mean over all units, which counts for PRIOR_FREEDOM degrees of
    freedom beside B - 1, also in t (G. K. Smyth, Stat. Appl. Genet. Mol. Biol. 3 (2004) 3).
    """
    frames = positions if isinstance(positions, FrameStore) else FrameStore.of(positions)
    every = _rmsf(frames, units)
    parts = np.array([_rmsf(frames, units, block) for block in blocks])
    sizes = np.array([len(block) for block in blocks], dtype=float)
    together = np.sqrt((sizes / sizes.sum()) @ parts**2)
    widened = stdtrit(PRIOR_FREEDOM + len(parts) - 1, 0.975) / 2.0
    variance = widened**2 * _moderated(parts, every) / len(parts)
    halves = np.array([_together(parts, sizes, half) for half in _halves(len(blocks))])
    return Flexibility(
        every, np.sqrt(variance + (every - together) ** 2), halves, len(blocks), *agreement(halves)
    )


def agreement(halves: np.ndarray) -> tuple[float, float]:
    """Pearson's r of two profiles (2, n), and their mean difference as a share of their mean."""
    mean = halves.mean()
    difference = float(np.abs(halves[0] - halves[1]).mean() / mean) if mean > 0 else 0.0
    if halves.shape[1] < 2 or np.any(halves.std(axis=1) <= 1e-12 * max(mean, 1e-300)):
        return 1.0, difference
    return float(np.corrcoef(halves)[0, 1]), difference


def _rmsf(frames: FrameStore, units: np.ndarray, chosen: np.ndarray | None = None) -> np.ndarray:
    squares = np.sum(variance_of(frames, chosen), axis=1)
    found: np.ndarray = np.sqrt(np.bincount(units, weights=squares) / np.bincount(units))
    return found


def _moderated(parts: np.ndarray, every: np.ndarray) -> np.ndarray:
    """(n,) variance of a block's RMSF, each unit's drawn towards the relative one of all."""
    squares = every**2
    variance = parts.var(axis=0, ddof=1)
    own = np.divide(variance, squares, out=np.zeros_like(squares), where=squares > 0)
    freedom = len(parts) - 1
    mixed = (PRIOR_FREEDOM * own.mean() + freedom * own) / (PRIOR_FREEDOM + freedom)
    return np.asarray(mixed * squares)


def _halves(count: int) -> tuple[slice, slice]:
    return slice(0, count // 2), slice(count - count // 2, count)


def _together(parts: np.ndarray, sizes: np.ndarray, chosen: slice) -> np.ndarray:
    weights = sizes[chosen] / sizes[chosen].sum()
    return np.asarray(np.sqrt(weights @ parts[chosen] ** 2))


def numbered_blocks(numbers: np.ndarray, size: int) -> list[np.ndarray]:
    """Places of frames by the block of `size` consecutive numbers that they belong to.

    numbers: (F,) of the frames in their ensemble. Blocks that are not all there join the one
    before or after; where fewer than two are whole, there are two halves.
    """
    owners, place = np.unique(numbers // size, return_inverse=True)
    blocks = [np.flatnonzero(place == k) for k in range(len(owners))]
    whole = [len(block) == size for block in blocks]
    if sum(whole) < 2:
        return equal_blocks(len(numbers), 2)
    joined: list[np.ndarray] = []
    rest = np.zeros(0, dtype=np.int64)
    for block, is_whole in zip(blocks, whole, strict=True):
        if is_whole:
            joined.append(np.concatenate([rest, block]))
            rest = rest[:0]
        elif joined:
            joined[-1] = np.concatenate([joined[-1], block])
        else:
            rest = np.concatenate([rest, block])
    return joined


def path_blocks(series: np.ndarray) -> list[np.ndarray]:
    """Blocks of a path: as many as it has LENGTHS_A_BLOCK correlation lengths, 2 to MOST_BLOCKS.

    series: (F,) or (F, k) quantities along the path; the slowest decides.
    """
    columns = np.asarray(series, dtype=float).reshape(len(series), -1).T
    length = max((statistical_inefficiency(column) for column in columns), default=1.0)
    count = int(len(series) / (LENGTHS_A_BLOCK * length))
    return equal_blocks(len(series), min(max(count, 2), MOST_BLOCKS))


def equal_blocks(frames: int, count: int) -> list[np.ndarray]:
    """`count` consecutive stretches of frames, as equal as can be."""
    return np.array_split(np.arange(frames), count)


def statistical_inefficiency(series: np.ndarray) -> float:
    """1 + 2 sum_t (1 - t / F) C(t), up to the first C(t) <= 0: frames that count for one.

    C is the autocorrelation of the series (F,) (W. Janke, NIC Series 10 (2002) 423).
    """
    count = len(series)
    centred = series - series.mean()
    square = float(centred @ centred)
    if square <= 0 or count < 3:
        return 1.0
    spectrum = np.fft.rfft(centred, 2 * count)
    correlation = np.fft.irfft(np.abs(spectrum) ** 2)[:count] / square
    ends = np.flatnonzero(correlation <= 0)
    stop = int(ends[0]) if len(ends) else count
    return max(1.0, 1.0 + 2.0 * float(correlation[1:stop].sum()))


def precision(rmsf: np.ndarray, error: np.ndarray) -> str:
    """ "precision 2 %": two standard errors as a share of a mean RMSF, whose size may be an input;
    "no error" where it is not known."""
    mean, apart = float(rmsf.mean()), 2 * float(error.mean())
    known = mean > 0 and math.isfinite(apart)
    return f"precision {max(1, round(100 * apart / mean))} %" if known else "no error"
