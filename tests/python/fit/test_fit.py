# SPDX-License-Identifier: MIT
"""Fits of adenylate kinase, open, to distances of the closed one."""

import csv
import json
from pathlib import Path

import numpy as np
import pytest
from real_files import DIPEPTIDE

import pliant

pytest.importorskip("MDAnalysisTests")
import MDAnalysisTests
from pliant.jobs.fit.command import main
from pliant.jobs.fit.data import Sites, in_nanometres, read_distances
from pliant.jobs.fit.design import best_pairs
from pliant.jobs.fit.design_command import main as design_main
from pliant.jobs.fit.nodes import distances

DATA = Path(MDAnalysisTests.__file__).parent / "data"
OPEN, CLOSED = DATA / "adk_open.pdb", DATA / "adk_closed.pdb"
PAIRS = ((30, 126), (55, 170), (40, 150), (45, 130), (60, 155), (125, 90), (20, 160), (35, 200))

pytestmark = pytest.mark.filterwarnings("ignore::pliant.PliantWarning")


def alpha_carbons(structure):
    """Positions by residue number."""
    chosen = np.flatnonzero((structure.names == "CA") & (structure.elements == 6))
    return dict(
        zip(structure.residue_ids[chosen].tolist(), structure.positions[chosen], strict=True)
    )


def measured(wrong=None):
    """Rows of distances in the closed structure, one of them perhaps wrong by 15 Angstrom."""
    at = alpha_carbons(pliant.read(CLOSED))
    rows = []
    for k, (one, other) in enumerate(PAIRS):
        distance = float(np.linalg.norm(at[one] - at[other])) + 15 * (k == wrong)
        rows.append({"site1": one, "site2": other, "distance": distance, "error": 1})
    return rows


def rmsd(points, goal):
    """After the best rotation and shift (Kabsch)."""
    one, other = points - points.mean(axis=0), goal - goal.mean(axis=0)
    u, values, vt = np.linalg.svd(one.T @ other)
    values[2] *= np.sign(np.linalg.det(u @ vt))
    return np.sqrt((np.sum(one**2) + np.sum(other**2) - 2 * values.sum()) / len(points))


@pytest.fixture(scope="module")
def closing():
    return pliant.fit(OPEN, measured(), frames=60)


def off_the_closed(fit, frame=0):
    at, goal = np.flatnonzero(fit.structure.names == "CA"), alpha_carbons(pliant.read(CLOSED))
    return rmsd(fit.positions[frame][at], np.array(list(goal.values())))


def test_eight_distances_close_it(closing):
    assert closing.agrees
    assert closing.rmsd_from_start > 4
    assert off_the_closed(closing) < 3
    assert "agree" in closing.verdict()
    assert len(closing.spread) == 214
    assert closing.off_left_out < closing.off_at_start


def test_what_is_kept_is_exact(closing):
    framework = closing.model.framework
    bars, rest = framework.bars, framework.rest_lengths
    assert len(closing.kept) == len(closing) == 1
    for positions in closing.positions:
        lengths = np.linalg.norm(positions[bars[:, 1]] - positions[bars[:, 0]], axis=1)
        assert np.abs(lengths / rest - 1).max() < 1e-9
    assert max(one.overlap for one in closing.kept) <= 0.1


def test_found_distances_are_those_of_the_structure(closing):
    at = np.flatnonzero(closing.structure.names == "CA")
    numbers = closing.structure.residue_ids[at].tolist()
    nodes = closing.positions[0][at]
    for one, (a, b) in zip(closing.data, PAIRS, strict=True):
        apart = np.linalg.norm(nodes[numbers.index(a)] - nodes[numbers.index(b)])
        assert one.found == pytest.approx(apart)
        assert one.violation == pytest.approx(max(0, apart - one.high) + min(0, apart - one.low))


@pytest.mark.long
def test_a_wrong_distance_is_named():
    fit = pliant.fit(OPEN, measured(wrong=2), frames=200)
    assert [one.contradicts for one in fit.data] == [k == 2 for k in range(len(PAIRS))]
    assert "cannot hold with the others" in fit.verdict()
    assert off_the_closed(fit) < 3.5


def test_the_same_seed_gives_the_same_bits(closing):
    again = pliant.fit(OPEN, measured(), frames=60)
    assert np.array_equal(closing.positions, again.positions)


def write(path, rows, fields=("site1", "site2", "distance", "error")):
    with open(path, "w", newline="") as stream:
        writer = csv.writer(stream)
        writer.writerows([fields, *rows])
    return str(path)


def test_the_command_writes_structures_and_a_report(tmp_path, capsys):
    table = write(tmp_path / "d.csv", [tuple(row.values()) for row in measured()[:3]])
    out = tmp_path / "fitted.pdb"
    words = [str(OPEN), "--distances", table, "-o", str(out), "--frames", "60", "--json"]
    assert main(words) == 0
    report = json.loads(capsys.readouterr().out)
    assert report["agrees"]
    assert len(report["distances"]) == 3
    assert len(report["spread"]) == 214
    assert len(alpha_carbons(pliant.read(out))) == 214
    assert main(words) == 2  # the output exists


BAD = {
    "no such atom": (("999", "30", "20", "1"), "site1 '999'"),
    "two residues": (("resid 4 5", "30", "20", "1"), "site1 'resid 4 5'"),
    "no selection": (("nonsense (", "30", "20", "1"), "site1 'nonsense ('"),
    "error 0": (("30", "60", "20", "0"), "error: expected a number of Angstrom above 0, found '0'"),
    "error below 0": (("30", "60", "20", "-1"), "error: expected"),
    "not a number": (("30", "60", "nan", "1"), "distance: expected"),
    "no error": (("30", "60", "20", ""), "error: expected"),
    "nothing": (("30", "60", "", ""), "distance: expected distance and error, or low and high"),
    "the same atom": (("30", "30", "20", "1"), "site2: expected another residue than site1"),
}


