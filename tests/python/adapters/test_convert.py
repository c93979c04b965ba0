# SPDX-License-Identifier: MIT
"""pliant convert: MDAnalysis and gemmi read back what was recorded, to a format's digits."""

import subprocess
import sys
from pathlib import Path

import gemmi
import MDAnalysis
import numpy as np
import pliant.mdanalysis
import pytest
from h5md_contents import positions_in
from pliant.adapters.convert.command import main

from pliant import convert

MOLECULE = str(Path(__file__).parents[3] / "data/molecules/alanine_dipeptide.pdb")

WITHOUT_MDANALYSIS = """
import sys
class Hidden:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] == "MDAnalysis":
            raise ModuleNotFoundError(f"No module named {name!r}", name=name)
sys.meta_path.insert(0, Hidden())
from pliant.adapters.convert.command import main
sys.exit(main(sys.argv[1:]))
"""

#: Largest difference of a coordinate, Angstrom: half of the last digit, or a 32-bit float.
DIGITS = {
    ".pdb": 5.01e-4,
    ".dcd": 4e-6,
    ".xtc": 5.01e-3,
    ".trr": 4e-6,
    ".xyz": 9e-6,
    ".cif": 5.01e-6,
}


@pytest.fixture(scope="module")
def recorded(tmp_path_factory):
    path = tmp_path_factory.mktemp("recorded") / "run.h5md"
    source = pliant.read(MOLECULE)
    pliant.run(source, output=path, steps=6)
    return path


def with_mdanalysis(path, topology):
    source = [str(path)] if path.suffix in (".pdb", ".xyz") else [topology, str(path)]
    universe = MDAnalysis.Universe(*source)
    return np.array([step.positions.astype(float) for step in universe.trajectory])


@pytest.mark.parametrize("ending", [".pdb", ".dcd", ".xtc", ".trr", ".xyz"])
def test_mdanalysis_reads_the_positions_back(recorded, tmp_path, ending):
    done = convert(recorded, tmp_path / f"out{ending}")
    assert (done.frames, done.atoms) == (7, 22)
    found = with_mdanalysis(tmp_path / f"out{ending}", MOLECULE)
    assert np.abs(found - positions_in(recorded)).max() < DIGITS[ending]


@pytest.mark.parametrize("ending", [".xtc", ".trr"])
def test_times_are_kept(recorded, tmp_path, ending):
    path = tmp_path / f"out{ending}"
    convert(recorded, path, every=2)
    reader = pliant.H5mdReader(recorded)
    times = [reader.time(frame) for frame in range(0, len(reader), 2)]
    universe = MDAnalysis.Universe(MOLECULE, str(path))
    assert [step.time for step in universe.trajectory] == pytest.approx(times)


def test_gemmi_reads_models_names_and_positions(recorded, tmp_path):
    path = tmp_path / "out.pdb"
    convert(recorded, path)
    models = gemmi.read_structure(str(path))
    found = [[[*atom.atom.pos.tolist()] for atom in model.all()] for model in models]
    assert np.abs(np.array(found) - positions_in(recorded)).max() < DIGITS[".pdb"]
    source = gemmi.read_structure(MOLECULE)
    names = [
        [(one.residue.name, one.atom.name, one.atom.element.name) for one in model.all()]
        for model in (source[0], models[0])
    ]
    assert names[0] == names[1]


@pytest.fixture(scope="module")
def odd(tmp_path_factory):
    """A trajectory of a nucleotide with primes, a ligand, insertion codes and B factors."""
    path = tmp_path_factory.mktemp("odd") / "odd.pdb"
    lines = (
        ("ATOM", "N", "ALA", "A", "5 ", (0, 0, 0), 11.5, "N"),
        ("ATOM", "CA", "ALA", "A", "5 ", (1.458, 0, 0), 12.25, "C"),
        ("ATOM", "N", "GLY", "A", "5B", (2.5, 3, 0), 13, "N"),
        ("ATOM", "O5'", "DA", "B", "1 ", (9, 0, 0.00123), 0, "O"),
        ("HETATM", 'C1"', "data_", "C", "-3 ", (0, 9.5, 20), 99, "C"),
    )
    text = "".join(
        f"{kind:<6}{k:>5} {name:<4} {residue[:3]:>3} {chain}{number[:-1]:>4}{number[-1]}   "
        f"{x:8.3f}{y:8.3f}{z:8.3f}{1:6.2f}{b:6.2f}          {element:>2}\n"
        for k, (kind, name, residue, chain, number, (x, y, z), b, element) in enumerate(lines, 1)
    )
    path.write_text(text)
    output = path.with_suffix(".h5md")
    pliant.run(pliant.read(path), output=output, steps=2)
    return output


def test_gemmi_reads_mmcif_as_it_was_recorded(odd, tmp_path):
    path = tmp_path / "out.cif"
    assert convert(odd, path).frames == 3
    models = gemmi.read_structure(str(path))
    found = np.array([[[*one.atom.pos.tolist()] for one in model.all()] for model in models])
    assert np.abs(found - positions_in(odd)).max() < DIGITS[".cif"]
    read = [
        (
            one.chain.name,
            one.residue.name,
            str(one.residue.seqid),
            one.atom.name,
            one.atom.element.name,
            one.residue.het_flag,
            one.residue.label_seq,
        )
        for one in models[2].all()
    ]
    assert read == [
        ("A", "ALA", "5", "N", "N", "A", 1),
        ("A", "ALA", "5", "CA", "C", "A", 1),
        ("A", "GLY", "5B", "N", "N", "A", 2),
        ("B", "DA", "1", "O5'", "O", "A", 1),
        ("C", "dat", "-3", 'C1"', "C", "H", None),
    ]


