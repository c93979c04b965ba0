# SPDX-License-Identifier: MIT
"""Frames minimised by OpenMM: hydrogens, energies, verdicts, and frames damaged on purpose."""

import numpy as np
import pytest
from expected_warnings import read_without_elements
from pliant.checks.coverage import Coverage
from pliant.checks.findings import CANNOT, FAILED, PASSED, SKIPPED
from pliant.checks.force_field import jobs as force_field_jobs
from pliant.checks.force_field.hydrogens import hydrogen_counts
from pliant.checks.force_field.minimise import QUICK, THOROUGH, Wanted, minimise_frames
from pliant.checks.force_field.minimised import ForceFieldReport, Minimised
from pliant.checks.force_field.molecule import molecule_of
from pliant.checks.force_field.verdicts import findings_of, md_verdict, reached
from pliant.report.check.command import main

import pliant

MDA = pytest.importorskip("MDAnalysisTests.datafiles")
openmm = pytest.importorskip("openmm")
app = pytest.importorskip("openmm.app")
worker = pytest.importorskip("pliant.checks.force_field.worker")
FEW = Wanted(starts="all", long_starts=0, md_steps=0)

PEPTIDE = MDA.PDB_small.replace("adk_open.pdb", "adk_open_10res.pdb")


@pytest.fixture(scope="module")
def sampled():
    """Ten residues of adenylate kinase, all hydrogens, no end."""
    start = read_without_elements(PEPTIDE)
    with pytest.warns(pliant.PliantWarning, match="held too tightly to move that far"):
        return pliant.sample(start, frames=3, seed=2)


@pytest.fixture(scope="module")
def peptide(sampled):
    return sampled.model.structure


@pytest.fixture(scope="module")
def start(sampled):
    return np.array(sampled.model.positions)


@pytest.fixture(scope="module")
def minimised(peptide, start, sampled):
    return minimise_frames(peptide, start, sampled.positions, FEW)


def write(sampled, path, parameters=None):
    """An ensemble as pliant sample writes it, with its start beside."""
    model = sampled.model
    flat = {"sample/sampler": "modes", "model/kind": "protein"}
    with pliant.H5mdRecorder(
        path,
        model.framework,
        structure=model.structure,
        parameters=flat if parameters is None else parameters,
    ) as recorder:
        for k, positions in enumerate(sampled.positions):
            recorder.record(pliant.Frame(k, 0.0, positions))
    pliant.write_topology_pdb(path.with_suffix(".pdb"), model.structure, positions=model.positions)
    return path


def stripped(structure, positions):
    """Without hydrogens on carbon; and the atoms that are left."""
    elements, bonds = np.asarray(structure.elements), np.asarray(structure.bonds)
    on_carbon = set()
    for a, b in [*bonds, *bonds[:, ::-1]]:
        if elements[a] == 1 and elements[b] == 6:
            on_carbon.add(int(a))
    kept = np.setdiff1d(np.arange(len(structure)), list(on_carbon))
    new = {int(atom): k for k, atom in enumerate(kept)}
    return taken(structure, positions, kept, new), kept


def taken(structure, positions, kept, new):
    bonds = [[new[int(a)], new[int(b)]] for a, b in structure.bonds if {int(a), int(b)} <= {*new}]
    return pliant.Structure(
        positions[kept],
        elements=structure.elements[kept],
        names=[structure.names[k] for k in kept],
        residue_names=[structure.residue_names[k] for k in kept],
        residue_ids=structure.residue_ids[kept],
        bonds=bonds,
    )


