# SPDX-License-Identifier: MIT
"""Proteins with ligands: minimised whole, on any platform, and written as systems that run."""

import shutil
import subprocess
import sys
import warnings
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from expected_warnings import read_without_elements
from pliant.base.force_field_options import ForceFieldOptions
from pliant.checks.coverage import Coverage
from pliant.checks.findings import FAILED, PASSED
from pliant.checks.force_field import jobs as force_field_jobs
from pliant.checks.force_field.export import export
from pliant.checks.force_field.minimise import Wanted, minimise_frames
from pliant.checks.force_field.molecule import molecule_of
from pliant.checks.force_field.verdicts import findings_of, md_verdict
from pliant.checks.ligands import ambertools

import pliant

MDA = pytest.importorskip("MDAnalysisTests.datafiles")
openmm = pytest.importorskip("openmm")
app = pytest.importorskip("openmm.app")
pytest.importorskip("rdkit")
pytest.importorskip("scipy")
worker = pytest.importorskip("pliant.checks.force_field.worker")
platforms = pytest.importorskip("pliant.checks.force_field.platforms")

DATA = Path(MDA.PDB_small).parent
PEPTIDE = DATA / "adk_open_10res.pdb"


# Ten residues of adenylate kinase, and methane beside them. Programs stand for AmberTools.


@pytest.fixture(scope="module")
def complex_():
    start = read_without_elements(PEPTIDE)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", pliant.PliantWarning)  # it is held tightly
        sampled = pliant.sample(start, frames=2, seed=2)
    peptide, model = sampled.model.structure, np.array(sampled.model.positions)
    frames = np.concatenate([model[None], sampled.positions])
    carbon = model.mean(axis=0) + np.array([0, 0, 12.0])
    placed = np.concatenate([frames, np.broadcast_to(carbon, (3, 1, 3))], axis=1)
    structure = pliant.Structure(
        placed[0],
        elements=[*peptide.elements, 6],
        names=[*peptide.names, "C1"],
        residue_names=[*peptide.residue_names, "LIG"],
        residue_ids=[*peptide.residue_ids, 99],
        chains=["A"] * (len(peptide) + 1),
        bonds=peptide.bonds,
    )
    return structure, placed


def test_a_complex_is_minimised_whole(tools, complex_):
    tools()
    structure, frames = complex_
    said = []
    report = minimise_frames(
        structure, frames[0], frames[1:], Wanted(starts="all"), say=said.append
    )
    where = f"162 atoms each, on its platform {report.platform}"
    assert said[-1] == f"OpenMM minimises the start and 2 frames, {where}"
    assert (report.left_out, report.ligands, report.placed_hydrogens) == ({}, ["A:LIG99"], 4)
    for one in [report.start, *report.frames]:
        ligand = one.ligands["A:LIG99"]
        assert one.is_finite and ligand.strain > -0.01 and ligand.moved < 2
    by_name = {finding.name: finding for finding in findings_of(report)}
    assert by_name["starts_ligands"].status == PASSED
    assert "with A:LIG99" in md_verdict(report, 2).sentence
    assert "A:LIG99: GAFF2, charge +0, C: bond orders" in report.notes[-1]
    text = Coverage(2, 2, {}, report.ligands).text
    assert text == "bars of all 2 frames; MD starts: 2 frames, with A:LIG99"
    report.frames[0].ligands["A:LIG99"].__dict__["strain"] += 60.0
    by_name = {finding.name: finding for finding in findings_of(report)}
    assert by_name["starts_ligands"].status == PASSED
    assert by_name["starts_strain"].status == FAILED
    assert "(+50 kJ/mol allowed)" in by_name["starts_strain"].in_words


def test_without_ambertools_the_protein_is_checked_as_before(tools, complex_):
    tools(antechamber=None)
    structure, frames = complex_
    report = minimise_frames(structure, frames[0], frames[1:2], Wanted(starts="all"))
    assert report.left_out == {"LIG": 1}
    assert report.why_left_out["A:LIG99"].startswith("AmberTools' antechamber not found: pip")
    assert report.frames[0].is_finite


def test_energies_do_not_depend_on_the_platform(tools, complex_):
    tools()
    structure, frames = complex_
    found = []
    for platform in ("CPU", "Reference"):
        wanted = Wanted(starts="all", force_field=ForceFieldOptions(platform=platform))
        report = minimise_frames(structure, frames[0], frames[1:2], wanted)
        assert report.platform == platform
        found.append([report.start.before, report.frames[0].before])
    assert found[0] == pytest.approx(found[1], rel=1e-5)


def test_a_platform_that_is_not_there_names_those_that_are():
    bench = force_field_jobs.Bench.__new__(force_field_jobs.Bench)
    bench.choose("auto", ["CUDA", "CPU"])
    assert bench.platform == "CUDA"
    bench.choose("cpu", ["CUDA", "CPU"])
    assert bench.platform == "CPU"
    wanted = r"--platform: expected one of auto, CUDA, CPU, found 'HIP'"
    with pytest.raises(pliant.OptionError, match=wanted):
        bench.choose("HIP", ["CUDA", "CPU"])


