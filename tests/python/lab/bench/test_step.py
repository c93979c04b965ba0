# SPDX-License-Identifier: MIT
"""Steps after a push of one joint: what is pushed is what it is called, what is wrong is said."""

import csv
import json
from itertools import combinations

import networkx
import numpy as np
import pytest
from pliant.lab.bench import step as stepping
from pliant.lab.bench import step_memory
from pliant.lab.bench.command import main
from pliant.lab.bench.large_frameworks import protein, snake, zigzag
from pliant.lab.bench.large_molecules import PATTERN, copies, peptide
from pliant.lab.bench.step_scenes import make_scene, with_angles

import pliant


def dihedral(a, b, c, d):
    """Degrees (IUPAC)."""
    first, second = np.cross(b - a, c - b), np.cross(c - b, d - c)
    along = (c - b) / np.linalg.norm(c - b)
    return np.degrees(np.arctan2(np.cross(first, second) @ along, first @ second))


def atoms_of(molecule, name):
    return molecule.positions[np.flatnonzero(np.array(molecule.names) == name)]


def test_the_peptide_has_the_torsions_and_the_handedness_of_a_protein():
    chain = peptide(320)
    n, ca, c, cb = (atoms_of(chain, name) for name in ("N", "CA", "C", "CB"))
    for k in range(1, 31):
        phi, psi = dihedral(c[k - 1], n[k], ca[k], c[k]), dihedral(n[k], ca[k], c[k], n[k + 1])
        assert (phi, psi) == pytest.approx(PATTERN[k % 16], abs=1e-6)
        assert abs(dihedral(ca[k - 1], c[k - 1], n[k], ca[k])) == pytest.approx(180.0, abs=1e-6)
    ha = atoms_of(chain, "HA")
    assert all(handedness(n, ca, c, cb) > 0) and all(handedness(n, ca, c, ha) < 0)
    assert all(l_amino_acids() > 0)


def handedness(n, ca, c, other):
    return np.einsum("ki,ki->k", np.cross(n - ca, c - ca), other - ca)


def l_amino_acids():
    """Of those of a file."""
    known = pliant.read("data/molecules/peptide_20.pdb")
    first = 19  # the last residue is a glycine
    return handedness(*(atoms_of(known, name)[:first] for name in ("N", "CA", "C", "CB")))


def test_the_peptide_is_a_protein_to_the_model():
    model = pliant.build_model(peptide(1600), "protein")
    assert len(model.positions) == 1600 and model.missing == []
    # From O of k to NH of k + 4, where the three residues between are among a helix' twelve.
    assert len(model.contacts) == pytest.approx(10 * 10, abs=2)
    assert pliant.measure_bars(model.framework, model.positions).within


def test_copies_are_apart_and_each_a_molecule():
    one = pliant.read("data/molecules/alanine_dipeptide.pdb")
    many = copies(one, 5 * len(one))
    graph = networkx.Graph(many.bonds.tolist())
    assert sorted(map(len, networkx.connected_components(graph))) == [len(one)] * 5
    parts = many.positions.reshape(5, -1, 3)
    for a, b in combinations(parts, 2):
        assert np.linalg.norm(a[:, None] - b[None], axis=-1).min() > 9.0
    assert many.framework("angles").bar_count == 5 * one.framework("angles").bar_count


def test_a_snake_goes_by_unit_steps_and_never_crosses_itself():
    for count in (1, 2, 27, 28, 1000):
        places = snake(count)
        assert np.all(np.linalg.norm(np.diff(places, axis=0), axis=1) == 1)
        assert len(np.unique(places, axis=0)) == count


@pytest.mark.parametrize("joints", [300, 3000])
def test_the_large_framework_is_built_as_a_protein(joints):
    large = protein(joints)
    facts = pliant.Framework(large.bars, positions=large.positions).graph_facts()
    assert facts.components == 1
    assert facts.joints == pytest.approx(joints, rel=0.1)
    assert np.abs(large.positions).max() < 8.0 * joints ** (1 / 3) + 20
    assert facts.blocks == facts.cycles == facts.joints // 60  # a ring of six in each 60 joints
    assert facts.largest_block == 6


@pytest.mark.parametrize("make", [protein, zigzag])
def test_angles_are_the_pairs_two_bars_apart(make):
    large = make(200)
    graph = networkx.Graph(large.bars.tolist())
    expected = {
        tuple(sorted(pair))
        for joint in graph
        for pair in [*combinations(graph[joint], 2), *((joint, near) for near in graph[joint])]
    }
    bars = with_angles(large.bars, len(large.positions)).tolist()
    assert len(bars) == len(expected)
    assert {tuple(sorted(bar)) for bar in bars} == expected


def test_a_zigzag_is_planar_with_bonds_of_one_length():
    large = zigzag(50)
    assert np.ptp(large.positions[:, 2]) == 0.0
    steps = np.diff(large.positions, axis=0)
    assert np.linalg.norm(steps, axis=1) == pytest.approx(1.53)
    assert np.linalg.norm(steps[1:] + steps[:-1], axis=1) == pytest.approx(
        2 * 1.53 * np.sin(np.radians(56.0))
    )


