# SPDX-License-Identifier: MIT
"""Our residue templates against those of OpenMM (residues.xml)."""

import re
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import bond_tool
import pytest

pytest.importorskip("openmm")
import openmm.app as app

# Bonds of residues.xml that no template of ours has, and why.
NOT_OURS = {"UNK": "an unknown residue has no template: distances tell its bonds"}


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
    answers = bond_tool.ask(["templates"], names)
    return {
        name: None if answer["bonds"] is None else {tuple(sorted(pair)) for pair in answer["bonds"]}
        for name, answer in zip(names, answers, strict=True)
    }


def test_every_bond_of_openmms_templates_is_in_ours():
    expected = theirs()
    found = ours(list(expected))
    assert len(expected) > 30
    assert [name for name, bonds in found.items() if bonds is None] == list(NOT_OURS)
    missing = {
        name: sorted(expected[name] - bonds)
        for name, bonds in found.items()
        if bonds is not None and expected[name] - bonds
    }
    assert missing == {}


def test_ours_say_nothing_else_of_openmms_atoms():
    """Of the atoms that both know, no two are bonded by us alone."""
    expected = theirs()
    surplus = {}
    for name, bonds in ours(list(expected)).items():
        atoms = {atom for pair in expected[name] for atom in pair}
        extra = {pair for pair in bonds or () if set(pair) <= atoms} - expected[name]
        if extra:
            surplus[name] = sorted(extra)
    assert surplus == {}


def test_other_programs_names_are_bonded_to_the_same_atoms():
    """OpenMM lists the names of other programs in pdbNames.xml: they are bonded alike."""
    file = Path(app.__file__).parent / "data" / "pdbNames.xml"
    templates = theirs()
    root = ElementTree.parse(file).getroot()
    shared = {
        name: list(root.find(f"Residue[@name='{name}']")) for name in ("Protein", "Nucleic", "All")
    }
    wrong = []
    for residue in root.iter("Residue"):
        name = residue.get("name")
        if name not in templates or name in NOT_OURS:
            continue
        kind = {"Protein": "Protein", "Nucleic": "Nucleic"}.get(residue.get("type"), "All")
        bonds = ours([name])[name]
        for atom in [*residue.iter("Atom"), *shared[kind]]:
            wrong += [f"{name}: {text}" for text in wrong_aliases(atom, templates[name], bonds)]
    assert wrong == []


def wrong_aliases(atom, template, bonds):
    """Aliases of a hydrogen that we bond to another atom than OpenMM does."""
    partners = {
        b if a == atom.get("name") else a for a, b in template if atom.get("name") in (a, b)
    }
    aliases = [value for key, value in atom.items() if re.fullmatch(r"alt\d+", key)]
    for alias in aliases if len(partners) == 1 else ():
        spelling = re.sub(r"^(\d)(\D.*)$", r"\2\1", alias.replace("*", "'"))
        known = {b if a == spelling else a for a, b in bonds if spelling in (a, b)}
        if known and known.isdisjoint(partners):
            yield f"{alias} is bonded to {sorted(known)}, not {sorted(partners)}"


@pytest.mark.parametrize("name", ["HID", "CYX", "NALA", "CHIE", "DA5", "WAT", "TIP3", "MSE"])
def test_variants_have_templates(name):
    assert ours([name])[name]
