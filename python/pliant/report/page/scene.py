# SPDX-License-Identifier: MIT
"""The trajectory as the 3-D view in the page needs it: thinned, superposed, in few bytes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.spatial import cKDTree

from pliant._core import Structure
from pliant.measure.collective import participation
from pliant.measure.frames import weights_of
from pliant.measure.residuals import bar_residuals
from pliant.measure.rotatable import is_hydrogen
from pliant.measure.stages.names import chains_of, numbers_of
from pliant.measure.stages.parts import ReferenceStructure, Units
from pliant.measure.stages.units import trace_atoms
from pliant.report.page.drawn import (
    MAX_ATOMS,
    DrawnAtoms,
    as_base64,
    drawn_atoms,
    drawn_molecule,
    drawn_positions,
)
from pliant.report.page.overlay import Overlay
from pliant.report.sections.bars import Residuals
from pliant.report.sections.domains import RigidDomains
from pliant.report.sections.flexible import UnitFlexibility
from pliant.report.sections.motions import Components
from pliant.report.sections.series import Gyration, Rmsd
from pliant.report.sections.sweeps import Sweeps
from pliant.trajectory.chosen_frames import choose_frames
from pliant.trajectory.superposition import Superposition

if TYPE_CHECKING:
    from MDAnalysis import AtomGroup

    from pliant.measure.residuals import BarResiduals
    from pliant.measure.stages.analysis import Analysis


#: of frames in the page, before they are written as text
MAX_BYTES = 1_000_000

#: codes of residuals: 0 to 255 for |residual| / tolerance from 1e-4 to 1e4, logarithmic
CODES_PER_DECADE = 32
LOWEST_DECADE = -4

#: atoms whose nearest ones are looked for at once
AT_ONCE = 1 << 12


@dataclass
class Thinned:
    """What of a trajectory is shown."""

    atoms: np.ndarray  #: (n,) indices in the universe
    frames: np.ndarray  #: (f,) places among the frames analysed
    notes: list[str]  #: says what is left out
    trace_only: bool  #: the atoms shown are not bonded to each other


def thinned(analysis: Analysis, max_atoms: int = MAX_ATOMS, max_bytes: int = MAX_BYTES) -> Thinned:
    """Chooses atoms and frames so that the page stays small."""
    drawn = _drawn_atoms(analysis.atoms, max_atoms)
    atoms, notes = analysis.atoms[drawn.chosen], [*drawn.notes]
    per_frame = 6 * len(atoms) + len(_bars(analysis))
    count = int(np.clip(max_bytes // per_frame, 2, len(analysis.frames)))
    frames = choose_frames(len(analysis.frames), count)
    if len(frames) < len(analysis.frames):
        notes.insert(0, f"{len(frames)} of the {len(analysis.frames)} frames")
    return Thinned(atoms.ix, frames, notes, drawn.trace_only)


def _drawn_atoms(atoms: AtomGroup, max_atoms: int) -> DrawnAtoms:
    def trace() -> np.ndarray:
        return np.flatnonzero(np.isin(atoms.ix, trace_atoms(atoms).ix))

    heavy = np.flatnonzero(~is_hydrogen(atoms))
    return drawn_atoms(len(atoms), heavy, trace, max_atoms)


def scene(
    analysis: Analysis,
    max_atoms: int = MAX_ATOMS,
    max_bytes: int = MAX_BYTES,
    overlay: Overlay | None = None,
) -> dict[str, Any]:
    """The scene as JSON-ready values; arrays of numbers are base64 of little-endian integers."""
    shown = thinned(analysis, max_atoms, max_bytes)
    atoms = analysis.universe.atoms[shown.atoms]
    place = np.full(len(analysis.universe.atoms), -1)
    place[shown.atoms] = np.arange(len(shown.atoms))
    bars, bar_numbers = _pairs_among(_bars(analysis), place)
    positions, codes = _positions_and_codes(analysis, shown, bar_numbers)
    molecule = drawn_molecule(_structure(analysis, int(shown.frames[0])), shown.atoms)
    molecule["atoms"]["unit"] = units_of_atoms(analysis, atoms).tolist()
    return {
        **molecule,
        **drawn_positions(positions),
        "units": _unit_columns(analysis),
        "bonds": _pairs_among(_bonds(analysis), place)[0].ravel().tolist(),
        "bars": bars.ravel().tolist(),
        "frames": analysis.frames[shown.frames].tolist(),
        "axis": {"label": analysis.axis[1], "values": analysis.axis[0][shown.frames].tolist()},
        "residuals": as_base64(codes),
        "residual_codes": {"per_decade": CODES_PER_DECADE, "lowest": LOWEST_DECADE},
        "series": _series(analysis, shown.frames),
        "notes": shown.notes,
        "trace_only": shown.trace_only,
        **({} if overlay is None else {"overlay": overlay.drawn(shown.atoms)}),
    }


def _bonds(analysis: Analysis) -> np.ndarray:
    if hasattr(analysis.universe, "bonds") and len(analysis.universe.bonds):
        return np.asarray(analysis.universe.bonds.indices)
    return _bars(analysis)


def _bars(analysis: Analysis) -> np.ndarray:
    """(B, 2) joints of the bars that were measured."""
    residuals = analysis.get(Residuals)
    return residuals.measured.bars if residuals else np.zeros((0, 2), dtype=np.int64)


def _pairs_among(pairs: np.ndarray, place: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Pairs (P, 2) of shown atoms, in the numbers that those have, and which pairs they are."""
    renamed = place[pairs]
    kept = np.flatnonzero((renamed >= 0).all(axis=1))
    return renamed[kept], kept