@pytest.mark.parametrize(
    ("source", "model"), [("zigzag", "angles"), ("copies", "angles"), ("peptide", "protein")]
)
def test_steps_of_molecules_end_whole(source, model):
    found = stepping.steps_of_pushes(
        (200, 400), kinds=(source,), model=model, techniques=("auto",), steps=20, rounds=1
    )
    assert found.faults == []
    assert [row.joints for row in found.rows] == [200, 400]
    for row in found.rows:
        assert 0 <= row.max_residual <= 1e-6 and row.projections > 0
        assert row.max_limit <= 0.01 and row.max_overlap <= 0.1


def test_limits_and_overlaps_that_are_broken_in_the_end_are_named(monkeypatch):
    def steps():
        return stepping.steps_of_pushes(
            (300,), kinds=("peptide",), model="protein", techniques=("auto",), steps=2, rounds=1
        )

    monkeypatch.setattr(stepping, "OVERLAP_TOLERANCE", -1.0)
    (fault,) = steps().faults
    assert fault.startswith("peptide of 300, auto: two joints overlap by ")
    monkeypatch.setattr(stepping, "worst_limit", lambda *_: 0.5)
    assert steps().faults == ["peptide of 300, auto: a limit is off by 5.0e-01 Angstrom in the end"]


def test_limits_are_measured_anew():
    scene = make_scene("peptide", 300, "protein")
    limits = scene.framework.limits
    assert stepping.worst_limit(scene.positions, limits) == 0.0
    a, b, _, most, *_ = limits[0]
    moved = scene.positions.copy()
    along = moved[b] - moved[a]
    moved[b] = moved[a] + along * ((most + 0.25) / np.linalg.norm(along))
    single = [limits[0]]
    assert stepping.worst_limit(moved, single) == pytest.approx(0.25)
    assert stepping.worst_limit(moved, []) == 0.0


def test_memory_grows_with_the_joints():
    asked = {"source": "copies", "model": "angles", "technique": "auto", "run": {}}
    small, large = (step_memory.bytes_per_joint({**asked, "size": n}) for n in (20_000, 40_000))
    for found in (small, large):  # 2.9 bars a joint, each of 16 bytes at least; and a lid
        assert 100 < found["run"] < 3000 and found["made"] > 100
    assert step_memory.bytes_per_joint({**asked, "source": "none.pdb", "size": 10}) == {
        "run": None, "made": None
    }  # fmt: skip


def test_models_need_atoms():
    with pytest.raises(pliant.OptionError, match=r'"zigzag" has no atoms.*peptide, copies have'):
        stepping.steps_of_pushes(kinds=("zigzag",), model="protein")


def test_the_command_takes_files(capsys):
    files = "data/molecules/alanine_dipeptide.pdb,data/molecules/peptide_20.pdb"
    words = ["step", *files.split(","), "--bars", "angles", "--steps", "10", "--repeats", "1"]
    assert main([*words, "--json", "--quiet"]) == 0
    rows = json.loads(capsys.readouterr().out)["rows"]
    assert [(row["kind"], row["model"], row["joints"]) for row in rows] == [
        ("alanine_dipeptide.pdb", "angles", 22),
        ("peptide_20.pdb", "angles", 327),
    ]
    assert rows[0]["ratio"] == 1.0 and rows[0]["bytes_per_joint"] is None


@pytest.mark.long
def test_local_techniques_look_at_as_many_bars_in_any_size():
    found = stepping.steps_of_pushes(
        (1000, 10_000), techniques=("blocks", "bfs_cycle"), steps=200, rounds=2
    )
    assert found.faults == []
    sizes = [(row.technique, row.joints) for row in found.rows]
    assert sizes == [
        ("blocks", 1020),
        ("blocks", 10_020),
        ("bfs_cycle", 1020),
        ("bfs_cycle", 10_020),
    ]
    small, large, all_small, all_large = found.rows
    assert large.projections == pytest.approx(small.projections, rel=0.5)
    assert all_large.projections > 5 * all_small.projections > 100 * small.projections
    for row in found.rows:
        assert row.max_residual <= 1e-6 and row.unconverged == 0
        assert 0 < row.quarter <= row.step_microseconds <= row.three_quarters
        assert row.ratio_least <= row.ratio <= row.ratio_most
    assert small.ratio == all_small.ratio == 1


def test_broken_ends_are_named(monkeypatch):
    monkeypatch.setattr(stepping._bars, "worst_residual", lambda *_: 1e-3)
    found = stepping.steps_of_pushes((100,), techniques=("blocks",), steps=2, rounds=1)
    assert found.faults == ["protein of 120, blocks: a bar is off by 1.0e-03 in the end"]


def test_unknown_kinds_are_refused():
    with pytest.raises(pliant.OptionError, match='no kind named "sheet"; known: protein'):
        stepping.steps_of_pushes(kinds=("sheet",))


def test_the_command_prints_a_table_and_writes_csv(capsys, tmp_path, monkeypatch):
    table = tmp_path / "rows.csv"
    words = ["step", "--sizes", "100,200", "--kinds", "zigzag", "--steps", "5", "--repeats", "1"]
    assert main([*words, "--csv", str(table)]) == 0
    assert "us a step" in capsys.readouterr().out
    assert [row["joints"] for row in csv.DictReader(table.open())] == ["100", "200"] * 2
    monkeypatch.setattr(stepping._bars, "worst_residual", lambda *_: 1.0)
    assert main([*words, "--json"]) == 1
    assert len(json.loads(capsys.readouterr().out)["rows"]) == 4
