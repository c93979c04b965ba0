# SPDX-License-Identifier: MIT
"""Two ensembles residue by residue: how far each moves, in which directions, what one lacks."""

from __future__ import annotations

import numpy as np

from pliant._core import Trace
from pliant.measure import agreement as alike
from pliant.measure.agreement import TEN, Figure, Modes
from pliant.measure.collective import moving_stretches, participation
from pliant.measure.compared.core import core_of
from pliant.measure.compared.reference import STRUCTURE, TRAJECTORY, ReferenceFrames
from pliant.measure.compared.residue_report import (
    Displacement,
    MissingMode,
    Profile,
    ResidueComparison,
    Stretch,
    Subspaces,
)
from pliant.measure.flexibility import flexibility, numbered_blocks, path_blocks

WHITE = 100  #: numbers of frames of `pliant sample` are white within blocks of so many
LEAST_RESIDUES = 5  #: fewer are compared by atoms alone
LEAST_FRAMES = 4  #: for errors and for halves
DRAWS = 200  #: of the bootstrap of RMSF
MOST_DRAWS, FEWEST_DRAWS = 100, 20  #: of bootstraps that need principal components
WORK = 4e9  #: multiplications that such a bootstrap may take, about
LEAST_FACTOR = 1.3  #: residues that differ by less are not named, however sure the difference
LEAST_COVERED = 0.5  #: modes that the other ensemble has less of than this are named
LEAST_MODE = 0.02  #: of the variance; smaller modes are not worth a word
MOST_STRETCHES = 5


def compare_residues(
    trace: Trace, ours: np.ndarray, independent: np.ndarray | None, reference: ReferenceFrames
) -> ResidueComparison:
    """Measures both.

    trace: of ours; ours: (F, R, 3) Angstrom on it; independent: (F,) numbers of frames that are
    drawn independently of each other, None where each comes from the one before.
    """
    mine, theirs = ours[:, reference.residues], reference.frames
    chains = trace.chains[reference.residues]
    core = core_of(mine, theirs, chains)
    fit = np.flatnonzero(core)
    theirs = alike.superposed_on_mean(theirs, fit)
    mine = alike.superposed_on_mean(mine, fit)
    mine = alike.turned_as_one(mine, theirs.mean(axis=0), fit)
    found = ResidueComparison(
        reference.kind,
        [trace.label(k) for k in reference.residues],
        chains,
        core,
        trace.ranges(reference.residues[~core]),
        _profile(mine, independent),
        None,
        notes=list(reference.notes),
    )
    if reference.kind == STRUCTURE:
        found.displacement = _displacement(mine[:, core], theirs[0][core])
        return found
    numbers = None if reference.kind == TRAJECTORY else np.arange(len(theirs))
    found.theirs = _profile(theirs, numbers)
    _compare_profiles(found, theirs, trace, reference.residues)
    ceiling = np.nan
    if len(theirs) >= LEAST_FRAMES:
        found.r_ceiling, ceiling = alike.halves(theirs[:, core])
    found.subspaces = _subspaces(mine, theirs, found, ceiling, trace, reference.residues)
    return found


def _profile(frames: np.ndarray, independent: np.ndarray | None) -> Profile:
    """RMSF and its error: by blocks of frames, or by bootstrap where each frame is one's own."""
    count = frames.shape[1]
    rmsf = alike.fluctuations(frames)
    if len(frames) < LEAST_FRAMES:
        return Profile(rmsf, np.full(count, np.nan), len(frames))
    if independent is not None and len(frames) < 2 * WHITE:
        return Profile(rmsf, _bootstrapped(frames), len(frames))
    if independent is not None:
        blocks = numbered_blocks(independent, WHITE)
    else:
        centred = (frames - frames.mean(axis=0)).reshape(len(frames), -1)
        blocks = path_blocks(centred @ alike.components(frames, 3).T)
    found = flexibility(frames, np.arange(count), blocks)
    return Profile(rmsf, found.error, len(frames))


def _bootstrapped(frames: np.ndarray) -> np.ndarray:
    """(K,) standard error of RMSF over draws of frames, all draws at once."""
    count = len(frames)
    random = np.random.default_rng(0)
    weights = np.array(
        [np.bincount(random.integers(0, count, count), minlength=count) for _ in range(DRAWS)]
    ) / float(count)
    spread = frames - frames.mean(axis=0)
    means = np.einsum("bf,fki->bki", weights, spread)
    squares = weights @ (spread**2).sum(axis=2)
    drawn = np.sqrt(np.maximum(squares - (means**2).sum(axis=2), 0.0))
    errors: np.ndarray = drawn.std(axis=0)
    return errors


