# SPDX-License-Identifier: MIT
"""Rows of agreement: fluctuations, changes of structure, transitions, crystals."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pliant._core import align
from pliant.lab.validity.cases import Fluctuation
from pliant.lab.validity.peers import Network, gnm_fluctuations, network_of
from pliant.lab.validity.references import BFactors, ReferenceEnsemble
from pliant.lab.validity.rows import Row
from pliant.lab.validity.stereochemistry import Stereochemistry
from pliant.lab.validity.subject import AMPLITUDE, FAR, Subject
from pliant.measure import agreement as alike
from pliant.measure.agreement import TEN, Figure

CLASHES = "clashes of 1000 heavy atoms"
DRAWS = 100  #: of bootstraps that need principal components


@dataclass(frozen=True)
class Compared:
    """Two ensembles on the residues that both have, superposed on the mean of theirs."""

    residues: np.ndarray  #: (K, 2) of ours and of theirs
    ours: np.ndarray  #: (F, K, 3)
    theirs: np.ndarray  #: (G, K, 3)
    about_start: np.ndarray  #: theirs superposed on the start, about which peers fluctuate


def compared(subject: Subject, reference: ReferenceEnsemble, last: int | None = None) -> Compared:
    """Our ensemble of seed 0 and a reference, or the first `last` residues of the reference."""
    residues = align(subject.trace.sequence, reference.sequence)
    residues = residues[residues[:, 1] < (last or np.inf)]
    theirs = alike.superposed_on_mean(reference.frames[:, residues[:, 1]])
    ours = alike.superposed_on_mean(subject.ensemble().frames[:, residues[:, 0]])
    start = subject.trace.positions[residues[:, 0]]
    ours = alike.superposed(ours, theirs.mean(axis=0))
    return Compared(residues, ours, theirs, alike.superposed(theirs, start))


def fluctuation_rows(subject: Subject, both: Compared, case: Fluctuation) -> list[Row]:
    """r of RMSF and RMSIP; peers are judged about their own start, as ProDy's users do."""
    mine = both.residues[:, 0]
    part = np.flatnonzero(both.residues[:, 1] < (case.residues or np.inf))
    rmsf, about_start = (alike.fluctuations(one) for one in (both.theirs, both.about_start))
    found = {
        "ours": alike.correlation_over_residues(alike.fluctuations(both.ours)[part], rmsf[part])
    }
    for peer in ("shared", "anm", "gnm"):
        profile = subject.network(peer).fluctuations[mine]
        found[peer] = alike.correlation_over_residues(profile[part], about_start[part])
    r = _row(case.name, case.figure, found["ours"], found["shared"], found["anm"], found["gnm"])
    inner = _rmsip_row(
        case.name, {"ours": alike.components(both.ours)} | _modes(subject, mine), both
    )
    r.ceiling, inner.ceiling = alike.halves(both.theirs)
    for row in (r, inner):
        row.data, row.note = case.data, case.note
    return [r, inner]


def alone_row(subject: Subject, alone: Compared, case: Fluctuation) -> Row:
    """r of RMSF of residues that were superposed without the flexible ends: these tilt the others,
    in our frames and in theirs alike, and so raise r where the others are compared."""
    rmsf, about_start = (alike.fluctuations(one) for one in (alone.theirs, alone.about_start))
    ours = alike.correlation_over_residues(alike.fluctuations(alone.ours), rmsf)
    shared, anm = (
        alike.correlation_over_residues(_alone(subject, alone, peer).fluctuations, about_start)
        for peer in ("shared", "anm")
    )
    row = _row(case.name, case.figure_alone, ours, shared, anm)
    row.ceiling = alike.halves(alone.theirs)[0]
    row.data, row.note = case.data, case.note
    return row


def _alone(subject: Subject, alone: Compared, peer: str) -> Network:
    mine = alone.residues[:, 0]
    return subject.network(peer).superposed(mine, subject.trace.positions[mine])


