# SPDX-License-Identifier: MIT
"""Which frames explain a curve, with which weights, and how many of them are worth it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from pliant.jobs.fit.saxs.profiles import Profiles, Water, Weighed

MOST_FRAMES = 4  #: of a set
BEAM = 200  #: sets of each size that grow by a frame
AT_ONCE = 50  #: sets that grow at a time
SAME = 1e-7  #: frames whose curves differ by less, of their squares, are one
ROUNDS = 4  #: of choosing frames for a water, and a water for the frames
BLOCKS, FOLDS = 20, 5  #: of the curve; blocks that follow each other are left out in turns
RESAMPLES = 20

PRICE = 4.0  #: of a frame, besides of 2 ln(frames there are): misfit that it must save

#: waters for which frames are chosen first
WATERS = [Water(c1, c2) for c1 in (0.96, 0.98, 1.0, 1.02, 1.04) for c2 in (0.0, 1.0, 2.5)]


@dataclass(frozen=True)
class FrameSet:
    """Frames with weights, and the water with which they explain a curve."""

    frames: np.ndarray  #: (K)
    weights: np.ndarray  #: (K) sum 1
    scale: float  #: of the curve
    water: Water
    misfit: float  #: sum of squares, in errors

    def intensities(self, profiles: Profiles) -> np.ndarray:
        """(n) as the curve has them, but for a background."""
        some = profiles.intensities(profiles.partials[self.frames], self.water)
        return np.asarray(self.scale * (self.weights @ some))


@dataclass(frozen=True)
class Sets:
    """Sets of frames of a size, best first."""

    frames: np.ndarray  #: (P, K)
    weights: np.ndarray  #: (P, K) above 0; not scaled
    gains: np.ndarray  #: (P) by which the misfit is less than without any frame


class Search:
    """Sets of non-negative weights for frames whose curves (F, n) sum to a goal (n)."""

    def __init__(self, curves: np.ndarray, goal: np.ndarray) -> None:
        self.along = curves @ goal
        self.gram = curves @ curves.T

    def sets(self, most: int) -> Iterator[Sets]:
        """The best of one frame, of two ...: of one and two frames of all there are, of more those
        that grow from the best."""
        found = self._ones()
        yield found
        for _ in range(1, most):
            found = self._grown(found)
            if len(found.gains) == 0:
                return
            yield found

    def _ones(self) -> Sets:
        weights = self.along / np.diag(self.gram)
        order = np.argsort(-np.maximum(weights, 0) * self.along, kind="stable")
        gains = weights[order] * self.along[order]
        return Sets(order[:, None], weights[order][:, None], gains)

    def _grown(self, parents: Sets) -> Sets:
        parts = []
        count = len(parents.gains) if parents.frames.shape[1] == 1 else BEAM
        for first in range(0, min(count, len(parents.gains)), AT_ONCE):
            some = slice(first, first + AT_ONCE)
            parts.append(self._with_one_more(parents.frames[some], parents.gains[some]))
        frames = np.concatenate([part.frames for part in parts])
        _, first_of = np.unique(np.sort(frames, axis=1), axis=0, return_index=True)
        gains = np.concatenate([part.gains for part in parts])
        order = first_of[np.argsort(-gains[first_of], kind="stable")][:BEAM]
        weights = np.concatenate([part.weights for part in parts])
        return Sets(frames[order], weights[order], gains[order])

    def _with_one_more(self, sets: np.ndarray, gains: np.ndarray) -> Sets:
        """By Schur's complement: what a frame adds that the set has not, and what it takes from the
        weights of the others."""
        cross = self.gram[sets]  # (P, K, F)
        shares = np.linalg.solve(self.gram[sets[:, :, None], sets[:, None, :]], cross)
        before = np.linalg.solve(
            self.gram[sets[:, :, None], sets[:, None, :]], self.along[sets][..., None]
        )
        square = np.diag(self.gram) - (cross * shares).sum(axis=1)
        left = self.along - (cross * before).sum(axis=1)
        new = square > SAME * np.diag(self.gram)
        weight = np.where(new, left / np.where(new, square, 1.0), 0.0)
        others = before - shares * weight[:, None]
        good = new & (weight > 0) & (others > 0).all(axis=1)
        rows, added = np.nonzero(good)
        gained = gains[rows] + weight[good] * left[good]
        order = np.argsort(-gained, kind="stable")[:BEAM]
        rows, added = rows[order], added[order]
        frames = np.concatenate([sets[rows], added[:, None]], axis=1)
        weights = np.concatenate([others[rows, :, added], weight[rows, added][:, None]], axis=1)
        return Sets(frames, weights, gained[order])


def search_at(weighed: Weighed, water: Water) -> Search:
    """Among all frames, with one water for all."""
    profiles = weighed.profiles
    return Search(weighed.of(profiles.intensities(profiles.partials, water)), weighed.goal)


def singles(weighed: Weighed) -> list[FrameSet]:
    """Each frame alone, with the water that suits it."""
    fits = weighed.water_of(weighed.profiles.partials)
    return [
        _scaled(weighed, np.array([k]), np.ones(1), water, misfit)
        for k, (water, misfit) in enumerate(zip(fits.waters, fits.misfits, strict=True))
    ]


def _scaled(
    weighed: Weighed, frames: np.ndarray, shares: np.ndarray, water: Water, misfit: float
) -> FrameSet:
    found = FrameSet(frames, shares, 1.0, water, float(misfit))
    curve = weighed.of(found.intensities(weighed.profiles))
    scale = max(0.0, float(curve @ weighed.goal)) / float(curve @ curve)
    return replace(found, scale=scale)


def best_sets(weighed: Weighed, single: FrameSet, most: int = MOST_FRAMES) -> list[FrameSet]:
    """The best set of each size; of one frame, `single`. Frames are chosen for some waters, the
    water for these frames, and so on."""
    best = {1: single}
    for water in WATERS:
        for sets in list(search_at(weighed, water).sets(most))[1:]:
            _keep_better(best, _with_water(weighed, sets.frames[0], sets.weights[0]))
    for size in list(best)[1:]:
        for _ in range(ROUNDS):
            sets = list(search_at(weighed, best[size].water).sets(size))[-1]
            new = _with_water(weighed, sets.frames[0], sets.weights[0])
            if not _keep_better(best, new):
                break
    return [best[size] for size in sorted(best)]


def _keep_better(best: dict[int, FrameSet], new: FrameSet) -> bool:
    size = len(new.frames)
    if size in best and new.misfit >= best[size].misfit * (1 - 1e-6):
        return False
    best[size] = new
    return True


def _with_water(weighed: Weighed, frames: np.ndarray, weights: np.ndarray) -> FrameSet:
    """The set with the water that suits it, frames of greatest weight first."""
    order = np.argsort(-weights, kind="stable")
    frames, shares = frames[order], weights[order] / weights.sum()
    mixed = np.tensordot(shares, weighed.profiles.partials[frames], axes=1)
    fit = weighed.water_of(mixed[None])
    return _scaled(weighed, frames, shares, fit.waters[0], fit.misfits[0])


def price(frames: int) -> float:
    """By how much a set must lower the misfit for each frame: the best of many lowers it by chance,
    too."""
    return PRICE + 2 * math.log(frames)


def worth_it(sets: Sequence[FrameSet], frames: int, noise: float) -> int:
    """The size that is worth its frames."""
    paid = [one.misfit + noise * price(frames) * len(one.frames) for one in sets]
    return int(np.argmin(paid)) + 1


@dataclass(frozen=True)
class Predicted:
    """How well sets of one frame, of two ... predict parts of the curve that they were not chosen
    by."""

    left_out: np.ndarray  #: (K) mean square, in errors
    blocks: np.ndarray  #: (K, blocks) sums of squares

    @property
    def least(self) -> int:
        """The least size that predicts about as well as any: within a standard error of the
        difference, over blocks."""
        best = int(self.left_out.argmin())
        for size in range(best):
            worse = self.blocks[size] - self.blocks[best]
            if worse.sum() <= np.std(worse, ddof=1) * math.sqrt(len(worse)):
                return size + 1
        return best + 1


def predicted(weighed: Weighed, alone: Sequence[FrameSet], sets: Sequence[FrameSet]) -> Predicted:
    """By cross-validation: of each fifth of the curve, some blocks, by frames and weights that the
    rest chooses. Waters are those of all of the curve, of `alone` and `sets`."""
    curve = weighed.profiles.curve
    block = np.arange(len(curve.q)) * BLOCKS // len(curve.q)
    errors = np.zeros((len(sets), len(curve.q)))
    for fold in range(FOLDS):
        out = block % FOLDS == fold
        rest = Weighed(weighed.profiles, weighed.background, ~out)
        chosen = [_best_alone(rest, alone), *(_chosen_anew(rest, one) for one in sets[1:])]
        for size, found in enumerate(chosen):
            off = curve.intensity - rest.fitted(found.intensities(rest.profiles))
            errors[size, out] = ((off / curve.sigma) ** 2)[out]
    by_block = np.array([np.bincount(block, row) for row in errors])
    return Predicted(errors.mean(axis=1), by_block)


def _best_alone(weighed: Weighed, alone: Sequence[FrameSet]) -> FrameSet:
    curves = weighed.of(np.array([one.intensities(weighed.profiles) for one in alone]))
    along = curves @ weighed.goal
    best = alone[int(np.argmax(np.maximum(along, 0) ** 2 / (curves**2).sum(axis=1)))]
    return _scaled(weighed, best.frames, best.weights, best.water, 0.0)


def _chosen_anew(weighed: Weighed, like: FrameSet) -> FrameSet:
    """The best set of that size, or of the next smaller one there is."""
    sets = list(search_at(weighed, like.water).sets(len(like.frames)))[-1]
    shares = sets.weights[0] / sets.weights[0].sum()
    return _scaled(weighed, sets.frames[0], shares, like.water, 0.0)


@dataclass(frozen=True)
class Resampled:
    """What curves with other noise, about the fitted one, lead to: members by their Rg."""

    weights: np.ndarray  #: (R, K)
    radii: np.ndarray  #: (R, K) Angstrom
    different: int  #: sets of frames


def resampled(weighed: Weighed, found: FrameSet, radii: np.ndarray, seed: int) -> Resampled:
    """Chooses as many frames of radii (F) anew, and the water with them."""
    random = np.random.default_rng(seed)
    fitted = weighed.of(found.intensities(weighed.profiles))
    noise = math.sqrt(max(1.0, found.misfit / len(fitted)))
    weights, gyrations, sets = [], [], set()
    for _ in range(RESAMPLES):
        other = weighed.with_goal(fitted + noise * random.standard_normal(len(fitted)))
        chosen = found
        for _ in range(2):
            best = list(search_at(other, chosen.water).sets(len(found.frames)))[-1]
            chosen = _with_water(other, best.frames[0], best.weights[0])
        order = np.argsort(radii[chosen.frames], kind="stable")
        weights.append(chosen.weights[order])
        gyrations.append(radii[chosen.frames][order])
        sets.add(tuple(sorted(chosen.frames.tolist())))
    return Resampled(np.array(weights), np.array(gyrations), len(sets))


@dataclass(frozen=True)
class Choice:
    """What was chosen, and from what."""

    found: FrameSet
    start: FrameSet  #: START alone
    single: FrameSet  #: the best frame alone
    sets: list[FrameSet]  #: the best of one frame, of two ...; none if not asked for
    left_out: Predicted | None
    alike: np.ndarray  #: frames that explain about as much as what was found, each alone


def chosen(weighed: Weighed, off_start: np.ndarray, ensemble: bool) -> Choice:
    """Of the frames that explain about as much as the best the one nearest to START, which is one
    of them; where an ensemble is asked for, the least set that explains as much.

    `off_start` (F): how far each frame is from START.
    """
    alone = singles(weighed)
    best = min(alone, key=lambda one: one.misfit)
    sets = best_sets(weighed, best) if ensemble else [best]
    noise = max(1.0, sets[-1].misfit / len(weighed.goal))
    misfits = np.array([one.misfit for one in alone])

    def alike(misfit: float) -> np.ndarray:
        return np.flatnonzero(misfits <= misfit + noise * price(len(alone)))

    as_good = alike(best.misfit)
    found = alone[as_good[off_start[as_good].argmin()]]
    left_out = None
    if ensemble:
        left_out = predicted(weighed, alone, sets[: worth_it(sets, len(alone), noise)])
        if left_out.least > 1:
            found = sets[left_out.least - 1]
            as_good = alike(found.misfit)
    return Choice(found, alone[0], best, sets if ensemble else [], left_out, as_good)