@pytest.mark.parametrize("name", BAD)
def test_a_bad_row_is_one_line(tmp_path, capsys, name):
    row, expected = BAD[name]
    table = write(tmp_path / "d.csv", [("30", "126", "20", "1"), row])
    assert main([str(OPEN), "--distances", table, "-o", str(tmp_path / "o.pdb")]) == 1
    lines = [line for line in capsys.readouterr().err.splitlines() if "error:" in line]
    assert len(lines) == 1
    assert f"{table}:3: {expected}" in lines[0]
    assert not (tmp_path / "o.pdb").exists()


@pytest.mark.parametrize(
    ("fields", "row", "expected"),
    [
        (("site1", "site2", "low", "high"), (30, 60, 20, 10), ":2: low: expected at most high, 10"),
        (
            ("site1", "site2", "kind"),
            (30, 60, "DSX"),
            ":2: kind: expected one of CA, atom, NOE, DSS",
        ),
        (("site1", "site2", "lo"), (30, 60, 1), ":2: unknown field 'lo'"),
        (("a", "b"), (30, 60), ":1: expected a header with site1, site2"),
    ],
)
def test_bad_intervals_kinds_and_headers(tmp_path, fields, row, expected):
    table = write(tmp_path / "d.csv", [row], fields)
    with pytest.raises(pliant.InputError, match=r"d\.csv") as raised:
        pliant.fit(OPEN, table)
    assert expected in str(raised.value)


def test_an_empty_table_and_a_small_molecule_are_refused(tmp_path):
    with pytest.raises(pliant.InputError, match="expected at least one distance"):
        pliant.fit(OPEN, write(tmp_path / "d.csv", []))
    with pytest.raises(pliant.InputError, match="expected a protein or nucleic acid"):
        pliant.fit(DIPEPTIDE, measured())


def test_a_cross_link_is_an_upper_limit():
    fit = pliant.fit(OPEN, [{"site1": 55, "site2": 170, "kind": "EDC"}], frames=60)
    assert (fit.data[0].low, fit.data[0].high) == (0, 20)
    assert fit.data[0].found < 21


def test_labels_are_where_beta_carbons_point():
    structure = pliant.read(CLOSED)
    atoms = np.flatnonzero(structure.names == "CA")
    sites = Sites(structure, atoms)
    row = {"site1": 55, "site2": 170, "distance": 30, "error": 5, "kind": "mtsl"}
    datum = read_distances([row], sites)[0]
    ends = []
    for residue in (55, 170):
        of = structure.residue_ids == residue
        alpha, beta = (
            structure.positions[of & (structure.names == name)][0] for name in ("CA", "CB")
        )
        ends.append(alpha + 4.1 * (beta - alpha) / np.linalg.norm(beta - alpha))
    apart = np.linalg.norm(ends[0] - ends[1])
    assert distances(structure.positions[atoms], [datum])[0] == pytest.approx(apart, abs=0.6)
    with pytest.raises(
        pliant.InputError, match="site1: expected an amino acid that is not the end"
    ):
        read_distances([row | {"site1": 1}], sites)


def test_a_distance_between_labels_is_met():
    row = {"site1": 41, "site2": 148, "low": 22, "high": 24, "kind": "MTSL"}
    fit = pliant.fit(OPEN, [row], frames=60)
    assert fit.data[0].at_start > 28
    assert 21.5 < fit.data[0].found < 24.5


def test_nanometres_are_noticed():
    rows = [row | {"distance": row["distance"] / 10, "error": 0.1} for row in measured()]
    structure = pliant.read(OPEN)
    atoms = np.flatnonzero(structure.names == "CA")
    sites = Sites(structure, atoms)
    nodes = structure.positions[atoms]
    assert in_nanometres(read_distances(rows, sites), nodes)
    assert not in_nanometres(read_distances(measured(), sites), nodes)


def test_designed_pairs_can_be_labelled_and_explain_more_each():
    found = pliant.design(OPEN, 6, method="deer", exclude=["145"], frames=100)
    structure = pliant.read(OPEN)
    names = dict(zip(structure.residue_ids.tolist(), structure.residue_names, strict=True))
    explained = [one["explained"] for one in found.pairs]
    assert explained == sorted(explained)
    for one in found.pairs:
        numbers = [int(one[site].split(":")[-1]) for site in ("site1", "site2")]
        assert numbers[1] - numbers[0] > 8
        assert 145 not in numbers
        assert all(names[number] not in ("GLY", "PRO") for number in numbers)
        assert 15 <= one["mean"] <= 60


def test_cross_links_are_designed_between_lysines(capsys):
    words = [str(OPEN), "--method", "crosslink", "--distances", "3", "--frames", "60", "--json"]
    assert design_main(words) == 0
    found = json.loads(capsys.readouterr().out)
    structure = pliant.read(OPEN)
    lysines = structure.residue_ids[structure.residue_names == "LYS"].tolist()
    for one in found["pairs"]:
        assert all(int(one[site].split(":")[-1]) in lysines for site in ("site1", "site2"))


def test_a_design_stops_where_nothing_is_gained():
    frames = np.zeros((20, 30, 3))
    frames[:, :, 0] = 3.8 * np.arange(30)
    frames[:, 15:, 1] = np.linspace(0, 9, 20)[:, None]  # one motion
    pairs = best_pairs(frames, range(30), 5, (0.0, 1e3))
    assert 1 <= len(pairs) < 5
    assert pairs[0].explained > 0.9
