# SPDX-License-Identifier: MIT
"""Frames that explain a curve, with weights, and what the curve does not tell."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from pliant._core import MolecularModel, Structure
from pliant.base.display import Displayed, Facts
from pliant.jobs.fit.saxs.choice import (
    FrameSet,
    Predicted,
    Resampled,
    best_sets,
    predicted,
    resampled,
    singles,
    the_start_or,
    worth_it,
)
from pliant.jobs.fit.saxs.curve import Curve, read_curve
from pliant.jobs.fit.saxs.profiles import Profiles, Water, Weighed
from pliant.trajectory.frames import FramesInMemory
from pliant.trajectory.superposition import superpose_onto
from pliant.trajectory.trajectory import HasFrames, Trajectory

if TYPE_CHECKING:
    from pliant.jobs.fit.fit import Molecule

EXPLAINS = 1.5  #: chi^2 up to which a curve is explained
TOO_WELL = 0.5  #: below, errors in the file are too large, or points do not vary by themselves


@dataclass(frozen=True)
class Member:
    """A frame that explains a curve, alone or with others."""

    frame: int  #: 0 is START
    weight: float
    rg: float  #: Angstrom, with the layer of water
    rmsd: float  #: from START, alpha carbons, Angstrom


@dataclass
class FittedCurve(HasFrames, Displayed):
    """Frames that explain a SAXS curve, the one of greatest weight first."""

    model: MolecularModel = field(repr=False)  #: of the start
    positions: np.ndarray = field(repr=False)  #: (K, N, 3) Angstrom
    members: list[Member]
    frames: int  #: from which they are chosen
    curve: Curve = field(repr=False)
    fitted: np.ndarray = field(repr=False)  #: (n) intensities of the members, as the curve has them
    water: Water
    chi2: float
    chi2_start: float
    chi2_single: float  #: of the best frame alone
    chi2_sizes: list[float]  #: of the best set of one frame, of two ...; none if not asked for
    left_out: list[float]  #: the same of parts that frames and weights were not chosen by
    rg_curve: tuple[float, float] | None  #: and its error, Angstrom; None: too few points
    rg_start: float
    channels: float  #: independent numbers in the curve: C. Shannon; P. Moore (1980)
    others: Resampled = field(repr=False)
    seconds: float = 0.0

    @property
    def structure(self) -> Structure:
        """The molecule, prepared."""
        return self.model.structure

    @property
    def trajectory(self) -> Trajectory:
        """The structures, in memory."""
        return Trajectory._of(FramesInMemory(self.structure, self.positions))

    @property
    def agrees(self) -> bool:
        """Whether the curve is explained."""
        return self.chi2 <= EXPLAINS

    @property
    def is_ensemble(self) -> bool:
        """Whether sets of frames were asked for."""
        return bool(self.left_out)

    def verdict(self) -> str:
        """In words: whether the curve is explained, by what, and what that is worth."""
        chi = f"chi^2 {self.chi2:.2f}, START {self.chi2_start:.2f}"
        one = len(self.members) == 1
        what = f"Frame {self.members[0].frame}" if one else f"{len(self.members)} frames together"
        if one and self.members[0].frame == 0:
            what, chi = "START", f"chi^2 {self.chi2:.2f}"
        does = ("explains" if one else "explain") if self.agrees else "come"
        if self.agrees:
            parts = [f"{what} {does} the curve ({chi})."]
        else:
            parts = [f"The curve is not explained: {what} comes nearest ({chi})."]
            if not self.is_ensemble:
                parts.append("Several shapes together may: --ensemble.")
        if self.chi2 < TOO_WELL:
            parts.append("It is explained too well: the errors in the file look too large.")
        parts.append(
            f"The curve has about {self.channels:.0f} independent numbers: many shapes have it, "
            f"and {len(self.others.radii)} curves with other noise chose "
            f"{self.others.different} different sets of frames."
        )
        return " ".join(parts)

    def facts(self) -> Facts:
        """How it agrees, and what is not known."""
        q = self.curve.q
        rg = "too few points" if self.rg_curve is None else "{:.2f} +- {:.2f} A".format(*self.rg_curve)
        sets = "".join(
            f"; {k + 1} frames {chi2:.2f} (parts left out: {left:.2f})"
            for k, (chi2, left) in enumerate(zip(self.chi2_sizes, self.left_out, strict=False))
        )
        return [
            ("verdict", self.verdict()),
            ("curve", f"{len(q)} points, q {q[0]:.3f} to {q[-1]:.3f} 1/A"),
            ("Rg", f"{rg} (curve, Guinier), {self.rg_start:.2f} A (START)"),
            ("chi^2", f"START {self.chi2_start:.2f}, best frame {self.chi2_single:.2f}{sets}"),
            ("water", f"radii x {self.water.expansion:.3f}, layer {self.water.layer:.2f}"),
            ("weights", self._weights()),
            ("not told", "mirror images, which part of the chain moved, and shapes of which no "
                         f"frame is among the {self.frames}"),
        ]  # fmt: skip

    def _weights(self) -> str:
        """By Rg, as the noise lets them vary."""
        told = zip(*(x.T for x in (self.others.weights, self.others.radii)), strict=True)
        return ", ".join(
            f"{weight.mean():.2f} +- {weight.std():.2f} at Rg {rg.mean():.1f} +- {rg.std():.1f} A"
            for weight, rg in told
        )

    def as_json(self) -> dict[str, Any]:
        """All of it but the positions."""
        return {
            "verdict": self.verdict(),
            "agrees": self.agrees,
            "frames": [vars(one) for one in self.members],
            "chosen_from": self.frames,
            "chi2": self.chi2,
            "chi2_start": self.chi2_start,
            "chi2_single": self.chi2_single,
            "chi2_sizes": self.chi2_sizes,
            "chi2_left_out": self.left_out,
            "rg_curve": self.rg_curve and list(self.rg_curve),
            "rg_start": self.rg_start,
            "channels": self.channels,
            "water": vars(self.water),
            "resampled": {
                "weights": self.others.weights.tolist(),
                "rg": self.others.radii.tolist(),
                "different": self.others.different,
            },
            "curve": {
                "q": self.curve.q.tolist(),
                "measured": self.curve.intensity.tolist(),
                "sigma": self.curve.sigma.tolist(),
                "fitted": self.fitted.tolist(),
            },
            "seconds": self.seconds,
        }


@dataclass(frozen=True)
class _Choice:
    """What was chosen, and from what."""

    found: FrameSet
    start: FrameSet
    single: FrameSet
    sets: list[FrameSet]
    left_out: Predicted | None


def _chosen(weighed: Weighed, ensemble: bool) -> _Choice:
    """START or a frame; where an ensemble is asked for, the least set that explains as much."""
    alone = singles(weighed)
    start, best = alone[0], min(alone, key=lambda one: one.misfit)
    points, frames = len(weighed.goal), len(alone)
    sets = best_sets(weighed, best) if ensemble else [best]
    noise = max(1.0, sets[-1].misfit / points)
    first = the_start_or(best, start, frames, noise)
    if not ensemble:
        return _Choice(first, start, best, [], None)
    worth = worth_it(sets, frames, noise)
    left_out = predicted(weighed, alone, sets[:worth])
    size = left_out.least
    return _Choice(first if size == 1 else sets[size - 1], start, best, sets, left_out)


def fit_curve(
    molecule: Molecule,
    path: str | os.PathLike[str],
    *,
    ensemble: bool = False,
    background: bool = False,
    seed: int = 0,
) -> FittedCurve:
    """Chooses frames of a molecule, which are sampled here, by the curve in a file."""
    curve = read_curve(path)
    molecule.sampled()
    profiles = Profiles(molecule.model.structure, molecule.frames, curve)
    weighed = Weighed(profiles, background)
    chosen = _chosen(weighed, ensemble)
    found = chosen.found
    radii = profiles.radii_of_gyration(found.water)
    nodes = molecule.frames[:, molecule.atoms]
    moved = superpose_onto(molecule.frames[found.frames], molecule.atoms, nodes[0])
    rmsd = np.sqrt(((moved[:, molecule.atoms] - nodes[0]) ** 2).sum(axis=2).mean(axis=1))
    rg_start = float(profiles.radii_of_gyration(chosen.start.water)[0])
    span = float(curve.q[-1] - curve.q[0])

    def chi2(one: FrameSet) -> float:
        free = 2 + len(one.frames) + background
        return one.misfit / (len(curve.q) - free)

    return FittedCurve(
        model=molecule.model,
        positions=moved,
        members=[
            Member(int(k), float(weight), float(radii[k]), float(off))
            for k, weight, off in zip(found.frames, found.weights, rmsd, strict=True)
        ],
        frames=len(profiles),
        curve=curve,
        fitted=weighed.fitted(found.intensities(profiles)),
        water=found.water,
        chi2=chi2(found),
        chi2_start=chi2(chosen.start),
        chi2_single=chi2(chosen.single),
        chi2_sizes=[chi2(one) for one in chosen.sets],
        left_out=[] if chosen.left_out is None else chosen.left_out.left_out.tolist(),
        rg_curve=curve.guinier(rg_start),
        rg_start=rg_start,
        channels=span * float(profiles.diameters[found.frames].max()) / np.pi,
        others=resampled(weighed, found, radii, seed),
    )
