# SPDX-License-Identifier: MIT
"""Our residue templates against those of OpenMM (residues.xml)."""

import re
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest
import support_program

pytest.importorskip("openmm")
from openmm import app

NO_TEMPLATE = {"UNK": "an unknown residue: distances tell its bonds"}

# {residue: bonds that only one of the two has}
KNOWN_DIFFERENCES = {
    # OpenMM ties the formyl group's names to an amino acid's nitrogen, which it does not have.
    "FOR": ["C - H3: ours only", "H3 - N: theirs only"]
}

# OpenMM applies the names of a chain's ends to caps as well, where they mean other atoms.
CAPS = {"ACE", "FOR", "NH2", "NME"}


def theirs():
    """{residue: {(atom, atom)}} without the links to the residue before."""
    file = Path(app.__file__).parent / "data" / "residues.xml"
    return {
        residue.get("name"): {
            tuple(sorted((bond.get("from"), bond.get("to"))))
            for bond in residue.iter("Bond")
            if not bond.get("from").startswith("-")
        }
        for residue in ElementTree.parse(file).iter("Residue")
    }


def ours(names):
    answers = support_program.ask(["templates"], names)
    return {
        name: None if answer["bonds"] is None else {tuple(sorted(pair)) for pair in answer["bonds"]}
        for name, answer in zip(names, answers, strict=True)
    }


def test_templates_equal_openmms():
    """Of the atoms that OpenMM knows, the same pairs are bonded; ours know more names."""
    expected = theirs()
    found = ours(list(expected))
    assert len(expected) > 30
    assert [name for name, bonds in found.items() if bonds is None] == list(NO_TEMPLATE)
    differences = {}
    for name in expected.keys() - NO_TEMPLATE.keys():
        atoms = {atom for pair in expected[name] for atom in pair}
        shared = {pair for pair in found[name] if set(pair) <= atoms}
        different = [
            f"{' - '.join(pair)}: {'ours' if pair in shared else 'theirs'} only"
            for pair in sorted(shared ^ expected[name])
        ]
        if different:
            differences[name] = different
    assert differences == KNOWN_DIFFERENCES


def test_other_programs_names_are_bonded_to_the_same_atoms():
    """OpenMM lists the names of other programs in pdbNames.xml: atoms of one bond have it alike."""
    root = ElementTree.parse(Path(app.__file__).parent / "data" / "pdbNames.xml").getroot()
    expected = theirs()
    names = [name for name in expected if name not in NO_TEMPLATE and name not in CAPS]
    wrong, known = [], 0
    for name, bonds in ours(names).items():
        aliases = aliases_of(root, name)
        for atom, spellings in aliases.items():
            partners = neighbours(expected[name], atom)
            allowed = partners.union(*(aliases.get(partner, ()) for partner in partners))
            for spelling in spellings if len(partners) == 1 else ():
                found = neighbours(bonds, spelling)
                known += bool(found)
                if not found <= allowed:
                    wrong.append(f"{name}: {spelling} to {sorted(found)}, not {sorted(partners)}")
    assert wrong == []
    assert known > 300


def aliases_of(root, name):
    """{atom: its other spellings} of a residue, with those of its kind."""
    residue = root.find(f"Residue[@name='{name}']")
    kind = root.find(f"Residue[@name='{residue.get('type', 'All')}']")
    return {
        atom.get("name"): {
            re.sub(r"^(\d)(\D.*)$", r"\2\1", text.replace("*", "'"))
            for key, text in atom.items()
            if key.startswith("alt")
        }
        for atom in [*(kind if kind is not None else ()), *residue]
    }


def neighbours(bonds, atom):
    return {b if a == atom else a for a, b in bonds if atom in (a, b)}


@pytest.mark.parametrize("name", ["HID", "CYX", "NALA", "CHIE", "DA5", "WAT", "TIP3", "MSE"])
def test_variants_have_templates(name):
    assert ours([name])[name]
