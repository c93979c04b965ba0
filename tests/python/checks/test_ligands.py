# SPDX-License-Identifier: MIT
"""Ligands under the force field: their chemistry, parameters, what is refused; systems for MD."""

import sys
import warnings

import numpy as np
import pytest
from fake_ambertools import install, methane
from pliant.base.force_field_options import ForceFieldOptions
from pliant.checks.coverage import Coverage
from pliant.checks.findings import FAILED, PASSED
from pliant.checks.force_field import jobs as force_field_jobs
from pliant.checks.force_field.export import export
from pliant.checks.force_field.minimise import Wanted, minimise_frames
from pliant.checks.force_field.molecule import molecule_of
from pliant.checks.force_field.verdicts import findings_of, md_verdict
from pliant.checks.ligands import ambertools, parameters
from pliant.checks.ligands.chemistry import chemistry_of
from pliant.checks.ligands.guessed_orders import guess_orders

import pliant

MDA = pytest.importorskip("MDAnalysisTests.datafiles")
openmm = pytest.importorskip("openmm")
app = pytest.importorskip("openmm.app")
Chem = pytest.importorskip("rdkit.Chem")
pytest.importorskip("scipy")
worker = pytest.importorskip("pliant.checks.force_field.worker")
from rdkit.Chem import AllChem  # noqa: E402

PEPTIDE = MDA.PDB_small.replace("adk_open.pdb", "adk_open_10res.pdb")
DRUGS = {
    "progesterone": "CC(=O)C1CCC2C3CCC4=CC(=O)CCC4(C)C3CCC12C",
    "caffeine": "Cn1cnc2c1c(=O)n(C)c(=O)n2C",
    "nitrobenzene": "O=[N+]([O-])c1ccccc1",
    "benzonitrile": "N#Cc1ccccc1",
    "adenosine": "Nc1ncnc2c1ncn2C1OC(CO)C(O)C1O",
    "sulfadiazine": "Nc1ccc(S(=O)(=O)Nc2ncccn2)cc1",
    "aspirin": "CC(=O)Oc1ccccc1C(=O)[O-]",
    "dopamine": "[NH3+]CCc1ccc(O)c(O)c1",
    "acetylcholine": "CC(=O)OCC[N+](C)(C)C",
}


def embedded(smiles):
    made = Chem.AddHs(Chem.MolFromSmiles(smiles))
    assert AllChem.EmbedMolecule(made, randomSeed=1) == 0
    AllChem.MMFFOptimizeMolecule(made, "MMFF94s", maxIters=2000)
    return made


def bare(molecule):
    """Only elements, single bonds and places of atoms without hydrogens."""
    made = Chem.RWMol(Chem.RemoveAllHs(molecule))
    for bond in made.GetBonds():
        bond.SetBondType(Chem.BondType.SINGLE)
        bond.SetIsAromatic(False)
    for atom in made.GetAtoms():
        atom.SetFormalCharge(0)
        atom.SetIsAromatic(False)
        atom.SetNoImplicit(True)
        atom.SetNumExplicitHs(0)
    return made.GetMol()


@pytest.mark.parametrize("name", DRUGS)
def test_bond_orders_are_guessed_from_lengths(name):
    molecule = bare(embedded(DRUGS[name]))
    guess_orders(molecule)
    found = Chem.MolToSmiles(Chem.RemoveHs(molecule), isomericSmiles=False)
    assert found == Chem.CanonSmiles(DRUGS[name])


def structure_of(smiles, name="LIG"):
    """Without hydrogens, as in a crystal structure."""
    molecule = Chem.RemoveAllHs(embedded(smiles))
    bonds = [(b.GetBeginAtomIdx(), b.GetEndAtomIdx()) for b in molecule.GetBonds()]
    return pliant.Structure(
        molecule.GetConformer().GetPositions(),
        elements=[atom.GetAtomicNum() for atom in molecule.GetAtoms()],
        names=[f"{atom.GetSymbol()}{k}" for k, atom in enumerate(molecule.GetAtoms())],
        residue_names=[name] * molecule.GetNumAtoms(),
        residue_ids=[1] * molecule.GetNumAtoms(),
        bonds=bonds,
    )


def test_hydrogens_are_placed_in_each_frame_alike():
    part = structure_of(DRUGS["progesterone"])
    found = chemistry_of(part, "LIG1", {})
    assert (found.given, found.molecule.GetNumAtoms(), found.charge) == (23, 53, 0)
    moved = part.positions[:, [1, 2, 0]] + 5  # turned: hydrogens turn with the rest
    whole, turned = found.complete(part.positions), found.complete(moved)
    assert whole[:23].tobytes() == part.positions.tobytes()
    apart = np.linalg.norm(whole[:, None, [1, 2, 0]] + 5 - turned, axis=2).min(axis=1)
    assert np.median(apart) < 1e-6  # RDKit turns methyls by the axes
    assert found.complete(moved).tobytes() == turned.tobytes()


def test_a_smiles_says_more_than_lengths():
    part = structure_of("CC(=O)O")
    assert chemistry_of(part, "LIG1", {}).charge == -1
    assert chemistry_of(part, "LIG1", {"LIG": "CC(=O)O"}).charge == 0
    with pytest.raises(pliant.InputError, match="LIG1: is not 'CCO': expected C2 O1"):
        chemistry_of(part, "LIG1", {"LIG": "CCO"})


@pytest.mark.parametrize(
    ("element", "why"),
    [(26, "GAFF2 has no parameters for Fe"), (5, "GAFF2 has no parameters for B")],
)
def test_metals_and_boron_are_refused(element, why):
    part = structure_of("CC(=O)O")
    elements = part.elements.copy()
    elements[0] = element
    other = pliant.Structure(part.positions, elements=elements, bonds=part.bonds)
    with pytest.raises(pliant.InputError, match=f"LIG1: {why}"):
        chemistry_of(other, "LIG1", {})