def test_placed_hydrogens_are_where_the_file_has_them(peptide, start):
    bare, kept = stripped(peptide, start)
    molecule = molecule_of(bare)
    assert molecule.placed == len(peptide) - len(bare)
    whole = molecule.complete(start[kept])
    assert len(whole) == len(peptide)
    free = np.setdiff1d(np.arange(len(peptide)), kept)
    placed = whole[(molecule.names == "H") & (molecule.elements == 1)][: len(free)]
    # Each hydrogen of the file has one that was placed beside it; methyls may be turned.
    apart = np.linalg.norm(start[free][:, None] - placed[None], axis=2).min(axis=1)
    assert np.median(apart) < 0.1
    assert apart.max() < 1.0


def test_counts_of_hydrogens_are_those_of_the_force_field():
    templates = app.ForceField("amber14/protein.ff14SB.xml")._templates
    names = "HIE ILE LEU LYS MET PHE PRO SER THR TRP TYR VAL ACE NME HID HIP CYX ASH GLH LYN ALA"
    for name in [*names.split(), "ARG", "ASN", "ASP", "CYS", "GLN", "GLU", "GLY"]:
        template = templates[name]
        expected = {}
        for atom in template.atoms:
            if atom.element.symbol == "C":
                near = [template.atoms[k].element.symbol for k in atom.bondedTo]
                expected[atom.name] = near.count("H")
        ours = hydrogen_counts(name)
        assert {k: v for k, v in expected.items() if v} == {
            k: v for k, v in ours.items() if k in expected
        }, name


def energies_of(system, structures):
    """By the Reference platform, kJ/mol; structures in Angstrom."""
    platform = openmm.Platform.getPlatform("Reference")
    context = openmm.Context(system, openmm.VerletIntegrator(0.001), platform)
    energies = []
    for positions in structures:
        context.setPositions(0.1 * positions)
        energies.append(context.getState(getEnergy=True).getPotentialEnergy()._value)
    return np.array(energies)


def test_the_force_field_is_that_of_openmm_alone(peptide, start, sampled, monkeypatch):
    """Beside OpenMM's own reader, templates and implicit/obc2.xml, without a cut-off."""
    topology = app.PDBFile(PEPTIDE).topology
    files = app.ForceField("amber14/protein.ff14SB.xml", "implicit/obc2.xml")
    system = files.createSystem(topology, nonbondedMethod=app.NoCutoff, ignoreExternalBonds=True)
    monkeypatch.setattr(worker, "CUTOFF", 1e5)
    arrays = force_field_jobs.Bench(molecule_of(peptide), 1.0, 0.0).match_job().arrays
    ours = energies_of(worker.make_system(arrays), [start, *sampled.positions])
    theirs = energies_of(system, [start, *sampled.positions])
    assert ours == pytest.approx(theirs, abs=0.05)
    assert np.abs(np.diff(theirs)).min() > 0.1  # more than the two may


def test_energies_are_of_the_frames_of_the_file(minimised, peptide, start, sampled):
    arrays = force_field_jobs.Bench(molecule_of(peptide), 1.0, 0.0).match_job().arrays
    direct = energies_of(worker.make_system(arrays), [start, *sampled.positions])
    found = [minimised.start.before, *(f.before for f in minimised.frames)]
    assert found == pytest.approx(direct, abs=0.05)


def test_what_minimising_gives(minimised):
    assert minimised.why_not == ""
    assert (minimised.residues, minimised.placed_hydrogens) == (10, 0)
    assert "1 ends of chains lack the atoms of an end (GLY10)" in minimised.notes[0]
    for structure in [minimised.start, *minimised.frames]:
        assert structure.is_finite and structure.after_short < structure.before
        assert 0.01 < structure.moved < 1.0
        assert structure.inverted == []
        assert 1e2 < structure.worst_force < 1e6
    assert len(minimised.above_start(minimised.frames)) == 3
    assert len(minimised.above_start(minimised.frames, 500)) == 0
    status = {finding.name: finding.status for finding in findings_of(minimised)}
    assert status["starts_finite"] == status["starts_shape"] == PASSED
    assert status["starts_energy_100"] == SKIPPED
    assert "starts_energy_500" not in status