def profiles_alone(subject: Subject, alone: Compared) -> dict[str, list[float]]:
    """As profiles, of residues that were superposed alone."""
    anm = _alone(subject, alone, "anm").fluctuations
    return profiles(subject, alone) | {"anm": anm.tolist()}


def profiles(subject: Subject, both: Compared) -> dict[str, list[float]]:
    """RMSF of the reference, ours and ANM's, residue by residue, for the picture."""
    return {
        "reference": alike.fluctuations(both.theirs).tolist(),
        "ours": alike.fluctuations(both.ours).tolist(),
        "anm": subject.network("anm").fluctuations[both.residues[:, 0]].tolist(),
    }


def _row(
    name: str, figure: str, ours: Figure, network: Figure, anm: Figure, gnm: Figure | None = None
) -> Row:
    rivals = (network.value, anm.value, anm.error, gnm.value if gnm else float("nan"))
    return Row(name, figure, ours.value, ours.error, *rivals)


def _modes(subject: Subject, atoms: np.ndarray) -> dict[str, np.ndarray]:
    """First modes of peers on the atoms that both have."""
    return {
        peer: alike.orthonormal(subject.network(peer).directions, atoms)
        for peer in ("shared", "anm")
    }


def _rmsip_row(name: str, modes: dict[str, np.ndarray], both: Compared) -> Row:
    """Errors over their frames."""

    def figures(chosen: np.ndarray) -> list[float]:
        about_mean, about_start = (
            alike.components(one[chosen]) for one in (both.theirs, both.about_start)
        )
        return [
            alike.rmsip(rows, about_mean if key == "ours" else about_start)
            for key, rows in modes.items()
        ]

    count = len(both.theirs)
    values, errors = figures(np.arange(count)), alike.bootstrap(count, figures, DRAWS)
    found = [Figure(*pair) for pair in zip(values, errors.tolist(), strict=True)]
    return _row(name, "RMSIP of 10", *found)


def clash_row(subject: Subject, name: str) -> Row:
    """Clashes of frames, which must not be more than those of the start."""
    look = subject.ensemble().look
    start = look.clashes_of_start
    note = f"{start:.1f} in the start, {look.clashes:.1f} in {look.frames} frames"
    return Row(name, CLASHES, look.clashes, must=start, aim=start, least=False, note=note)


def exact_rows(name: str, looks: Sequence[Stereochemistry]) -> list[Row]:
    """What must be exact in every frame."""
    figures = {
        "worst bar, relative": max(look.worst_bar for look in looks),
        "new overlaps > 0.1 Angstrom": sum(look.overlaps for look in looks),
        "flipped chirality": sum(look.flipped for look in looks),
        "omega off > 5 degrees": sum(look.turned for look in looks),
    }
    rows = [Row(name, key, value) for key, value in figures.items()]
    deepest = max(look.worst_overlap for look in looks)
    rows[1].note = f"the deepest is {deepest:.3f} Angstrom"
    return rows


def change_row(subject: Subject, target: ReferenceEnsemble, name: str, data: str) -> Row:
    """How much of the way to another structure lies within ten modes. Error over our frames."""
    pairs = align(subject.trace.sequence, target.sequence)
    start = subject.trace.positions[pairs[:, 0]]
    ours = alike.superposed_on_mean(subject.ensemble().frames[:, pairs[:, 0]])
    placed = alike.superposed(start[None], ours.mean(axis=0))[0]
    goal = alike.superposed(target.frames[0][pairs[:, 1]][None], placed)[0]

    def figures(chosen: np.ndarray) -> list[float]:
        return [alike.cumulative_overlap(alike.components(ours[chosen]), goal - placed)]

    error = float(alike.bootstrap(len(ours), figures, DRAWS)[0])
    found = Figure(figures(np.arange(len(ours)))[0], error)
    away = alike.superposed(target.frames[0][pairs[:, 1]][None], start)[0] - start
    peers = {
        peer: Figure(alike.cumulative_overlap(modes, away))
        for peer, modes in _modes(subject, pairs[:, 0]).items()
    }
    row = _row(name, f"cumulative overlap of {TEN}", found, peers["shared"], peers["anm"])
    row.data = data
    row.note = f"{np.sqrt((away**2).sum(axis=1).mean()):.1f} Angstrom apart"
    return row