def test_odd_electrons_are_refused():
    with pytest.raises(pliant.InputError, match=r"LIG1: expected paired electrons, found 32"):
        chemistry_of(structure_of("CC(=O)O"), "LIG1", {"LIG": "C[C](O)[O]"})


# Parameters


def test_the_key_does_not_depend_on_the_sequence_of_atoms():
    molecule = embedded(DRUGS["caffeine"])
    order = np.random.default_rng(1).permutation(molecule.GetNumAtoms()).tolist()
    shuffled = Chem.RenumberAtoms(molecule, order)
    (text, one), (same, other) = parameters.canonical(molecule), parameters.canonical(shuffled)
    assert text == same
    elements = [[m.GetAtomWithIdx(int(k)).GetAtomicNum() for k in o] for m, o in
                ((molecule, one), (shuffled, other))]  # fmt: skip
    assert elements[0] == elements[1]
    key = parameters.key(text, "am1-bcc", "2.2")
    assert len(key) == 32 == len({*key} | {*range(32 - len({*key}))})
    others = [(text, "gasteiger", "2.2"), (text, "am1-bcc", "2.3"), (text + "C", "am1-bcc", "2.2")]
    assert key not in [parameters.key(*one) for one in others]


def test_parameters_are_kept_where_xdg_says(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    assert parameters.folder() == tmp_path / "pliant" / "ligands"
    monkeypatch.setenv("XDG_CACHE_HOME", "relative")  # which the specification has ignored
    assert parameters.folder().parts[-3:] == (".cache", "pliant", "ligands")


@pytest.fixture
def tools(monkeypatch, tmp_path):
    """Installs programs as `install` does, alone on the PATH but for those of the system."""

    def begin(**scripts):
        folder = install(tmp_path / "amber", methane(), **scripts)
        monkeypatch.setenv("PATH", f"{folder}:/usr/bin:/bin")
        monkeypatch.setattr(ambertools, "BESIDE", str(tmp_path))
        monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
        ambertools.version.cache_clear()
        return folder

    yield begin
    ambertools.version.cache_clear()


def made(say=lambda _: None, smiles="C"):
    return parameters.parameters_of(embedded(smiles), "am1-bcc", "A:LIG1", say)


def test_parameters_are_made_once(tools):
    folder, said = tools(), []
    first = made(said.append)
    assert not first.was_kept
    assert said == ["A:LIG1: 1 atoms without hydrogens get GAFF2 and am1-bcc charges, once"]
    calls = (folder / "calls").read_text()
    again = made()
    assert again.was_kept and again.prmtop == first.prmtop
    assert (folder / "calls").read_text() == calls
    (kept,) = parameters.folder().iterdir()
    kept.write_text("torn")
    assert not made().was_kept


FAULTS = [
    ({"antechamber": None, "sqm": None}, "AmberTools' antechamber, sqm not found: pip install"),
    (
        {"antechamber": "echo 'Fatal Error!'; echo 'Weird atomic valence'; exit 1"},
        "antechamber: exit code 1: Fatal Error! Weird atomic valence",
    ),
    ({"antechamber": "echo nothing"}, "antechamber: nothing"),
    ({"parmchk2": "exit 3"}, "parmchk2: exit code 3: no output"),
    ({"tleap": "echo hello"}, "tleap: expected the version of GAFF2, found 'hello'"),
    (
        {"antechamber": "echo 'Error: the number of electrons is odd (11)'; exit 1"},
        "antechamber: exit code 1: Error: the number of electrons is odd (11)",
    ),
]


@pytest.mark.parametrize(("scripts", "why"), FAULTS)
def test_what_is_wrong_with_ambertools_is_one_line(tools, scripts, why):
    tools(**scripts)
    with pytest.raises(pliant.InputError) as found:
        made()
    assert str(found.value).startswith(f"A:LIG1: {why}")
    assert "\n" not in str(found.value)


def test_a_topology_of_other_atoms_is_refused(tools):
    tools()
    with pytest.raises(pliant.InputError, match="A:LIG1: tleap: expected 8 atoms, found 5"):
        made(smiles="CC")


# With a protein: ten residues of adenylate kinase, and methane beside them


@pytest.fixture(scope="module")
def complex_():
    from expected_warnings import read_without_elements

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
    assert (
        said[-1] == "OpenMM minimises the start and 2 frames, 162 atoms each, on its platform CPU"
    )
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
    assert findings_of(report)[-2].status == FAILED


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
    pdb = app.PDBFile(str(tmp_path / "md" / "frame-0017.pdb"))
    atoms = [atom.name for atom in pdb.topology.atoms()][-5:]
    assert (atoms, found.atoms) == (["C1", "H11", "H12", "H13", "H14"], 162)
    system = system_in(tmp_path / "md")
    arrays = force_field_jobs.Bench(
        molecule_of(complex_[0], ForceFieldOptions()), 1.0, 0.0).match_job().arrays  # fmt: skip
    ours = energy_of(worker.make_system(arrays), pdb.positions)
    assert energy_of(system, pdb.positions) == pytest.approx(ours, rel=1e-6)
    assert run_a_picosecond(system, pdb.positions) < 0


def test_files_that_are_there_are_kept(tools, complex_, tmp_path):
    tools()
    exported(complex_, tmp_path, "openmm")
    with pytest.raises(pliant.FileError, match="exists"):
        exported(complex_, tmp_path, "openmm")


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
