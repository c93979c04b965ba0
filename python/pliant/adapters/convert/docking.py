# SPDX-License-Identifier: MIT
"""Frames as rigid receptors that AutoDock Vina docks into: PDBQT by Meeko; the box of a site."""

from __future__ import annotations

import contextlib
import io
import logging
import os
import tempfile
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt

from pliant._core import InputError, OptionError, PdbRecorder, Structure, select_atoms
from pliant.base.console import listed
from pliant.base.extras import late, need
from pliant.base.new_file import check_folder, expect_none, write_text
from pliant.base.progress import progress
from pliant.trajectory.superposition import Superposition

meeko = late("meeko")

NEAR = 6.0  #: Angstrom, of a residue of the site from a ligand: as --around of pliant sample
#: names that CHARMM gives to histidine's forms, which Meeko tells by their hydrogens
CALLED = {"HSD": "HIS", "HSE": "HIS", "HSP": "HIS"}
NAME = slice(17, 20)  #: of a residue in a row of a PDB file


@dataclass(frozen=True)
class Receptors:
    """What was written."""

    files: list[str]
    atoms: int  #: of the structure that are in each receptor
    notes: list[str]  #: what was left out


def site_of(structure: Structure, words: str) -> npt.NDArray[np.int64]:
    """The atoms but hydrogens of the residues of a site, ascending.

    It is the residues of proteins in the selection `words`, or, if none is in it (a ligand), those
    within 6 Angstrom of it. Raises OptionError where there is none.
    """
    chosen = np.asarray(select_atoms(structure, words), dtype=np.int64)
    heavy = np.asarray(select_atoms(structure, "protein and not element H"), dtype=np.int64)
    owners = structure.residue_of
    near = heavy[np.isin(heavy, chosen)]
    if len(near) == 0 and len(chosen):
        places = structure.positions
        apart = [np.linalg.norm(places[chosen] - one, axis=1).min() for one in places[heavy]]
        near = heavy[np.array(apart) < NEAR]
    if len(near) == 0:
        raise OptionError(
            f'--site "{words}": no residue of a protein is in it or within {NEAR:g} Angstrom'
        )
    site: npt.NDArray[np.int64] = heavy[np.isin(owners[heavy], owners[near])]
    return site


def write_receptors(
    structure: Structure,
    frames: Iterable[npt.NDArray[np.float64]],
    numbers: Sequence[int],
    folder: str | os.PathLike[str],
    words: str,
    *,
    overwrite: bool = False,
) -> Receptors:
    """Writes F frames (N, 3), Angstrom, as frame-0007.pdbqt; `numbers` name them.

    All are superposed by the site, `words` of `site_of`, on the structure, so that box.txt, a file
    for Vina's --config, holds for each. Raises InputError where Meeko has no template
    for a residue of the site, or an atom of it is missing. What else it has none for is left out,
    and noted. Raises FileError where one of the files is there, and none is then written.
    """
    need("--to vina", "meeko")
    check_folder(Path(folder))
    paths = [Path(folder) / f"frame-{number:04d}.pdbqt" for number in numbers]
    paths.append(Path(folder) / "box.txt")
    expect_none(paths, overwrite)
    site = site_of(structure, words)
    fit = Superposition(structure.positions[site], np.ones(len(site)))
    labels, templates = _labels(structure), meeko.ResidueChemTemplates.create_from_defaults()
    texts, lost = [], np.zeros(len(structure), dtype=bool)
    with tempfile.TemporaryDirectory(prefix="pliant-vina-") as made, progress("receptors") as shown:
        for k, frame in enumerate(frames):
            shown(k, len(numbers))
            rows = _rows(structure, fit.apply(frame, frame[site]), Path(made) / "frame.pdb")
            text, unknown = _receptor(rows, labels, templates)
            texts.append(text)
            lost |= unknown
            _expect_all_of(structure, site[lost[site]])
    Path(folder).mkdir(parents=True, exist_ok=True)
    for path, text in zip(paths, [*texts, _box(structure.positions[site])], strict=True):
        write_text(path, text, overwrite=overwrite)
    notes = [f"left out: {_named(structure, np.flatnonzero(lost))}"] if lost.any() else []
    return Receptors([*map(os.fspath, paths)], int(np.count_nonzero(~lost)), notes)


