# SPDX-License-Identifier: MIT
"""Frames that explain a curve, with weights, and what the curve does not tell."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from pliant._core import MolecularModel, Structure
from pliant.base import console
from pliant.base.display import Displayed, Facts
from pliant.jobs.fit.saxs.choice import Choice, FrameSet, Resampled, chosen, resampled
from pliant.jobs.fit.saxs.curve import Curve
from pliant.jobs.fit.saxs.profiles import Profiles, Weighed
from pliant.trajectory.frames import FramesInMemory
from pliant.trajectory.superposition import superpose_onto
from pliant.trajectory.trajectory import HasFrames, Trajectory

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
    off_start: np.ndarray = field(repr=False)  #: (F) RMSD of all frames from START, Angstrom
    curve: Curve = field(repr=False)
    fitted: np.ndarray = field(repr=False)  #: (n) intensities of the members, as the curve has them
    choice: Choice = field(repr=False)
    background: bool
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

    def _chi2(self, one: FrameSet) -> float:
        free = 2 + len(one.frames) + self.background
        return one.misfit / (len(self.curve.q) - free)

    @property
    def chi2(self) -> float:
        """Mean square error of what was found, in errors of the file."""
        return self._chi2(self.choice.found)

    @property
    def chi2_start(self) -> float:
        """That of START alone."""
        return self._chi2(self.choice.start)

    @property
    def chi2_single(self) -> float:
        """That of the best frame alone."""
        return self._chi2(self.choice.single)

    @property
    def chi2_left_out(self) -> list[float]:
        """Of parts of the curve that frames and weights were not chosen by: of one frame, of two
        ...; none if no ensemble was asked for."""
        left_out = self.choice.left_out
        return [] if left_out is None else left_out.left_out.tolist()

    @property
    def frames(self) -> int:
        """From how many the members are chosen."""
        return len(self.off_start)

    @property
    def agrees(self) -> bool:
        """Whether the curve is explained."""
        return self.chi2 <= EXPLAINS

    @property
    def is_ensemble(self) -> bool:
        """Whether sets of frames were asked for."""
        return self.choice.left_out is not None

    def verdict(self) -> str:
        """In words: whether the curve is explained, by what, and what that is worth."""
        parts = [self._said()]
        if not self.agrees and not self.is_ensemble:
            parts.append("Several shapes together may explain it: --ensemble.")
        if self.agrees and self.chi2_start <= EXPLAINS and self.members[0].frame != 0:
            parts.append("START alone does, too.")
        if self.chi2 < TOO_WELL:
            parts.append("It is explained too well: the errors in the file look too large.")
        parts.append(
            f"The curve has about {self.channels:.0f} independent numbers: many shapes have it, "
            f"and {len(self.others.radii)} curves with other noise chose "
            f"{console.counted(self.others.different, 'set')} of frames."
        )
        return " ".join(parts)

    def _said(self) -> str:
        count = len(self.members)
        what = f"{count} frames together" if count > 1 else f"Frame {self.members[0].frame}"
        chi = f"chi^2 {self.chi2:.2f}, START {self.chi2_start:.2f}"
        if count == 1 and self.members[0].frame == 0:
            what, chi = "START", f"chi^2 {self.chi2:.2f}"
        verb = "" if count > 1 else "s"
        if self.agrees:
            return f"{what} explain{verb} the curve ({chi})."
        return f"The curve is not explained: {what} come{verb} nearest ({chi})."

    def facts(self) -> Facts:
        """How it agrees, and what is not known."""
        q = self.curve.q
        rg = (
            "too few points"
            if self.rg_curve is None
            else "{:.2f} +- {:.2f} A".format(*self.rg_curve)
        )
        sets = "".join(
            f"; {console.counted(k + 1, 'frame')} {self._chi2(one):.2f} (parts left out {left:.2f})"
            for k, (one, left) in enumerate(zip(self.choice.sets, self.chi2_left_out, strict=False))
        )
        water = self.choice.found.water
        return [
            ("verdict", self.verdict()),
            ("curve", f"{len(q)} points, q {q[0]:.3f} to {q[-1]:.3f} 1/A"),
            ("Rg", f"{rg} (curve, Guinier), {self.rg_start:.2f} A (START)"),
            ("chi^2", f"START {self.chi2_start:.2f}, best frame {self.chi2_single:.2f}{sets}"),
            ("water", f"radii x {water.expansion:.3f}, layer {water.layer:.2f}"),
            ("as good alone", self._alike()),
            *([("weights", self._weights())] if len(self.members) > 1 else []),
            ("not told", "mirror images, which part of the chain moved, and shapes of which no "
                         f"frame is among the {self.frames}"),
        ]  # fmt: skip

    def _alike(self) -> str:
        alike = self.choice.alike
        off = self.off_start[alike]
        some = f", {off.min():.1f} to {off.max():.1f} A from START" if len(alike) else ""
        return f"{len(alike)} of {self.frames} frames{some}"

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
            "chi2_sizes": [self._chi2(one) for one in self.choice.sets],
            "chi2_left_out": self.chi2_left_out,
            "rg_curve": self.rg_curve and list(self.rg_curve),
            "rg_start": self.rg_start,
            "channels": self.channels,
            "water": vars(self.choice.found.water),
            "as_good_alone": self.choice.alike.tolist(),
            "resampled": {
                "weights": self.others.weights.mean(axis=0).tolist(),
                "weights_spread": self.others.weights.std(axis=0).tolist(),
                "rg": self.others.radii.mean(axis=0).tolist(),
                "rg_spread": self.others.radii.std(axis=0).tolist(),
                "sets": self.others.different,
            },
            "curve": {
                "q": self.curve.q.tolist(),
                "measured": self.curve.intensity.tolist(),
                "sigma": self.curve.sigma.tolist(),
                "fitted": self.fitted.tolist(),
            },
            "seconds": self.seconds,
        }


def fit_curve(
    curve: Curve,
    model: MolecularModel,
    frames: np.ndarray,
    atoms: np.ndarray,
    *,
    ensemble: bool = False,
    background: bool = False,
    seed: int = 0,
) -> FittedCurve:
    """Chooses among frames (F, N, 3) of a molecule, START first, by a curve; they are superposed by
    `atoms`."""
    profiles = Profiles(model.structure, frames, curve)
    weighed = Weighed(profiles, background)
    nodes = frames[:, atoms]
    off = superpose_onto(nodes, slice(None), nodes[0]) - nodes[0]
    rmsd = np.sqrt((off**2).sum(axis=2).mean(axis=1))
    choice = chosen(weighed, rmsd, ensemble)
    found = choice.found
    radii = profiles.radii_of_gyration(found.water)
    rg_start = float(profiles.radii_of_gyration(choice.start.water)[0])
    return FittedCurve(
        model=model,
        positions=superpose_onto(frames[found.frames], atoms, nodes[0]),
        members=[
            Member(int(k), float(weight), float(radii[k]), float(rmsd[k]))
            for k, weight in zip(found.frames, found.weights, strict=True)
        ],
        off_start=rmsd,
        curve=curve,
        fitted=weighed.fitted(found.intensities(profiles)),
        choice=choice,
        background=background,
        rg_curve=curve.guinier(rg_start),
        rg_start=rg_start,
        channels=float(np.ptp(curve.q) * profiles.diameters[found.frames].max() / math.pi),
        others=resampled(weighed, found, radii, seed),
    )
