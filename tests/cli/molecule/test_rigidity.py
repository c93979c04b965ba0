# SPDX-License-Identifier: MIT
"""pliant rigidity: clusters, degrees of freedom and dilution, as text, tables, JSON and files."""

import csv
import json
import re
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from expected_warnings import read_without_elements

import pliant as pythons_pliant

pytest.importorskip("MDAnalysisTests")
import MDAnalysis
import MDAnalysisTests

OPEN = Path(MDAnalysisTests.__file__).parent / "data" / "adk_open.pdb"


def ring(atoms):
    """Carbons on a circle, 1.5 Angstrom apart."""
    angles = 2 * np.pi * np.arange(atoms) / atoms
    radius = 0.75 / np.sin(np.pi / atoms)
    lines = [f"C {radius * np.cos(t):.4f} {radius * np.sin(t):.4f} 0.0" for t in angles]
    return "\n".join([str(atoms), "ring", *lines]) + "\n"


# Adenylate kinase: LID residues 118-160, NMP 30-67, CORE the rest (Schulz, Mueller, Diederichs, J.
# Mol. Biol. 213 (1990) 627).
def test_the_domains_of_adenylate_kinase_are_clusters(pliant):
    found = json.loads(pliant("rigidity", OPEN, "--json").out)
    of_residue = np.array([residue["cluster"] for residue in found["residues"]])
    core, lid, nmp = of_residue[68:110], of_residue[124:150], of_residue[44:54]
    assert [len(set(part)) for part in (core, lid, nmp)] == [1, 1, 1]
    assert len({core[0], lid[0], nmp[0]}) == 3
    assert found["parts"] == 1


def test_clusters_are_counted_the_same_everywhere(pliant, tmp_path):
    """Of three atoms or more; atoms and bonds alone are small pieces."""
    found = json.loads(pliant("rigidity", OPEN, "--json").out)
    sizes = np.bincount(np.array(found["cluster_of_atom"]) - 1)
    clusters, pieces = int((sizes > 2).sum()), int((sizes < 3).sum())
    assert clusters > found["coloured_clusters"] > 1 and pieces > 0
    assert found["rigid_clusters"] == len(found["clusters"]) == clusters
    assert found["small_pieces"] == pieces
    text = pliant("rigidity", OPEN, "--page", "page.html").out
    assert re.search(rf"^rigid clusters +{clusters}   of 3 atoms or more; ", text, re.M)
    assert re.search(rf"^small pieces +{pieces}   of one or two atoms$", text, re.M)
    page = (tmp_path / "page.html").read_text()
    assert f"<strong>{clusters} rigid clusters; the largest has" in page
    coloured = found["coloured_clusters"]
    assert (
        f'"{clusters} rigid clusters, {coloured} with a colour; grey: smaller, or flexible"' in page
    )
    of_python = pythons_pliant.rigidity(read_without_elements(OPEN))
    assert (of_python.rigid_clusters, of_python.coloured_clusters) == (clusters, coloured)
    assert of_python.small_pieces == pieces
    assert f"{clusters} of 3 atoms or more" in str(of_python)


SIX = (
    "1 ring of six bonds that may turn: counted as rigid. At fixed angles a chair is, but a boat "
    "moves through twist-boats, which a count cannot see"
)


@pytest.mark.parametrize(("atoms", "rings"), [(5, 0), (6, 1), (7, 0)])
def test_a_ring_of_six_is_reported(pliant, tmp_path, atoms, rings):
    path = tmp_path / "ring.xyz"
    path.write_text(ring(atoms))
    ended = pliant("rigidity", path, "--page", "page.html", "--json")
    found = json.loads(ended.out)
    assert found["rings_of_six"] == rings
    assert found["notes"].count(SIX) == rings
    assert ("a boat moves through twist-boats" in (tmp_path / "page.html").read_text()) == (
        rings > 0
    )
    assert pythons_pliant.rigidity(pythons_pliant.read(path)).rings_of_six == rings


def test_files_for_viewers(pliant, tmp_path):
    ended = pliant("rigidity", OPEN, "-o", "found", "--dilution")
    assert ended.code == 0, ended.err
    folder = tmp_path / "found"
    assert {p.name for p in folder.iterdir()} == {
        *("clusters.pdb", "flexibility.pdb", "show.pml", "show.cxc"),
        *("residues.csv", "bonds.csv", "dilution.csv", "dilution.svg"),
    }
    found = json.loads(pliant("rigidity", OPEN, "--json").out)
    clusters = MDAnalysis.Universe(folder / "clusters.pdb").atoms.tempfactors
    listed = np.array(found["cluster_of_atom"])
    listed[listed > len(found["clusters"])] = 0
    assert (clusters == listed).all()
    flexibility = MDAnalysis.Universe(folder / "flexibility.pdb").residues
    expected = [100 * residue["flexibility"] for residue in found["residues"]]
    shown = [residue.atoms.tempfactors[0] for residue in flexibility]
    np.testing.assert_allclose(shown, expected, atol=0.006)
    again = pliant("rigidity", OPEN, "-o", "found")
    assert again.code == 1
    assert "clusters.pdb" in again.err
    assert pliant("rigidity", OPEN, "-o", "found", "--overwrite").code == 0


def test_the_dilution_plot_shows_domains_of_the_kinase(pliant, tmp_path):
    """Core, lid and the domain that binds the nucleotide are rigid apart from each other."""
    pliant("rigidity", OPEN, "-o", "found", "--dilution")
    picture = ElementTree.parse(tmp_path / "found" / "dilution.svg").getroot()
    shapes = {"x": float, "y": float, "width": float, "fill": str}
    bars = [
        {name: kind(bar.get(name)) for name, kind in shapes.items()}
        for bar in picture.iter("{http://www.w3.org/2000/svg}rect")
        if bar.get("x")
    ]
    rows = list(csv.DictReader((tmp_path / "found" / "dilution.csv").open()))
    lines = {bar["y"] for bar in bars}
    assert 30 < len(lines) <= len(rows) + 1
    at_first = [bar for bar in bars if bar["y"] == min(lines)]
    step = at_first[-1]["x"] + at_first[-1]["width"] - at_first[0]["x"]
    colour_of = {}
    for bar in at_first:
        first = round((bar["x"] - at_first[0]["x"]) / step * 214) + 1
        for residue in range(first, first + round(bar["width"] / step * 214)):
            colour_of[residue] = bar["fill"]
    core, lid, binding = colour_of[100], colour_of[130], colour_of[50]
    assert len({core, lid, binding}) == 3
    assert colour_of[200] == colour_of[20] == core


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--csv", "--json"], "--csv, --json: expected one of them"),
        (["--overwrite"], "--overwrite: goes with --output"),
        (["--hbond-bars", "7"], "--hbond-bars: expected"),
    ],
)
def test_bad_options(pliant, arguments, message):
    ended = pliant("rigidity", OPEN, *arguments)
    assert ended.code == 2
    assert message in ended.err


@pytest.mark.long
def test_a_million_atoms(pliant, tmp_path):
    import write_big_pdb

    path = tmp_path / "big.pdb"
    write_big_pdb.write_big_pdb(path)
    found = pliant("rigidity", path, "--keep-waters")
    assert found.code == 0
    assert found.out.splitlines()[1].split()[:2] == ["atoms", "1020200"]