def path_row(subject: Subject, path: ReferenceEnsemble, name: str, data: str) -> Row:
    """Root of the share of a transition's motion away from the start within ten modes."""
    pairs = align(subject.trace.sequence, path.sequence)
    start = subject.trace.positions[pairs[:, 0]]
    ours = alike.superposed_on_mean(subject.ensemble().frames[:, pairs[:, 0]])
    ours = alike.superposed(ours, start)
    away = (alike.superposed(path.frames[:, pairs[:, 1]], start) - start).reshape(
        len(path.frames), -1
    )

    def share(modes: np.ndarray) -> Figure:
        return Figure(float(np.sqrt(((away @ modes[:TEN].T) ** 2).sum() / (away**2).sum())))

    peers = {peer: share(modes) for peer, modes in _modes(subject, pairs[:, 0]).items()}
    figure, ours_share = "of a transition (DIMS MD), in 10 modes", share(alike.components(ours))
    row = _row(name, figure, ours_share, peers["shared"], peers["anm"])
    row.data = data
    return row


def seed_rows(subject: Subject, name: str, seeds: int, data: str) -> list[Row]:
    """The worst r of RMSF and RMSIP of two seeds."""
    if seeds < 2:
        return []
    first = alike.superposed_on_mean(subject.ensemble().frames)
    mean = first.mean(axis=0)
    all_frames = [
        alike.superposed(alike.superposed_on_mean(subject.ensemble(seed).frames), mean)
        for seed in range(seeds)
    ]
    profiles = [alike.fluctuations(frames) for frames in all_frames]
    modes = [alike.components(frames) for frames in all_frames]
    pairs = list(itertools.combinations(range(seeds), 2))
    r = min(alike.correlation(profiles[a], profiles[b]) for a, b in pairs)
    inner = min(alike.rmsip(modes[a], modes[b]) for a, b in pairs)
    note = f"{len(pairs)} pairs of {seeds} seeds"
    figures = {"two seeds, r of RMSF, the worst": r, "two seeds, RMSIP of 10, the worst": inner}
    return [Row(name, figure, value, data=data, note=note) for figure, value in figures.items()]


def frame_rows(subject: Subject, name: str) -> list[Row]:
    """Ramachandran outliers, and frames drawn again."""
    look, anm = subject.ensemble().look, subject.anm_look()
    figure = "Ramachandran outliers above the start's, %"
    excess = [100 * (one.outliers - one.outliers_of_start) for one in (look, anm)]
    error = float(np.std(look.outliers_of_frames) / np.sqrt(max(look.frames, 1)))
    rows = [Row(name, figure, excess[0], 100 * error, anm=excess[1])]
    rows[0].note = f"the start has {100 * look.outliers_of_start:.1f} % of {look.residues}"
    for amplitude in (AMPLITUDE, FAR):
        figure = f"redrawn at {amplitude:g} Angstrom, %"
        drawn = subject.ensemble(0, amplitude)
        share = 100 * drawn.redrawn / (look.frames + drawn.failed)
        note = f"{drawn.failed} frames given up" if drawn.failed else ""
        rows.append(Row(name, figure, share, note=note))
    return rows


def crystal_figures(found: BFactors) -> list[float]:
    """r of roots of B factors: of our estimate, ANM and GNM."""
    root, trace = np.sqrt(found.values), found.trace
    anm = network_of(found.structure, trace, "anm").fluctuations[found.chain]
    gnm = gnm_fluctuations(trace.positions)[found.chain]
    return [alike.correlation(one, root) for one in (np.sqrt(found.estimate), anm, gnm)]