def test_opencl_on_a_processor_comes_last(monkeypatch):
    """OpenMM calls it five times as fast as CPU; minimisations die there."""

    class Known:
        def __init__(self, name, speed, device):
            self.getName, self.getSpeed, self.device = (lambda: name), (lambda: speed), device

    pocl = "Portable Computing Language"
    every = [Known("Reference", 1, ""), Known("CPU", 10, ""), Known("OpenCL", 50, pocl),
             Known("CUDA", 100, None)]  # fmt: skip
    known = SimpleNamespace(getNumPlatforms=lambda: 4, getPlatform=lambda k: every[k])
    monkeypatch.setattr(platforms, "openmm", SimpleNamespace(Platform=known))
    monkeypatch.setattr(platforms, "_device_of", lambda one: one.device)
    assert platforms.platforms() == ["CPU", "Reference", "OpenCL"]
    every[2].device = "NVIDIA CUDA"
    assert platforms.platforms() == ["OpenCL", "CPU", "Reference"]


def test_terms_of_a_ligand_are_those_of_its_topology(tools, complex_):
    """The System less that of the protein has methane's bonds, angles and charges."""
    tools()
    structure, _ = complex_
    arrays = [
        force_field_jobs.Bench(molecule_of(structure, ForceFieldOptions(charges)), 1.0, 0.0)
        .match_job().arrays for charges in ("none", "am1-bcc")
    ]  # fmt: skip
    without, whole = map(worker.make_system, arrays)
    counts = []
    for system in (without, whole):
        forces = {type(force): force for force in system.getForces()}
        counts.append(
            (
                system.getNumParticles(),
                forces[openmm.HarmonicBondForce].getNumBonds(),
                forces[openmm.HarmonicAngleForce].getNumAngles(),
                forces[openmm.PeriodicTorsionForce].getNumTorsions(),
            )
        )
    assert (np.array(counts[1]) - counts[0]).tolist() == [5, 4, 6, 0]
    nonbonded = next(f for f in whole.getForces() if isinstance(f, openmm.NonbondedForce))
    charges = [nonbonded.getParticleParameters(k)[0]._value for k in range(157, 162)]
    assert charges == pytest.approx([-0.4, 0.1, 0.1, 0.1, 0.1])
    moving = worker.make_system(arrays[1], moves=True)
    assert (
        moving.getNumConstraints() - worker.make_system(arrays[0], moves=True).getNumConstraints()
        == 4
    )


# Systems for MD


def run_a_picosecond(system, positions):
    context = openmm.Context(
        system,
        openmm.LangevinMiddleIntegrator(300.0, 1.0, 0.001),
        openmm.Platform.getPlatform("CPU"),
    )
    context.setPositions(positions)
    context.getIntegrator().step(1000)
    return context.getState(getEnergy=True).getPotentialEnergy()._value


def energy_of(system, positions):
    platform = openmm.Platform.getPlatform("Reference")
    context = openmm.Context(system, openmm.VerletIntegrator(0.001), platform)
    context.setPositions(positions)
    return context.getState(getEnergy=True).getPotentialEnergy()._value


def in_vacuum(system):
    """Without implicit water and without a cut-off, as GROMACS and AMBER have it."""
    bare = openmm.XmlSerializer.clone(system)
    names = [type(force).__name__ for force in bare.getForces()]
    bare.removeForce(names.index("GBSAOBCForce"))
    bare.getForce(names.index("NonbondedForce")).setNonbondedMethod(0)
    return bare


def exported(complex_, folder, to):
    structure, frames = complex_
    return export(structure, frames[1:], [3, 17], folder, to, ForceFieldOptions())


def system_in(folder):
    return openmm.XmlSerializer.deserialize((folder / "system.xml").read_text())


def test_openmm_runs_what_is_written(tools, complex_, tmp_path):
    tools()
    found = exported(complex_, tmp_path / "md", "openmm")
    names = [file.rpartition("/")[2] for file in found.files]
    assert names == ["frame-0003.pdb", "frame-0017.pdb", "system.xml"]
    with pytest.raises(pliant.FileError, match=r"system.xml: exists; --overwrite replaces it"):
        exported(complex_, tmp_path / "md", "openmm")
    pdb = app.PDBFile(str(tmp_path / "md" / "frame-0017.pdb"))
    atoms = [atom.name for atom in pdb.topology.atoms()][-5:]
    assert (atoms, found.atoms) == (["C1", "H11", "H12", "H13", "H14"], 162)
    system = system_in(tmp_path / "md")
    arrays = force_field_jobs.Bench(
        molecule_of(complex_[0], ForceFieldOptions()), 1.0, 0.0).match_job().arrays  # fmt: skip
    ours = energy_of(worker.make_system(arrays), pdb.positions)
    assert energy_of(system, pdb.positions) == pytest.approx(ours, rel=1e-6)
    assert run_a_picosecond(system, pdb.positions) < 0