def _compare_profiles(
    found: ResidueComparison, theirs: np.ndarray, trace: Trace, residues: np.ndarray
) -> None:
    assert found.theirs is not None
    core, (ours, other) = found.core, (found.ours.rmsf, found.theirs.rmsf)
    found.r = alike.correlation_over_residues(ours[core], other[core])
    found.r_all = alike.correlation(ours, other)
    if found.kind == TRAJECTORY and len(theirs) >= LEAST_FRAMES:
        middle = len(theirs) // 2
        found.r_in_time = alike.compared_halves(theirs[:middle, core], theirs[middle:, core])[0]
    mean = float(ours[core].mean())
    found.scale = float(other[core].mean()) / mean if mean > 0 else np.nan
    scaled = found.scale * ours
    error = 2.0 * np.hypot(found.scale * found.ours.error, found.theirs.error)
    found.more = core & (scaled - other > error) & (scaled > LEAST_FACTOR * other)
    found.less = core & (other - scaled > error) & (other > LEAST_FACTOR * scaled)
    found.more_stretches, found.less_stretches = (
        _stretches(which, scaled, other, trace, residues) for which in (found.more, found.less)
    )


def _stretches(
    which: np.ndarray, ours: np.ndarray, theirs: np.ndarray, trace: Trace, residues: np.ndarray
) -> list[Stretch]:
    """Residues next to each other as one, those that differ most first."""
    places = np.flatnonzero(which)
    if len(places) == 0:
        return []
    apart = (np.diff(residues[places]) > 1) | (
        trace.chains[residues[places[1:]]] != trace.chains[residues[places[:-1]]]
    )
    parts = np.split(places, np.flatnonzero(apart) + 1)
    parts.sort(key=lambda part: -float(np.abs(ours[part] - theirs[part]).sum()))
    return [
        Stretch(trace.ranges(residues[part]), float(ours[part].mean()), float(theirs[part].mean()))
        for part in parts
    ]


def _subspaces(
    ours: np.ndarray,
    theirs: np.ndarray,
    found: ResidueComparison,
    ceiling: float,
    trace: Trace,
    residues: np.ndarray,
) -> Subspaces:
    core = found.core
    mine, other = (alike.principal_modes(frames[:, core], TEN) for frames in (ours, theirs))
    vectors = mine.vectors, other.vectors
    covered_ours, covered_theirs = alike.covered(*vectors), alike.covered(*vectors[::-1])
    spread = (theirs - theirs.mean(axis=0))[:, core].reshape(len(theirs), -1)
    within = float(((spread @ vectors[0].T) ** 2).sum() / max((spread**2).sum(), 1e-300))
    count = min(len(vectors[0]), len(vectors[1]))
    chosen = residues[core]
    return Subspaces(
        mine,
        other,
        alike.overlaps(*vectors),
        Figure(alike.rmsip(*vectors), _rmsip_error(mine, theirs[:, core])),
        ceiling,
        alike.chance_rmsip(count, int(core.sum())),
        covered_ours,
        covered_theirs,
        within,
        _missing(mine, covered_ours, trace, chosen),
        _missing(other, covered_theirs, trace, chosen),
    )


def _rmsip_error(ours: Modes, theirs: np.ndarray) -> float:
    """Over draws of their frames, as many as take bearable time."""
    frames, columns = len(theirs), theirs[0].size
    if frames < LEAST_FRAMES:
        return float("nan")
    work = float(frames) * columns * min(frames, columns)
    draws = int(np.clip(WORK / work, FEWEST_DRAWS, MOST_DRAWS))

    def figure(chosen: np.ndarray) -> list[float]:
        return [alike.rmsip(ours.vectors, alike.components(theirs[chosen]))]

    return float(alike.bootstrap(frames, figure, draws)[0])


def _missing(
    modes: Modes, covered: np.ndarray, trace: Trace, residues: np.ndarray
) -> list[MissingMode]:
    shares = modes.variances / modes.total if modes.total > 0 else modes.variances
    named = np.flatnonzero((covered < LEAST_COVERED) & (shares >= LEAST_MODE))
    if len(named) == 0:
        return []
    moving = participation(modes.vectors)
    found = []
    for k in named:
        parts = moving_stretches(moving[k], trace.chains[residues], MOST_STRETCHES)
        where = [trace.ranges(residues[first : last + 1]) for first, last, _ in parts]
        found.append(MissingMode(int(k) + 1, float(shares[k]), float(covered[k]), ", ".join(where)))
    return found


def _displacement(ours: np.ndarray, theirs: np.ndarray) -> Displacement:
    """From the middle of ours (F, k, 3) to a structure (k, 3)."""
    middle = ours.mean(axis=0)
    goal = alike.superposed(theirs[None], middle)[0]
    away = goal - middle
    placed = alike.superposed(ours, theirs)
    rmsd = np.sqrt(((placed - theirs) ** 2).sum(axis=2).mean(axis=1))
    distance = float(np.sqrt((away**2).sum(axis=1).mean()))

    def figures(chosen: np.ndarray) -> list[float]:
        return [alike.cumulative_overlap(alike.components(ours[chosen]), away)]

    if distance == 0.0:
        return Displacement(0.0, float(rmsd.min()), Figure(), np.nan)
    error = float(alike.bootstrap(len(ours), figures, FEWEST_DRAWS)[0])
    overlap = Figure(figures(np.arange(len(ours)))[0], error)
    chance = alike.chance_rmsip(min(TEN, len(ours) - 1), len(middle))
    return Displacement(distance, float(rmsd.min()), overlap, chance)