def test_bits_do_not_depend_on_the_number_of_processes(
    minimised, peptide, start, sampled, monkeypatch
):
    monkeypatch.setattr(force_field_jobs, "cores", lambda: 1)
    again = minimise_frames(peptide, start, sampled.positions, FEW)
    for one, other in zip(minimised.frames, again.frames, strict=True):
        assert (one.after_short, one.moved) == (other.after_short, other.moved)


def flipped(structure, positions, residue):
    """The side chain and HA of a residue mirrored at the plane of N, CA and C."""
    atoms = np.flatnonzero(np.asarray(structure.residue_ids) == residue)
    by_name = {str(structure.names[k]): k for k in atoms}
    alpha = positions[by_name["CA"]]
    normal = np.cross(positions[by_name["N"]] - alpha, positions[by_name["C"]] - alpha)
    normal /= np.linalg.norm(normal)
    backbone = {"N", "CA", "C", "O", "HN", "H"}
    side = [k for name, k in by_name.items() if name not in backbone]
    mirrored = positions.copy()
    mirrored[side] -= 2 * np.outer((positions[side] - alpha) @ normal, normal)
    return mirrored


def test_frames_damaged_on_purpose_fail_and_are_named(peptide, start):
    turned = flipped(peptide, start, 5)
    together = start.copy()
    together[100] = start[10] + [0.02, 0, 0]
    no_number = start.copy()
    no_number[3] = np.nan
    report = minimise_frames(peptide, start, np.array([start, turned, together, no_number]), FEW)
    by_name = {finding.name: finding for finding in findings_of(report)}
    shape = by_name["starts_shape"]
    assert shape.status == FAILED
    assert shape.notes[-1] == "residues whose chirality changed: frame 1 (LEU5)"
    assert "as of atoms in one place: frame 2" in shape.notes[0]
    assert by_name["starts_finite"].status == FAILED
    assert "frame 3" in by_name["starts_finite"].notes[0]
    assert "frame 0" not in "".join(by_name["starts_finite"].notes + shape.notes)
    assert md_verdict(report, 4).kind == "mixed"


def test_what_has_no_template_is_left_out_with_a_warning(peptide, start):
    with_ion = pliant.Structure(
        np.concatenate([start, [[50.0, 0, 0]]]),
        elements=[*peptide.elements, 25],
        names=[*peptide.names, "MN"],
        residue_names=[*peptide.residue_names, "MN"],
        residue_ids=[*peptide.residue_ids, 99],
        bonds=peptide.bonds,
    )
    molecule = molecule_of(with_ion)
    assert len(molecule.kept) == len(peptide)
    assert molecule.left_out == {"MN": 1}


def test_ions_of_amber14_are_kept(peptide, start):
    molecule = molecule_of(with_an_ion(peptide, start, "ZN", 30)[0])
    assert (molecule.left_out, molecule.elements[-1]) == ({}, 30)
    system = worker.make_system(force_field_jobs.Bench(molecule, 1.0, 0.0).match_job().arrays)
    nonbonded = next(f for f in system.getForces() if isinstance(f, openmm.NonbondedForce))
    assert nonbonded.getParticleParameters(157)[0]._value == 2.0
    assert "only charge and size hold in their place: ZN99" in molecule.notes[-1]


def with_an_ion(peptide, positions, name="MN", element=25):
    """The peptide and a manganese ion far from it; positions (N, 3) or (F, N, 3)."""
    ion = np.broadcast_to([50.0, 0, 0], (*positions.shape[:-2], 1, 3))
    placed = np.concatenate([positions, ion], axis=-2)
    structure = pliant.Structure(
        placed.reshape(-1, len(peptide) + 1, 3)[0],
        elements=[*peptide.elements, element],
        names=[*peptide.names, name],
        residue_names=[*peptide.residue_names, name],
        residue_ids=[*peptide.residue_ids, 99],
        bonds=peptide.bonds,
    )
    return structure, placed


