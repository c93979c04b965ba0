# SPDX-License-Identifier: MIT
"""A structure and the data that it is fitted to: read and checked, before anything takes long."""

from __future__ import annotations

import os
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np

from pliant._core import OptionError, PathOptions, PliantWarning
from pliant.jobs.fit import in_map
from pliant.jobs.fit import nodes as at_nodes
from pliant.jobs.fit.data import Datum, in_nanometres, read_distances, with_dyes_in
from pliant.jobs.fit.fitted import FittedStructure, Whole, agreement_of, measured
from pliant.jobs.fit.labels import DYES, Labels
from pliant.jobs.fit.molecule import Molecule
from pliant.jobs.fit.nodes import outside
from pliant.measure.backbone import ramachandran_outliers
from pliant.trajectory.superposition import superpose_onto

ROUNDS = 3  #: of fits where there are dyes

Distances: TypeAlias = "str | os.PathLike[str] | Sequence[Mapping[str, Any]]"


@dataclass(frozen=True)
class FitTask:
    """What is fitted to what."""

    molecule: Molecule
    data: list[Datum]
    density: in_map.MapData | None
    place: bool  #: whether the start is to be put into the map first

    @classmethod
    def of(
        cls,
        start: Any,
        distances: Distances | None,
        density: in_map.Given | None,
        resolution: float | None,
        half: in_map.Given | None,
        place: bool,
        seed: int,
        options: PathOptions,
    ) -> FitTask:
        """Raises OptionError or InputError, which say what is wrong, as `fit` does."""
        if density is None and (resolution is not None or half is not None or place):
            raise OptionError("resolution, half, place: of a map, and none is given")
        read = None if density is None else in_map.read_map(density, resolution, half)
        molecule = Molecule(start, seed, options)
        data = [] if distances is None else _distances(molecule, distances)
        if read is not None and not place:
            read.refuse_outside(molecule.placed[molecule.atoms])
        return cls(molecule, data, read, place)

    def fitted(self, keep: int = 1) -> FittedStructure:
        """Of a molecule whose ensemble is there."""
        molecule, data, density = self.molecule, self.data, self.density
        if density is not None and self.place:
            molecule.place_into(density)
        of, structure = molecule.ensemble, molecule.structure
        known = at_nodes.Known(data)
        if density is not None:
            known = at_nodes.Known(data, density.at_nodes(structure, of.frames))
        known, found, wholes = self._rounds(of, known, keep)
        fits, best = found.fits, wholes[0].positions
        outliers = ramachandran_outliers(structure, np.array([molecule.model.positions, best]))
        at_start = measured(data, molecule.placed, molecule.atoms)
        there = measured(known.distances, best, molecule.atoms)
        off = outside(at_start, [(one.low, one.high) for one in data])[found.kept]
        missed = np.array([one.off for k, one in found.left_out.items() if k in found.kept])
        nodes, start = best[molecule.atoms], of.start
        return FittedStructure(
            model=molecule.model,
            kept=wholes,
            data=agreement_of(data, at_start, there, found.contradicting, found.left_out),
            density=self._in_map(of, known.only(found.kept), best, fits.frames[0]),
            labels=molecule.sites.labels,
            spread=fits.spread if density is None else density.spread(fits.spread),
            rmsd_from_start=_rms(superpose_onto(nodes[None], slice(None), start)[0] - start),
            outliers_at_start=float(outliers[0]),
            outliers=float(outliers[1]),
            agreeing=len(fits.agreeing),
            fits=len(fits.frames),
            off_at_start=_rms(off[:, None]),
            off_left_out=_rms(missed[:, None]) if len(missed) else None,
        )

    def _rounds(
        self, of: at_nodes.Ensemble, known: at_nodes.Known, keep: int
    ) -> tuple[at_nodes.Known, at_nodes.Consistent, list[Whole]]:
        """Fits. What room dyes have depends on the shape: they are placed in the structure found,
        and all is fitted anew. Returns what is known with dyes in the last one, too."""
        molecule = self.molecule
        rounds = ROUNDS if any(one.kind in DYES for one in known.distances) else 1
        for left in reversed(range(rounds)):
            found = at_nodes.consistent(of, known)
            count = min(1 if left else keep, len(found.fits.frames))
            wholes = [molecule.brought(found.fits, k) for k in range(count)]
            there = in_map.at(molecule.structure, wholes[0].positions)
            dyes = with_dyes_in(known.distances, Labels(there, molecule.atoms))
            known = at_nodes.Known(dyes, known.density)
        return known, found, wholes

    def _in_map(
        self, of: at_nodes.Ensemble, known: at_nodes.Known, found: np.ndarray, frame: int
    ) -> in_map.MapAgreement | None:
        """How a structure found (N, 3), fitted from that frame, agrees with the map, if any."""
        molecule, structure = self.molecule, self.molecule.structure
        if self.density is None:
            return None
        return in_map.agreement_with(
            self.density,
            in_map.at(structure, molecule.placed),
            in_map.at(structure, found),
            molecule.atoms,
            molecule.sites.labels,
            in_map.freedom_of(self.density, of, known, structure, frame),
        )


def _distances(molecule: Molecule, given: Any) -> list[Datum]:
    data = read_distances(given, molecule.sites)
    if in_nanometres(data, np.asarray(molecule.model.positions)[molecule.atoms]):
        warnings.warn("distances look as if they were in nm: Angstrom are asked for", PliantWarning,
                      stacklevel=5)  # fmt: skip
    return data


def _rms(moves: np.ndarray) -> float:
    return float(np.sqrt((moves**2).sum(axis=1).mean())) if len(moves) else 0.0