def test_amber_and_gromacs_have_the_same_energies(tools, complex_, tmp_path):
    pytest.importorskip("parmed")
    tools()
    for to in ("openmm", "amber", "gromacs"):
        exported(complex_, tmp_path, to)
    vacuum = in_vacuum(system_in(tmp_path))
    amber = app.AmberPrmtopFile(str(tmp_path / "system.prmtop"))
    places = app.AmberInpcrdFile(str(tmp_path / "frame-0003.inpcrd")).positions
    system = amber.createSystem(nonbondedMethod=app.NoCutoff)
    assert energy_of(system, places) == pytest.approx(energy_of(vacuum, places), rel=1e-4)
    assert np.isfinite(run_a_picosecond(system, places))
    gromacs = app.GromacsTopFile(str(tmp_path / "system.top"))
    places = app.GromacsGroFile(str(tmp_path / "frame-0003.gro")).positions
    system = gromacs.createSystem(nonbondedMethod=app.NoCutoff)
    assert energy_of(system, places) == pytest.approx(energy_of(vacuum, places), rel=1e-4)
    assert np.isfinite(run_a_picosecond(system, places))


def test_without_parmed_the_error_says_what_to_install(complex_, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "parmed", None)
    with pytest.raises(
        ImportError, match=r'--to amber needs ParmEd: pip install "pliant\[export\]"'
    ):
        exported(complex_, tmp_path, "amber")


# By AmberTools itself


@pytest.fixture
def amber():
    try:
        ambertools.programs()
    except pliant.InputError as missing:
        pytest.skip(str(missing))


def sampled(name):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", pliant.PliantWarning)
        return pliant.sample(DATA / name, 3, all_hydrogens=True, fill_side_chains=True)


@pytest.mark.long
@pytest.mark.parametrize(
    ("name", "ligands"),
    [("1hvr.pdb", ["A:XK2263"]), ("4E43.pdb", []), ("1a28.pdb.gz", ["A:STR1", "B:STR2"])],
)
def test_all_of_a_complex_is_in_the_force_field(amber, name, ligands):
    found = sampled(name)
    report = minimise_frames(
        found.model.structure, np.array(found.model.positions), found.positions, Wanted("all")
    )
    assert (report.left_out, report.ligands, report.why_not) == ({}, ligands, "")
    by_name = {finding.name: finding.status for finding in findings_of(report)}
    assert by_name.get("starts_ligands", PASSED) == PASSED
    assert by_name.get("starts_strain", PASSED) == PASSED
    for one in report.frames:
        assert all(each.contacts < -50 for each in one.ligands.values())


@pytest.mark.long
@pytest.mark.parametrize("name", ["1hvr.pdb", "1a28.pdb.gz"])
def test_gromacs_has_our_energy_and_runs(amber, tmp_path, name):
    pytest.importorskip("parmed")
    if shutil.which("gmx") is None:
        pytest.skip("gmx is not on the PATH")
    found = sampled(name)
    for to in ("openmm", "gromacs"):
        options = ForceFieldOptions()
        export(found.model.structure, found.positions[:1], [0], tmp_path, to, options)
    box = "editconf -f frame-0000.gro -o big.gro -box 30 30 30 -c"
    no_cut = "rlist=14;rcoulomb=14;rvdw=14;coulombtype=Cut-off;coulomb-modifier=None"
    no_cut += ";vdw-modifier=None;nstenergy=1;verlet-buffer-tolerance=-1;pbc=xyz"
    usual = "integrator=md;dt=0.001;nsteps=1000;gen-vel=yes;nstenergy=100;pbc=xyz"
    gmx(tmp_path, box)
    for name, settings in (("one", f"integrator=md;nsteps=0;{no_cut}"), ("run", usual)):
        (tmp_path / f"{name}.mdp").write_text(settings.replace(";", "\n") + "\n")
        gmx(tmp_path, f"grompp -f {name}.mdp -c big.gro -p system.top -o {name}.tpr -maxwarn 5")
        gmx(tmp_path, f"mdrun -deffnm {name} -ntmpi 1 -ntomp 1 -nb cpu")
    text = gmx(tmp_path, "energy -f one.edr -dp", "Potential\n")
    theirs = float(next(k for k in text.splitlines() if k.startswith("Potential")).split()[1])
    places = app.GromacsGroFile(str(tmp_path / "big.gro")).positions
    assert theirs == pytest.approx(energy_of(in_vacuum(system_in(tmp_path)), places), rel=1e-4)


def gmx(folder, words, text=""):
    done = subprocess.run(
        ["gmx", "-quiet", *words.split()], cwd=folder, input=text, text=True, capture_output=True
    )
    assert done.returncode == 0, done.stderr
    return done.stdout
