# SPDX-License-Identifier: MIT
"""A density map that a structure is fitted to, and how well it agrees."""

from __future__ import annotations

import copy
import os
import warnings
from dataclasses import dataclass, field
from typing import Any, TypeAlias

import numpy as np

from pliant._core import (
    DensityData,
    DensityMap,
    InputError,
    OptionError,
    PliantWarning,
    Structure,
    check_resolution,
)
from pliant.base.display import Facts
from pliant.jobs.fit import nodes as at_nodes
from pliant.trajectory.superposition import rotations

PLACES, TRIED = 8, 60  #: that START may have in a map, and frames that are tried there
AGREES = 0.5  #: correlation from which a structure and a map are said to agree
BARE = 0.25  #: of the density that residues have by median, for their mass: less supports none
COARSEST = 0.5  #: of the resolution: points of a map further apart keep less than it
SOME = 0.01  #: of the density: less is not worth a place
FLOOR = 1 / 16  #: of the resolution: a map determines no residue better (measured on known pairs)


Given: TypeAlias = "str | os.PathLike[str] | DensityMap"


@dataclass(frozen=True)
class MapData:
    """A map, and what is known of it."""

    density: DensityMap
    resolution: float  #: Angstrom
    half: DensityMap | None = None  #: an independent map of the same, to judge by

    def at_nodes(self, structure: Structure, frames: np.ndarray) -> DensityData:
        """For fits of frames (F, M, 3) of its nodes. Raises InputError where none is in the map."""
        outside = self.density.at(frames[0])[2]
        if outside:
            text = f"{outside} of {len(frames[0])} residues of START are outside of the map"
            warnings.warn(text, PliantWarning, stacklevel=5)
        return DensityData(self.density, self.resolution, structure, frames)

    def refuse_outside(self, nodes: np.ndarray) -> None:
        """Raises InputError where none of them (M, 3) is in the map."""
        if self.density.at(nodes)[2] == len(nodes):
            text = "the molecule lies outside of it; put it there first (place)"
            raise InputError(f"density map: {text}")

    def spread(self, between: np.ndarray) -> np.ndarray:
        """By residue, of the spread between fits: not below what the map itself leaves open."""
        return np.asarray(np.sqrt(between**2 + (FLOOR * self.resolution) ** 2))

    def motion(
        self, structure: Structure, atoms: np.ndarray, frames: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """x @ rotation + shift puts the structure into the map, wherever it is.

        Of several places that one is taken where one of the frames (F, M, 3) of its `atoms`
        correlates best: the start alone fits a map of another shape badly.
        """
        here = np.asarray(structure.positions)
        some = frames[:: 1 + (len(frames) - 1) // TRIED]
        best, found = -np.inf, (np.eye(3), np.zeros(3))
        for placed in self.density.placings(structure, self.resolution, PLACES)[0]:
            centre, moved = here.mean(axis=0), placed.mean(axis=0)
            rotation = rotations((here - centre).T @ (placed - moved))
            there = np.ascontiguousarray((some - centre) @ rotation + moved)
            data = DensityData(self.density, self.resolution, structure, there)
            correlation = float(data.correlations(there, False).max())
            if correlation > best:
                best, found = correlation, (rotation, moved - centre @ rotation)
        return found


def read_map(density: Given, resolution: float | None, half: Given | None) -> MapData:
    """Raises OptionError without a resolution in range, InputError for a file that is no map."""
    if resolution is None:
        raise OptionError("resolution: a map needs it, in Angstrom; a header does not say it")
    check_resolution(resolution)
    found = MapData(_read(density), resolution, None if half is None else _read(half))
    spacing = float(found.density.spacing.max())
    if spacing > COARSEST * resolution:
        warnings.warn(
            f"points of the map are {spacing:.3g} A apart: too far for a resolution of "
            f"{resolution:g} A",
            PliantWarning,
            stacklevel=3,
        )
    return found


def _read(given: Given) -> DensityMap:
    return given if isinstance(given, DensityMap) else DensityMap.read(given)


@dataclass(frozen=True)
class Freedom:
    """A fit in which the map counts more than in the one before."""

    strain: float  #: energy of the shape
    correlation: float  #: with the map, of residues
    judged: float | None  #: with the other half


@dataclass(frozen=True)
class MapAgreement:
    """How structure and map agree. Correlations are about the means, near to atoms."""

    resolution: float
    at_start: float
    found: float
    judged: float | None  #: of the structure with the other half
    judged_at_start: float | None
    by_residue: np.ndarray = field(repr=False)  #: (M,)
    by_residue_at_start: np.ndarray = field(repr=False)  #: (M,)
    unsupported: list[str]  #: residues that no density supports
    unexplained: float  #: share of the density that no atom is near to
    most_unexplained: tuple[float, float, float] | None  #: where, Angstrom
    freedom: list[Freedom]  #: over-fitting: strain goes on rising where agreement does not

    @property
    def agrees(self) -> bool:
        """Whether they correlate, and no worse than at the start."""
        return self.found >= max(AGREES, self.at_start - at_nodes.CORRELATES)

    @property
    def is_overfitted(self) -> bool:
        """Whether the other half agrees less than with START, though the map agrees more."""
        if self.judged is None or self.judged_at_start is None:
            return False
        return self.found > self.at_start and self.judged < self.judged_at_start

    def verdict(self) -> list[str]:
        """Sentences."""
        said = [
            f"Structure and map {'agree' if self.agrees else 'do not agree'}: correlation "
            f"{self.found:.2f} (START {self.at_start:.2f})."
        ]
        if self.is_overfitted:
            said.append("The other half of the map agrees less than with START: over-fitted.")
        if self.unsupported:
            few = ", ".join(self.unsupported[:6]) + (", ..." if len(self.unsupported) > 6 else "")
            said.append(f"No density supports {len(self.unsupported)} residues ({few}).")
        return said

    def facts(self) -> Facts:
        """What is printed."""
        rows = [("map", f"correlation {self.found:.3f} (START {self.at_start:.3f}); residues "
                        f"{self.by_residue.min():.2f} to {self.by_residue.max():.2f}")]  # fmt: skip
        if self.judged is not None:
            rows.append(("other half", f"{self.judged:.3f} (START {self.judged_at_start:.3f})"))
        where = self.most_unexplained
        most = (
            ""
            if where is None or self.unexplained < SOME
            else ", most at " + " ".join(f"{x:.0f}" for x in where) + " A"
        )
        rows.append(("unexplained", f"{100 * self.unexplained:.0f} % of the density{most}"))
        return rows

    def as_json(self, labels: list[str]) -> dict[str, Any]:
        """All of it."""
        rest = {name: value for name, value in vars(self).items() if "by_residue" not in name}
        return {
            **rest,
            "agrees": self.agrees,
            "freedom": [vars(one) for one in self.freedom],
            "by_residue": dict(zip(labels, self.by_residue.tolist(), strict=True)),
            "by_residue_at_start": dict(
                zip(labels, self.by_residue_at_start.tolist(), strict=True)
            ),
        }


def at(structure: Structure, positions: np.ndarray) -> Structure:
    """The same atoms elsewhere."""
    moved = copy.deepcopy(structure)
    moved.positions = positions
    return moved


def agreement_with(
    data: MapData,
    start: Structure,
    found: Structure,
    atoms: np.ndarray,
    labels: list[str],
    freedom: list[Freedom],
) -> MapAgreement:
    """Of structures that are in the map; `atoms` are those of residues with `labels`."""
    density, resolution, half = data.density, data.resolution, data.half
    owners = np.asarray(found.residue_of)[atoms]
    share, centers, _ = density.unexplained(found)
    expected = DensityMap.from_structure(found, resolution, like=density)
    places = np.asarray(found.positions)[atoms]
    support = density.at(places)[0] / np.maximum(expected.at(places)[0], 1e-9)
    bare = np.flatnonzero(support < BARE * np.median(support))
    return MapAgreement(
        resolution=resolution,
        at_start=density.correlation(start, resolution),
        found=density.correlation(found, resolution),
        judged=None if half is None else half.correlation(found, resolution),
        judged_at_start=None if half is None else half.correlation(start, resolution),
        by_residue=density.local_correlation(found, resolution)[owners],
        by_residue_at_start=density.local_correlation(start, resolution)[owners],
        unsupported=[labels[k] for k in bare],
        unexplained=share,
        most_unexplained=None if len(centers) == 0 else tuple(centers[0].tolist()),
        freedom=freedom,
    )


def freedom_of(
    data: MapData, of: at_nodes.Ensemble, known: at_nodes.Known, structure: Structure, start: int
) -> list[Freedom]:
    """Fits from one frame in which the data count more and more."""
    one = at_nodes.Ensemble(of.start, of.frames[[start]], of.chains)
    half = None
    if data.half is not None:
        half = DensityData(data.half, data.resolution, structure, of.frames)
    rows = []
    for stages in range(1, at_nodes.STAGES + 1):
        fits = at_nodes.fitted(one, known, stages=stages)
        judged = None if half is None else float(half.correlations(fits.positions[:1], True)[0])
        rows.append(Freedom(float(fits.strain[0]), float(fits.correlations[0]), judged))
    return rows