def test_our_reader_finds_the_models_of_mmcif(recorded, tmp_path):
    convert(recorded, tmp_path / "out.cif", every=3)
    source = pliant.H5mdReader(recorded).structure()
    for model, frame in enumerate((0, 3, 6), 1):
        found = pliant.read(tmp_path / "out.cif", model=model)
        assert np.abs(found.positions - positions_in(recorded)[frame]).max() < DIGITS[".cif"]
        for name in ("names", "residue_names", "residue_ids", "chains", "elements"):
            assert getattr(found, name).tolist() == getattr(source, name).tolist()


def test_our_reader_finds_models_and_bonds(recorded, tmp_path):
    path = tmp_path / "out.pdb"
    convert(recorded, path)
    source, found = pliant.H5mdReader(recorded).structure(), pliant.read(path, model=1)
    assert found.bonds.tolist() == source.bonds.tolist()
    assert path.read_text().count("\nENDMDL\n") == 7


def test_a_part_of_the_atoms_and_frames(recorded, tmp_path):
    path = tmp_path / "out.xyz"
    assert main([str(recorded), "-o", str(path), "--select", "element N", "--every", "3"]) == 0
    source = pliant.H5mdReader(recorded)
    nitrogens = source.structure().elements == 7
    found = with_mdanalysis(path, None)
    assert np.abs(found - positions_in(recorded)[::3, nitrogens]).max() < DIGITS[".xyz"]


def test_superposed_as_mdanalysis_does(recorded, tmp_path):
    from MDAnalysis.analysis.align import AlignTraj

    path = tmp_path / "out.trr"
    convert(recorded, path, superpose=True)
    found = with_mdanalysis(path, MOLECULE)
    universe = MDAnalysis.Universe(str(recorded))
    AlignTraj(universe, MDAnalysis.Universe(str(recorded)), in_memory=True, weights=None).run()
    expected = universe.trajectory.timeseries(order="fac")
    assert np.abs(found - expected).max() < 1e-4


@pytest.mark.parametrize("ending", [".foo", ""])
def test_other_names_are_refused(recorded, tmp_path, ending, capsys):
    assert main([str(recorded), "-o", str(tmp_path / f"out{ending}")]) == 2
    wanted = (
        "expected a name that ends in .h5md, .h5, .pdb, .ent, .cif, .mmcif, .sdf, .dcd, .xtc, "
        ".trr, .xyz, .zarr\n"
    )
    assert capsys.readouterr().err == f"pliant convert: error: {tmp_path}/out{ending}: {wanted}"


def test_options_of_systems_go_with_to(recorded, tmp_path):
    told = r"^--charges, --ligand, --platform: go with --to openmm, gromacs, amber$"
    with pytest.raises(pliant.OptionError, match=told):
        pliant.convert(recorded, tmp_path / "o.xyz", charges="none")
    with pytest.raises(pliant.OptionError, match=r"^--superpose: does not go with --to$"):
        pliant.convert(recorded, tmp_path / "o", to="openmm", superpose=True)


def test_nothing_is_replaced_or_left_behind(recorded, tmp_path, capsys):
    path = tmp_path / "out.dcd"
    path.write_text("mine")
    assert main([str(recorded), "-o", str(path)]) == 1
    assert capsys.readouterr().err.endswith(f"{path}: exists; --overwrite replaces it\n")
    assert path.read_text() == "mine"
    assert main([str(recorded), "-o", str(path), "--select", "name XYZ", "--overwrite"]) == 2
    assert path.read_text() == "mine"
    assert main([str(recorded), "-o", str(path), "--overwrite", "--quiet"]) == 0
    assert [one.name for one in tmp_path.iterdir()] == ["out.dcd"]


def test_a_position_that_does_not_fit_leaves_no_file(tmp_path):
    far = pliant.Structure([[0.0, 0.0, 0.0], [12000.0, 0.0, 0.0]], elements=[6, 6])
    recorder = pliant.PdbRecorder(tmp_path / "out.pdb", far)
    with pytest.raises(pliant.InputError, match=r"model 1: position of .* does not fit"):
        recorder.record(far.positions)
    del recorder
    assert list(tmp_path.iterdir()) == []


def test_without_mdanalysis_pdb_is_written_and_the_rest_is_named(recorded, tmp_path):
    run = [sys.executable, "-c", WITHOUT_MDANALYSIS, str(recorded), "--superpose", "-o"]
    assert subprocess.run([*run, tmp_path / "out.pdb"], check=False).returncode == 0
    ended = subprocess.run(
        [*run, tmp_path / "out.xtc"], capture_output=True, text=True, check=False
    )
    assert ended.returncode == 2
    assert ended.stderr == (
        'pliant convert: error: writing XTC needs MDAnalysis: pip install "pliant[analysis]"\n'
    )


@pytest.mark.long
def test_a_million_atoms_have_hybrid_36_serials(tmp_path):
    count = 1_000_000
    grid = np.indices((100, 100, 100)).reshape(3, -1).T * 2.0
    structure = pliant.Structure(grid, elements=np.full(count, 18))
    with pliant.PdbRecorder(tmp_path / "out.pdb", structure) as recorder:
        recorder.record(structure.positions)
    found = gemmi.read_structure(str(tmp_path / "out.pdb"))
    last = [atom.atom for atom in found[0].all()][-1]
    assert (last.serial, last.pos.tolist()) == (count, [198.0, 198.0, 198.0])
