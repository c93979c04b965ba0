# SPDX-License-Identifier: MIT
"""pliant rigidity: clusters, degrees of freedom and dilution, as text, tables, JSON and files."""

import csv
import io
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


@pytest.mark.parametrize(("atoms", "freedoms", "redundant"), [(5, 0, 1), (6, 0, 0), (7, 1, 0)])
def test_rings(pliant, tmp_path, atoms, freedoms, redundant):
    path = tmp_path / "ring.xyz"
    path.write_text(ring(atoms))
    found = json.loads(pliant("rigidity", path, "--json").out)
    assert found["degrees_of_freedom"] == freedoms
    assert found["redundant"] == redundant
    assert found["bonds_that_may_turn"] == atoms
    assert found["flexible_bonds"] == (atoms if freedoms else 0)
    assert len(set(found["cluster_of_atom"])) == (atoms if freedoms else 1)


def test_ethanol_has_two_torsions(pliant, ethanol):
    found = json.loads(pliant("rigidity", ethanol, "--json").out)
    assert found["degrees_of_freedom"] == 2
    assert [bond["flexibility"] for bond in found["bonds"]] == [1.0, 1.0]


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


def test_a_boat_does_move_at_fixed_angles():
    """Bars along bonds and across angles of six carbons: the chair has full rank, the boat not."""
    assert [freedoms_of_six(shape) for shape in (CHAIR, BOAT)] == [0, 1]


#: heights of the atoms round the ring, Angstrom
CHAIR, BOAT = (1, -1, 1, -1, 1, -1), None


def freedoms_of_six(heights):
    """Lengths and angles of the chair of cyclohexane, and of its boat."""
    angles = np.pi / 3 * np.arange(6)
    if heights is None:
        x = boat()
    else:
        x = np.stack(
            [1.4434 * np.cos(angles), 1.4434 * np.sin(angles), 0.25 * np.array(heights)], 1
        )
    pairs = [(a, (a + step) % 6) for step in (1, 2) for a in range(6)]
    matrix = np.zeros((12, 18))
    for row, (a, b) in zip(matrix, pairs, strict=True):
        row[3 * a : 3 * a + 3] = x[a] - x[b]
        row[3 * b : 3 * b + 3] = x[b] - x[a]
    return 12 - np.linalg.matrix_rank(matrix, tol=1e-6)


def boat():
    """Four carbons at the corners of a rectangle, two above: bonds 1.53, distances across 2.50."""
    bond, across = 1.53, 2.50
    half = bond / 2
    corners = [(x, y * across / 2, 0) for x, y in ((half, 1), (-half, 1), (-half, -1), (half, -1))]
    # Bow: bonded to corners 0 and 3, at `across` from corners 1 and 2.
    out = (across**2 - bond**2) / (4 * half)
    up = np.sqrt(bond**2 - (across / 2) ** 2 - (out - half) ** 2)
    return np.array([(out, 0, up), corners[0], corners[1], (-out, 0, up), corners[2], corners[3]])


def test_free_angles_make_ball_joints(pliant, tmp_path):
    """Si-O-Si of H3Si-O-SiH3: two turns more than its two torsions."""
    lines = ["Si -1.6 0 0", "O 0 0.4 0", "Si 1.6 0 0"]
    for side in (-1, 1):
        around = [(1.39 * np.cos(t), 1.39 * np.sin(t)) for t in (0.1, 2.2, 4.3)]
        lines += [f"H {side * 2.1} {y:.3f} {z:.3f}" for y, z in around]
    path = tmp_path / "disiloxane.xyz"
    path.write_text(f"{len(lines)}\n\n" + "\n".join(lines) + "\n")
    assert json.loads(pliant("rigidity", path, "--json").out)["degrees_of_freedom"] == 2
    free = json.loads(pliant("rigidity", path, "--free-angles", "element O", "--json").out)
    assert free["degrees_of_freedom"] == 3
    ended = pliant("rigidity", path, "--free-angles", "element Au")
    assert ended.code == 2
    assert 'pliant: error: free angles: selection "element Au" names no atom\n' in ended.err


def test_json_adds_up(pliant):
    found = json.loads(pliant("rigidity", OPEN, "--json").out)
    bars = found["bars"] - found["redundant"]
    assert found["degrees_of_freedom"] == 6 * found["atoms"] - bars - 6 * found["parts"]
    assert sum(bond["redundant"] for bond in found["bonds"]) == found["redundant"]
    turning = [b for b in found["bonds"] if b["kind"] == "bond" and b["bars"] == 5]
    assert len(turning) == found["bonds_that_may_turn"]
    assert sum(b["flexible"] for b in turning) == found["flexible_bonds"]
    assert any("hydrogens of the file kept" in note for note in found["notes"])


def test_dilution_frees_and_never_locks(pliant):
    ended = pliant("rigidity", OPEN, "--dilution", "--csv", "--hbond-cutoff", "0")
    rows = list(csv.DictReader(io.StringIO(ended.out)))
    bonds = pliant("contacts", OPEN, "--csv", "--hbond-cutoff", "0").out.splitlines()
    assert len(rows) == sum("hydrogen_bond," in b or "salt_bridge," in b for b in bonds[1:]) + 1
    freedoms, redundant = (
        np.array([int(row[name]) for row in rows]) for name in ("degrees_of_freedom", "redundant")
    )
    assert (np.diff(freedoms) >= 0).all()
    assert (np.diff(redundant) <= 0).all()
    cutoffs = [float(row["cutoff"]) for row in rows[:-1]]
    assert cutoffs == sorted(cutoffs, reverse=True)
    assert rows[-1]["cutoff"] == "" and rows[0]["a"] == ""


def test_dilution_goes_through_the_counts_of_other_cutoffs(pliant):
    rows = json.loads(pliant("rigidity", OPEN, "--dilution", "--json").out)["dilution"]
    for cutoff in ("-2", "-4"):
        found = json.loads(pliant("rigidity", OPEN, "--hbond-cutoff", cutoff, "--json").out)
        row = next(r for r in rows if r["cutoff"] < float(cutoff))
        assert row["degrees_of_freedom"] == found["degrees_of_freedom"]
        assert row["redundant"] == found["redundant"]
        assert row["largest"][0] == found["clusters"][0]["atoms"]


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