def test_the_verdict_says_first_what_it_does_not_cover(peptide, start, sampled):
    structure, frames = with_an_ion(peptide, np.concatenate([start[None], sampled.positions]))
    said = []
    report = minimise_frames(structure, frames[0], frames[1:2], FEW, say=said.append)
    plan = "OpenMM minimises the start and 1 frame, 157 atoms each, on its platform CPU"
    assert said == [f"{plan}, without 1 MN: no parameters"]
    said = md_verdict(report, 200)
    assert said.sentence == (
        "MD of the protein alone (without 1 MN) can be started from these frames, once minimised. "
        "1 of 200 frames tested."
    )
    assert said.details == "What frames do near 1 MN is not tested."
    found = Coverage(200, len(report.usable), report.left_out)
    assert found.text == (
        "bars of all 200 frames; MD starts: 1 frame, the protein alone, without 1 MN"
    )
    assert Coverage(200).text == "bars of all 200 frames"


def test_a_quick_look_is_at_few_frames():
    assert QUICK.starts_of(1231) == 5
    assert QUICK.starts_of(3100) == 3
    assert THOROUGH.starts_of(3100) == 20
    assert Wanted(starts="all").starts_of(3100) == "all"


def test_a_residue_that_lacks_atoms_is_named_and_nothing_is_minimised(peptide, start):
    names, ids = np.asarray(peptide.names), np.asarray(peptide.residue_ids)
    lacking = np.flatnonzero((ids == 5) & np.isin(names, ["CD1", "HD11", "HD12", "HD13"]))
    kept = np.setdiff1d(np.arange(len(peptide)), lacking)
    cut = taken(peptide, start, kept, {int(atom): k for k, atom in enumerate(kept)})
    report = minimise_frames(cut, start[kept], start[kept][None], FEW)
    assert report.why_not.startswith("No template found for residue 4 (LEU5).")
    assert [finding.status for finding in findings_of(report)] == [CANNOT] * 5


def test_when_time_is_over_nothing_is_called_passed(peptide, start):
    wanted = Wanted(starts="all", long_starts=0, md_steps=0, total_limit=1e-9)
    report = minimise_frames(peptide, start, start[None], wanted)
    assert report.frames[0].outcome == "not begun: the time for minimising was over"
    assert {finding.status for finding in findings_of(report)} == {CANNOT}


# The command and the function


def test_it_says_whether_md_may_start(sampled, tmp_path):
    path = write(sampled, tmp_path / "ensemble.h5md")
    picture = tmp_path / "out" / "ensemble.check.png"
    found = pliant.check(path, starts=2, long_starts=1, md_steps=20, picture=picture)
    report = found.as_json()
    names = [check["name"] for check in report["checks"]]
    assert names[-5:] == [
        "starts_finite",
        "starts_energy_100",
        "starts_energy_500",
        "starts_moved",
        "starts_shape",
    ]
    assert report["covers"] == {"frames": 3, "md_starts": 2, "left_out": {}, "ligands": []}
    found = report["force_field"]
    assert [frame["frame"] for frame in found["frames"]] == [0, 2]
    assert [frame["name"] for frame in found["dynamics"]][-1] == "MD 0.08 ps"
    assert all(frame["above_start"]["100"] is not None for frame in found["dynamics"])
    assert found["frames"][0]["above_start"]["500"] is not None
    assert picture.stat().st_size > 20_000
    assert report["side_by_side"] == []


