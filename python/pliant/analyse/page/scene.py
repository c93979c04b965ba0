# SPDX-License-Identifier: MIT
"""The trajectory as the 3-D view in the page needs it: thinned, superposed, in few bytes."""

from __future__ import annotations

import contextlib
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt
from scipy.spatial import cKDTree

from pliant.analyse.names import chains_of, numbers_of
from pliant.analyse.page.cartoon import secondary_structure
from pliant.analyse.page.view_limits import (
    MAX_ATOMS,
    as_base64,
    drawn_atoms,
    facing_the_reader,
)
from pliant.analyse.study import known
from pliant.analysis.collective import participation
from pliant.analysis.frames import weights_of
from pliant.analysis.residuals import bar_residuals
from pliant.analysis.rotatable import is_hydrogen
from pliant.analysis.superposition import Superposition

if TYPE_CHECKING:
    from MDAnalysis import AtomGroup

    from pliant.analyse.study import Study
    from pliant.analysis.residuals import BarResiduals


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


def thinned(study: Study, max_atoms: int = MAX_ATOMS, max_bytes: int = MAX_BYTES) -> Thinned:
    """Chooses atoms and frames so that the page stays small."""
    atoms, notes = _shown_atoms(study.atoms, max_atoms)
    trace_only = bool(notes) and notes[0].endswith("only")
    per_frame = 6 * len(atoms) + (0 if study.residuals is None else len(study.residuals.bars))
    count = int(np.clip(max_bytes // per_frame, 2, len(study.frames)))
    frames = np.unique(np.linspace(0, len(study.frames) - 1, count).round().astype(int))
    if len(frames) < len(study.frames):
        notes.append(f"{len(frames)} of {len(study.frames)} frames")
    return Thinned(atoms.ix, frames, notes, trace_only)


def _shown_atoms(atoms: AtomGroup, max_atoms: int) -> tuple[AtomGroup, list[str]]:
    def trace() -> np.ndarray:
        with contextlib.suppress(Exception):  # foreign topologies lack names or residues
            found = atoms.select_atoms("(protein and name CA) or (nucleic and name P)")
            return np.flatnonzero(np.isin(atoms.ix, found.ix))
        return np.empty(0, dtype=np.int64)

    heavy = np.flatnonzero(~is_hydrogen(atoms))
    shown, notes = drawn_atoms(len(atoms), heavy, trace, max_atoms)
    return atoms[shown], notes


def scene(study: Study, max_atoms: int = MAX_ATOMS, max_bytes: int = MAX_BYTES) -> dict[str, Any]:
    """The scene as JSON-ready values; arrays of numbers are base64 of little-endian integers."""
    shown = thinned(study, max_atoms, max_bytes)
    atoms = study.universe.atoms[shown.atoms]
    place = np.full(len(study.universe.atoms), -1)
    place[shown.atoms] = np.arange(len(shown.atoms))
    bars, bar_numbers = _pairs_among(study.residuals.bars if study.residuals else (), place)
    positions, codes = _positions_and_codes(study, shown, bar_numbers)
    step = max(float(np.abs(positions).max()) / 32767, 1e-6)
    return {
        "atoms": _atom_columns(atoms, study),
        "units": _unit_columns(study),
        "bonds": _pairs_among(_bonds(study), place)[0].ravel().tolist(),
        "bars": bars.ravel().tolist(),
        "frames": study.frames[shown.frames].tolist(),
        "axis": {"label": study.axis[1], "values": study.axis[0][shown.frames].tolist()},
        "step": step,
        "positions": as_base64(np.round(positions / step).astype("<i2")),
        "residuals": as_base64(codes),
        "residual_codes": {"per_decade": CODES_PER_DECADE, "lowest": LOWEST_DECADE},
        "series": _series(study, shown.frames),
        "notes": shown.notes,
        "trace_only": shown.trace_only,
    }


def _bonds(study: Study) -> npt.ArrayLike:
    if hasattr(study.universe, "bonds") and len(study.universe.bonds):
        return np.asarray(study.universe.bonds.indices)
    return study.residuals.bars if study.residuals else ()


def _pairs_among(pairs: npt.ArrayLike, place: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Pairs (P, 2) of shown atoms, in the numbers that those have, and which pairs they are."""
    pairs = np.asarray(pairs, dtype=np.int64).reshape(-1, 2)
    renamed = place[pairs]
    kept = np.flatnonzero((renamed >= 0).all(axis=1))
    return renamed[kept], kept


def _positions_and_codes(
    study: Study, shown: Thinned, bar_numbers: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Positions (f, n, 3) around the origin, superposed on the first; residual codes (f, b)."""
    positions = np.empty((len(shown.frames), len(shown.atoms), 3))
    codes = np.zeros((len(shown.frames), len(bar_numbers)), dtype=np.uint8)
    superposition = None
    for k, frame in enumerate(shown.frames):
        every = study.positions(frame)
        fitted = every[study.fitted.ix]
        if superposition is None:
            superposition = Superposition(fitted, weights_of(study.fitted, None))
        positions[k] = superposition.apply(every[shown.atoms], fitted)
        if len(bar_numbers):
            codes[k] = _codes(known(study.residuals), every, bar_numbers)
    return facing_the_reader(positions), codes


def _codes(residuals: BarResiduals, positions: np.ndarray, bar_numbers: np.ndarray) -> np.ndarray:
    rest = residuals.rest_lengths[bar_numbers]
    error = np.abs(bar_residuals(positions, residuals.bars[bar_numbers], rest)) * rest
    with np.errstate(divide="ignore"):
        decades = np.log10(error / residuals.accepted[bar_numbers]) - LOWEST_DECADE
    codes: np.ndarray = np.clip(np.nan_to_num(decades * CODES_PER_DECADE, nan=255), 0, 255).astype(
        np.uint8
    )
    return codes


def _atom_columns(atoms: AtomGroup, study: Study) -> dict[str, Any]:
    columns = {
        "names": [str(name) for name in getattr(atoms, "names", [""] * len(atoms))],
        "elements": _elements(atoms),
        "residues": [str(name) for name in getattr(atoms, "resnames", [""] * len(atoms))],
        "numbers": numbers_of(atoms).tolist(),
        "chains": chains_of(atoms).tolist(),
        "cartoon": secondary_structure(atoms),
    }
    return columns | {"unit": units_of_atoms(study, atoms).tolist()}


def units_of_atoms(study: Study, atoms: AtomGroup) -> np.ndarray:
    """(n,) the unit whose colour an atom takes; -1 where it has none.

    That is its residue; in a single residue the atom itself, or the nearest that is a unit.
    """
    units = known(study.units)
    if units.what == "residue":
        owners = atoms.resindices
    else:
        first = known(study.reference).positions
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


def _unit_columns(study: Study) -> dict[str, Any]:
    """One number a unit for each thing that atoms may be coloured by."""
    count = len(known(study.units).labels)
    columns: dict[str, Any] = {}
    if study.flexibility is not None:
        columns["mobility"] = np.round(study.flexibility.rmsf, 4).tolist()
    if study.domains is not None and study.domains.count > 1:
        columns["domain"] = study.unit_domains.tolist()
    moved = study.component_units
    if study.pca is not None and moved is not None:
        found = study.pca.results
        values = np.zeros(count)  # what is not in the PCA counts as still
        values[moved] = np.sqrt(participation(found.components[:1])[0] * found.eigenvalues[0])
        columns["motion"] = np.round(values, 4).tolist()
    return columns


def _elements(atoms: AtomGroup) -> list[str]:
    """Symbols for colours and sizes; "C" where nothing is known."""
    elements = [str(e).capitalize() for e in getattr(atoms, "elements", [""] * len(atoms))]
    hydrogen = is_hydrogen(atoms)
    names = [str(name) for name in getattr(atoms, "names", ["C"] * len(atoms))]
    guessed = [
        "H" if h else name.lstrip("0123456789")[:1] for h, name in zip(hydrogen, names, strict=True)
    ]
    return [
        e or (g if g in "CNOSPFI" and g else "C") for e, g in zip(elements, guessed, strict=True)
    ]


def _series(study: Study, frames: np.ndarray) -> dict[str, Any]:
    """What the timeline can show: name -> label, unit, values, whether logarithmic."""
    series: dict[str, dict[str, Any]] = {}
    columns = {
        "rmsd": ("RMSD", "Å", study.rmsd),
        "radius": ("radius of gyration", "Å", study.radius),
        "sweeps": ("sweeps", "", study.observable("sweeps")),
    }
    for name, (label, unit, values) in columns.items():
        if values is not None:
            series[name] = {"label": label, "unit": unit, "values": _rounded(values[frames])}
    if study.residuals is not None:
        values = np.maximum(study.residuals.results.max_relative[frames], 1e-17)
        limit = study.residuals.tolerance if study.residuals.tolerance_length == 0 else None
        series["residual"] = {
            "label": "largest residual", "unit": "", "log": True, "limit": limit,
            "values": _rounded(values),
            "marked": np.flatnonzero(~study.residuals.results.within[frames]).tolist(),
        }  # fmt: skip
    return series


def _rounded(values: np.ndarray) -> list[float]:
    return [float(f"{value:.4g}") for value in np.asarray(values, dtype=float)]