def _positions_and_codes(
    analysis: Analysis, shown: Thinned, bar_numbers: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Positions (f, n, 3), superposed on the first; residual codes (f, b)."""
    positions = np.empty((len(shown.frames), len(shown.atoms), 3))
    codes = np.zeros((len(shown.frames), len(bar_numbers)), dtype=np.uint8)
    superposition = None
    for k, frame in enumerate(shown.frames):
        every = analysis.positions(frame)
        fitted = every[analysis.fitted.ix]
        if superposition is None:
            superposition = Superposition(fitted, weights_of(analysis.fitted, None))
        positions[k] = superposition.apply(every[shown.atoms], fitted)
        if len(bar_numbers):
            codes[k] = _codes(analysis[Residuals].measured, every, bar_numbers)
    return positions, codes


def _codes(residuals: BarResiduals, positions: np.ndarray, bar_numbers: np.ndarray) -> np.ndarray:
    rest = residuals.rest_lengths[bar_numbers]
    error = np.abs(bar_residuals(positions, residuals.bars[bar_numbers], rest)) * rest
    with np.errstate(divide="ignore"):
        decades = np.log10(error / residuals.accepted[bar_numbers]) - LOWEST_DECADE
    codes: np.ndarray = np.clip(np.nan_to_num(decades * CODES_PER_DECADE, nan=255), 0, 255).astype(
        np.uint8
    )
    return codes


def _structure(analysis: Analysis, frame: int) -> Structure:
    """All atoms as they are in a frame."""
    atoms = analysis.universe.atoms

    def texts(name: str) -> list[str] | None:
        return [str(text) for text in getattr(atoms, name)] if hasattr(atoms, name) else None

    return Structure(
        analysis.positions(frame),
        elements=_elements(atoms),
        names=texts("names"),
        residue_names=texts("resnames"),
        residue_ids=numbers_of(atoms),
        insertion_codes=texts("icodes"),
        chains=chains_of(atoms).tolist(),
    )


def units_of_atoms(analysis: Analysis, atoms: AtomGroup) -> np.ndarray:
    """(n,) the unit whose colour an atom takes; -1 where it has none.

    That is its residue; in a single residue the atom itself, or the nearest that is a unit.
    """
    units = analysis[Units]
    if units.what == "residue":
        owners = atoms.resindices
    else:
        first = analysis[ReferenceStructure].positions
        owners = units.owners[_nearest(first[atoms.ix], first[units.owners])]
    place = np.searchsorted(units.owners, owners)
    place = np.minimum(place, len(units.owners) - 1)
    return np.where(units.owners[place] == owners, place, -1)


def _nearest(points: np.ndarray, others: np.ndarray) -> np.ndarray:
    """(n,) the first of `others` (m, 3) that is nearest to each of `points` (n, 3)."""
    tree = cKDTree(others)
    found = np.empty(len(points), dtype=np.int64)
    for begin in range(0, len(points), AT_ONCE):
        some = points[begin : begin + AT_ONCE]
        distances, found[begin : begin + AT_ONCE] = tree.query(some)
        # Of several that are as near, to the last digits, the tree gives any.
        near = tree.query_ball_point(some, distances * (1 + 1e-9), return_sorted=True)
        for k, several in enumerate(near):
            if len(several) > 1:
                squares = np.sum((some[k] - others[several]) ** 2, axis=1)
                found[begin + k] = several[int(np.argmin(squares))]
    return found


def _unit_columns(analysis: Analysis) -> dict[str, Any]:
    """One number a unit for each thing that atoms may be coloured by."""
    columns: dict[str, Any] = {}
    if UnitFlexibility in analysis:
        columns["mobility"] = np.round(analysis[UnitFlexibility].found.rmsf, 4).tolist()
    domains = analysis.get(RigidDomains)
    if domains and domains.found.count > 1:
        columns["domain"] = domains.of_unit.tolist()
    moving = analysis.get(Components)
    if moving and moving.units is not None:
        share = participation(moving.found.components[:1])[0]
        values = np.zeros(len(analysis[Units].labels))  # what is not in the PCA counts as still
        values[moving.units] = np.sqrt(share * moving.found.eigenvalues[0])
        columns["motion"] = np.round(values, 4).tolist()
    return columns


def _elements(atoms: AtomGroup) -> list[str]:
    """Symbols for colours and sizes; "" where nothing is known."""
    elements = [str(e).capitalize() for e in getattr(atoms, "elements", [""] * len(atoms))]
    names = [str(name) for name in getattr(atoms, "names", [""] * len(atoms))]
    known = {*Structure(np.zeros((118, 3)), elements=np.arange(1, 119)).symbols.tolist()}
    guessed = [
        "H" if hydrogen else name.lstrip("0123456789")[:1]
        for hydrogen, name in zip(is_hydrogen(atoms), names, strict=True)
    ]
    return [
        element if element in known else guess if guess in set("HCNOSPFI") else ""
        for element, guess in zip(elements, guessed, strict=True)
    ]


def _series(analysis: Analysis, frames: np.ndarray) -> dict[str, Any]:
    """What the timeline can show: name -> label, unit, values, whether logarithmic."""
    series: dict[str, dict[str, Any]] = {}

    def add(name: str, label: str, unit: str, values: np.ndarray) -> None:
        series[name] = {"label": label, "unit": unit, "values": _rounded(values[frames])}

    if Rmsd in analysis:
        add("rmsd", "RMSD", "Å", analysis[Rmsd].fitted)
    if Gyration in analysis:
        add("radius", "radius of gyration", "Å", analysis[Gyration].radius)
    if Sweeps in analysis:
        add("sweeps", "sweeps", "", analysis[Sweeps].counts)
    if residuals := analysis.get(Residuals):
        measured, found = residuals.measured, residuals.found
        limit = measured.tolerance if measured.tolerance_length == 0 else None
        series["residual"] = {
            "label": "largest residual",
            "unit": "",
            "log": True,
            "limit": limit,
            "values": _rounded(np.maximum(found.max_relative[frames], 1e-17)),
            "marked": np.flatnonzero(~found.within[frames]).tolist(),
        }
    return series


def _rounded(values: np.ndarray) -> list[float]:
    return [float(f"{value:.4g}") for value in np.asarray(values, dtype=float)]
