# SPDX-License-Identifier: MIT
"""The selection language against MDAnalysis' select_atoms."""

import random
import re
from pathlib import Path

import numpy as np
import pytest
import support_program

import pliant

pytest.importorskip("MDAnalysisTests")
import MDAnalysis
import MDAnalysisTests

# MDAnalysis warns of what PDB files leave out.
pytestmark = [
    pytest.mark.filterwarnings("ignore"),
    pytest.mark.skipif(
        not hasattr(MDAnalysis.core.selection, "WaterSelection"),
        reason="this MDAnalysis selects no water",
    ),
]

MDA = Path(MDAnalysisTests.__file__).parent / "data"

# Complexes with water and ligands, simulations with hydrogens, a peptide with insertion codes.
FILES = ["1a28.pdb.gz", "1hvr.pdb", "adk_closed.pdb", "cobrotoxin.pdb", "unordered_res.pdb"]

TERMS = [
    "all",
    "protein",
    "backbone",
    "water",
    "name CA",
    "name C* N?",
    "name *1",
    "name H* *G*",
    "element C N",
    "element S",
    "resname ALA LYS HOH",
    "resname ?L*",
    "resid 5",
    "resid 2-17 30:41 57",
    "resid 60A",
    "resid 60-60C",
    "resid 59-60A",
    "index 0-100 333",
    "index 7:7",
    "bynum 1:12",
    "chainID A",
    "chainID B X F",
]


def expression(source, terms, depth):
    """A random expression over the terms."""
    choice = source.random()
    if depth == 0 or choice < 0.2:
        return source.choice(terms)
    if choice < 0.4:
        return f"not {expression(source, terms, 0)}"
    inner = expression(source, terms, depth - 1)
    if choice < 0.6:
        return f"({inner})"
    return f"{inner} {source.choice(['and', 'or'])} {expression(source, terms, depth - 1)}"


def terms_for(atoms):
    """Those for which the file has the columns: MDAnalysis refuses the others."""
    columns = {"element": "elements", "60": "icodes"}
    missing = [text for text, column in columns.items() if not hasattr(atoms, column)]
    return [term for term in TERMS if not any(text in term for text in missing)]


@pytest.mark.parametrize("name", FILES)
def test_selections_equal_mdanalysis(name):
    source = random.Random(name)
    universe = MDAnalysis.Universe(MDA / name)
    terms = terms_for(universe.atoms)
    order = pliant.read(MDA / name, perceive_bonds=False).source_order
    if (np.diff(order) < 0).any():  # an index is ours, not the file's
        terms = [term for term in terms if not re.search("index|bynum", term)]
    selections = terms + [expression(source, terms, 3) for _ in range(100)]
    answers = support_program.ask(["select", MDA / name], selections)
    wrong, found = [], 0
    for selection, answer in zip(selections, answers, strict=True):
        chosen = universe.select_atoms(selection).indices
        expected = np.flatnonzero(np.isin(order, chosen)).tolist()
        found += bool(expected)
        if answer.get("atoms") != expected:
            wrong.append((selection, answer.get("error") or len(answer["atoms"]), len(expected)))
    assert wrong == []
    assert found > 60


@pytest.mark.parametrize("selection", ["", "nam CA", "name", "resid x", "(water", "water)", "not"])
def test_what_mdanalysis_refuses_is_refused(selection):
    file = MDA / "adk_open_10res.pdb"
    with pytest.raises(MDAnalysis.SelectionError):
        MDAnalysis.Universe(file).select_atoms(selection or " ")
    assert support_program.ask(["select", file], [selection])[0].keys() == {"error"}