def test_without_a_start_structure_the_error_says_what_to_do(sampled, tmp_path, capsys):
    path = write(sampled, tmp_path / "ensemble.h5md")
    path.with_suffix(".pdb").unlink()
    assert main([str(path), "--force-field"]) == 1
    assert capsys.readouterr().err == (
        f"pliant check: error: {path.with_suffix('.pdb')}: no such file; name the start "
        "structure with --reference\n"
    )
    report = pliant.check(path)
    assert report.force_field is None and report.passed
    assert report.findings[-1].notes[0].startswith("no force field: ")
    with (
        pytest.warns(pliant.PliantWarning, match="no element in columns 77-78: taken from"),
        pytest.raises(pliant.InputError, match=r"expected 157 atoms, found 3341"),
    ):
        pliant.check(path, force_field=True, start=MDA.PDB_small)


# Verdicts on numbers made by hand


def made(above_short, above_long, moved, residues=100):
    """A report of frames with these energies a residue above a start of -1000 kJ/mol."""
    rows = enumerate(zip(above_short, above_long, moved, strict=True))
    frames = [
        Minimised(f"frame {k}", k, 1e4, 0.0, residues * a - 1000.0, residues * b - 1000.0, m)
        for k, (a, b, m) in rows
    ]
    start = Minimised("start", None, 1e4, 0.0, -1000.0, -1000.0, 0.2)
    return ForceFieldReport(start, frames, [], residues, 1000, 0, 0.0)


def status_of(report):
    return {finding.name: finding.status for finding in findings_of(report)}


def test_95_percent_of_frames_must_be_within_the_limits():
    good = [1.0] * 19
    assert md_verdict(made([*good, 9.0], [0.5] * 20, [0.3] * 20), 20).kind == "good"
    two = status_of(made([*good[:18], 9.0, 9.0], [0.5] * 20, [0.3] * 20))
    assert two["starts_energy_100"] == FAILED and two["starts_energy_500"] == PASSED
    late = status_of(made([1.0] * 20, [1.01] * 20, [0.3] * 20))
    assert late["starts_energy_100"] == PASSED and late["starts_energy_500"] == FAILED
    assert status_of(made([1.0] * 20, [0.5] * 20, [0.41] * 20))["starts_moved"] == FAILED
    assert reached(np.arange(20.0)) == 18.0
    assert reached(np.arange(4.0)) == 3.0


def test_a_few_residues_are_shown_and_not_judged():
    report = made([9.0] * 4, [9.0] * 4, [0.3] * 4, residues=10)
    found = {finding.name: finding for finding in findings_of(report)}
    assert found["starts_energy_100"].status == SKIPPED
    assert found["starts_energy_100"].measured == "+9.00 kJ/mol at most"


def test_a_frame_without_number_fails_all_but_its_shape():
    report = made([1.0] * 3, [0.5] * 3, [0.3] * 3)
    report.frames[1].after_short = report.frames[1].moved = float("nan")
    found = status_of(report)
    assert found["starts_finite"] == found["starts_energy_100"] == found["starts_moved"] == FAILED


def test_what_was_not_minimised_is_called_partial():
    report = made([1.0] * 3, [0.5] * 3, [0.3] * 3)
    report.frames[2] = Minimised("frame 2", 2, outcome="took more than 300 s")
    finding = findings_of(report)[0]
    assert finding.measured == "2 of 2"
    assert finding.notes == ["partial: 2 of 3 frames were minimised; frame 2: took more than 300 s"]


@pytest.mark.long
def test_adenylate_kinase_is_usable_as_md_starts(tmp_path):
    found = pliant.sample(read_without_elements(MDA.PDB_small), frames=200)
    structure, start = found.model.structure, np.array(found.model.positions)
    chosen = found.positions[np.linspace(0, 199, 20).round().astype(int)]
    wanted = Wanted("all", 4, 250, time_limit=1200.0, total_limit=3600.0)
    report = minimise_frames(structure, start, chosen, wanted)
    assert [finding.status for finding in findings_of(report)] == [PASSED] * 5
    assert len(report.usable) == 20
    assert np.mean(report.above_start(report.frames) <= 3.0) >= 0.95
    assert report.above_start(report.frames, 500).max() <= 1.0
    assert report.moved(report.frames).max() <= 0.4