def _expect_all_of(structure: Structure, lost: npt.NDArray[np.int64]) -> None:
    """Raises InputError where atoms of the site are lost."""
    if len(lost):
        raise InputError(
            f"{_source(structure)}: Meeko has no template for {_named(structure, lost)}, or atoms "
            "are missing there, which --fill-side-chains of pliant sample adds"
        )


def _source(structure: Structure) -> str:
    return structure.source or "the molecule"


def _labels(structure: Structure) -> list[str]:
    """(N,) Meeko's names of residues, "A:73A", by atom. Raises InputError where two are alike."""
    columns = (structure.chains, structure.residue_ids, structure.insertion_codes)
    labels = [
        f"{chain.strip()[:1]}:{number}{code.strip()}"
        for chain, number, code in zip(*(one.tolist() for one in columns), strict=True)
    ]
    firsts = np.unique(structure.residue_of, return_index=True)[1]
    (label, times), *_ = Counter(labels[k] for k in firsts).most_common(1)
    if times > 1:
        raise InputError(f"{_source(structure)}: residue {label} is there twice: name the chains")
    return labels


def _named(structure: Structure, atoms: npt.NDArray[np.int64]) -> str:
    """Their residues, the first six."""
    labels, names = _labels(structure), structure.residue_names.tolist()
    return listed([*dict.fromkeys(f"{names[k]} {labels[k]}" for k in atoms)], 6)


def _rows(structure: Structure, positions: npt.NDArray[np.float64], path: Path) -> list[str]:
    """(N,) of a PDB file."""
    with PdbRecorder(str(path), structure, overwrite=True) as recorder:
        recorder.record(positions)
    lines = path.read_text().splitlines()
    rows = [line for line in lines if line.startswith(("ATOM", "HETATM"))]
    return [row[:17] + CALLED.get(row[NAME], row[NAME]) + row[20:] for row in rows]


def _receptor(
    rows: list[str], labels: list[str], templates: object
) -> tuple[str, npt.NDArray[np.bool_]]:
    """PDBQT, and which atoms (N,) are not in it, for their residue has no template that fits.

    Residues that it has never heard of are taken out, for it would look for them in the web.
    """
    known = {*templates.ambiguous, *templates.residue_templates}  # type: ignore[attr-defined]
    is_known = np.array([row[NAME].strip() in known for row in rows])
    text = "\n".join(row for row, one in zip(rows, is_known, strict=True) if one)
    with _silent():
        polymer = meeko.Polymer.from_pdb_string(
            text, templates, meeko.MoleculePreparation(), allow_bad_res=True
        )
        rigid, _flexible = meeko.PDBQTWriterLegacy.write_string_from_polymer(polymer)
    kept = polymer.get_valid_monomers()
    return rigid, ~(is_known & np.array([label in kept for label in labels]))


@contextlib.contextmanager
def _silent() -> Iterator[None]:
    """Without what Meeko prints and logs of each residue that it takes out."""
    before = logging.root.manager.disable
    logging.disable(logging.CRITICAL)
    try:
        with contextlib.redirect_stdout(io.StringIO()):
            yield
    finally:
        logging.disable(before)


def _box(places: npt.NDArray[np.float64]) -> str:
    """Of the atoms of a site, (n, 3) Angstrom, and what Vina's --config takes."""
    low, high = places.min(axis=0), places.max(axis=0)
    rows = [
        f"{what}_{axis} = {number:.3f}"
        for what, numbers in (("center", (low + high) / 2), ("size", high - low))
        for axis, number in zip("xyz", numbers, strict=True)
    ]
    return "\n".join(rows) + "\n"
