# SPDX-License-Identifier: MIT
"""Our H5MD files as MDAnalysis and h5py see them."""

import os
import pickle
import random
import signal
import subprocess
import sys
import textwrap
import time
import warnings

import h5py
import MDAnalysis
import numpy as np
import pliant.mdanalysis
import pytest
from MDAnalysis.analysis.rms import RMSF

GLYCINES = """\
ATOM      1  N   GLY A  -1       0.000   0.000   0.000  1.00  0.00           N
ATOM      2  CA  GLY A  -1       1.450   0.000   0.000  1.00  0.00           C
ATOM      3  C   GLY A  -1       2.000   1.420   0.000  1.00  0.00           C
ATOM      4  O   GLY A  -1       1.250   2.400   0.000  1.00  0.00           O
ATOM      5  N   GLY A  -1A      3.330   1.540   0.000  1.00  0.00           N
ATOM      6  CA  GLY A  -1A      3.970   2.850   0.000  1.00  0.00           C
ATOM      7  C   GLY A  -1A      5.480   2.730   0.000  1.00  0.00           C
ATOM      8  O   GLY A  -1A      6.030   1.630   0.000  1.00  0.00           O
TER
HETATM    9 CA    CA B 301      10.000  10.000  10.000  1.00  0.00          CA
HETATM   10  O   HOH A 401      15.000  10.000  10.000  1.00  0.00           O
CONECT    3    4    4
END
"""


@pytest.fixture(scope="module")
def structure():
    return pliant.read_text(GLYCINES, "glycines.pdb")


def positions_at(frame, count):
    """Exact in 32 bits, so that what MDAnalysis holds can be compared bit by bit."""
    rng = np.random.default_rng(frame)
    return (rng.integers(-4000, 4000, size=(count, 3)) / 256).astype(float)


def record(path, structure, frames, **options):
    with pliant.H5mdRecorder(path, structure.framework(), structure=structure, **options) as out:
        for frame in range(frames):
            out.record(
                pliant.Frame(
                    7 * frame,
                    0.5 * frame,
                    positions_at(frame, len(structure)),
                    max_residual=1e-3 * frame,
                    root_joint=frame % 3,
                    stop=pliant.Stop.max_sweeps if frame == 2 else pliant.Stop.converged,
                )
            )
    return path


@pytest.fixture(scope="module")
def trajectory(tmp_path_factory, structure):
    return record(tmp_path_factory.mktemp("h5md") / "out.h5md", structure, 60)


@pytest.fixture
def universe(trajectory):
    with warnings.catch_warnings():
        warnings.simplefilter("error")  # nothing is guessed
        return MDAnalysis.Universe(trajectory)


def in_fresh_python(code, *arguments):
    """What a new Python prints."""
    command = [sys.executable, "-c", textwrap.dedent(code), *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def test_names_come_from_the_file(universe):
    atoms = universe.atoms
    assert atoms.names.tolist() == ["N", "CA", "C", "O"] * 2 + ["CA", "O"]
    assert atoms.elements.tolist() == ["N", "C", "C", "O"] * 2 + ["Ca", "O"]
    assert atoms.types.tolist() == atoms.elements.tolist()
    assert atoms.ids.tolist() == list(range(1, 11))
    assert atoms.masses[[0, 1, 8]] == pytest.approx([14.007, 12.011, 40.078])
    assert atoms.chainIDs.tolist() == ["A"] * 8 + ["B", "A"]
    residues = universe.residues
    assert residues.resnames.tolist() == ["GLY", "GLY", "CA", "HOH"]
    assert residues.resids.tolist() == [-1, -1, 301, 401]
    assert residues.icodes.tolist() == ["", "A", "", ""]
    assert [len(residue.atoms) for residue in residues] == [4, 4, 1, 1]
    assert universe.segments.segids.tolist() == ["A", "B"]
    assert universe.select_atoms("segid A and name CA").indices.tolist() == [1, 5]
    assert universe.select_atoms("protein").n_atoms == 8


def test_bonds_come_from_the_file(universe, structure):
    assert universe.bonds.indices.tolist() == structure.bonds.tolist()
    assert universe.select_atoms("bonded name O").names.tolist() == ["C", "C"]
    orders = {tuple(bond.indices): bond.order for bond in universe.bonds}
    assert orders[2, 3] == 2
    assert not any(bond.is_guessed for bond in universe.bonds)


def test_bonds_found_by_distance_are_called_guessed(tmp_path):
    water = pliant.read_text("3\nwater\nO 0 0 0\nH 0.96 0 0\nH -0.24 0.93 0\n", "water.xyz")
    universe = MDAnalysis.Universe(record(tmp_path / "water.h5md", water, 1))
    assert [bond.is_guessed for bond in universe.bonds] == [True, True]
    assert universe.segments.segids.tolist() == ["SYSTEM"]


def test_frames_are_those_that_were_recorded(universe):
    assert len(universe.trajectory) == 60
    for frame, ts in enumerate(universe.trajectory):
        assert (ts.frame, ts.time, ts.data["step"]) == (frame, 0.5 * frame, 7 * frame)
        assert np.array_equal(ts.positions, positions_at(frame, 10))
        assert ts.data["max_residual"] == 1e-3 * frame
        assert ts.data["converged"] == (frame != 2)
        assert ts.data["root_joint"] == frame % 3
        assert ts.dimensions is None
    assert np.array_equal(universe.trajectory[17].positions, positions_at(17, 10))
    assert np.array_equal(universe.trajectory[-1].positions, positions_at(59, 10))


def test_pickles_and_runs_in_several_processes(universe):
    copy = pickle.loads(pickle.dumps(universe))
    assert copy.atoms.names.tolist() == universe.atoms.names.tolist()
    assert np.array_equal(copy.trajectory[5].positions, positions_at(5, 10))
    serial = RMSF(universe.atoms).run().results.rmsf
    from MDAnalysis.analysis.rms import RMSD

    assert len(serial) == 10
    if not hasattr(RMSD, "get_supported_backends"):
        pytest.skip("MDAnalysis has one process before 2.8")
    one = RMSD(universe).run().results.rmsd
    two = RMSD(universe).run(backend="multiprocessing", n_workers=2).results.rmsd
    assert np.array_equal(one, two)


def test_writes_what_mdanalysis_reads_back(universe, tmp_path):
    with MDAnalysis.Writer(str(tmp_path / "copy.h5md"), universe.atoms.n_atoms) as writer:
        for _ in universe.trajectory[:5]:
            writer.write(universe.atoms)
    copy = MDAnalysis.Universe(tmp_path / "copy.h5md")
    assert np.array_equal(copy.trajectory[4].positions, positions_at(4, 10))
    assert copy.trajectory.ts.data["max_residual"] == 4e-3


def test_what_is_compressed_reads_the_same(tmp_path, structure):
    universe = MDAnalysis.Universe(record(tmp_path / "o.h5md", structure, 3, precision=1e-9))
    assert np.array_equal(universe.trajectory[2].positions, positions_at(2, 10))


def test_a_nameless_framework_has_masses_and_no_names(tmp_path):
    framework = pliant.Framework([(0, 1), (1, 2)], [1.0, 1.0], masses=[1, 2, 3])
    with pliant.H5mdRecorder(tmp_path / "graph.h5md", framework) as recorder:
        recorder.record(pliant.Frame(0, 0.0, np.zeros((3, 3))))
    universe = MDAnalysis.Universe(tmp_path / "graph.h5md")
    assert universe.atoms.masses.tolist() == [1, 2, 3]
    assert not hasattr(universe.atoms, "names")


def foreign_file(path, group):
    with h5py.File(path, "w") as file:
        particles = file.create_group(f"particles/{group}")
        particles.create_group("box").attrs["dimension"] = 3
        for name, values, unit in (
            ("value", np.arange(24.0).reshape(2, 4, 3), "Angstrom"),
            ("time", np.arange(2.0), "ps"),
            ("step", np.arange(2), None),
        ):
            dataset = particles.create_dataset(f"position/{name}", data=values)
            if unit:
                dataset.attrs["unit"] = unit
    return path


@pytest.mark.parametrize("group", ["trajectory", "all"])
def test_a_foreign_file_opens_without_names(tmp_path, group):
    universe = MDAnalysis.Universe(foreign_file(tmp_path / "foreign.h5md", group))
    assert universe.atoms.n_atoms == 4
    assert not hasattr(universe.atoms, "names")
    assert universe.trajectory[1].positions[0].tolist() == [12, 13, 14]


def test_a_damaged_atom_table_is_named(tmp_path, structure):
    path = record(tmp_path / "out.h5md", structure, 1)
    with h5py.File(path, "r+") as file:
        file["parameters/topology/residue_of"][3] = 99
    with pytest.raises(ValueError, match="residue_of: value 3 is 99; expected 0 to 3"):
        MDAnalysis.Universe(path)


@pytest.mark.parametrize(
    "imports", ["import MDAnalysis, pliant.mdanalysis", "import pliant.mdanalysis, MDAnalysis"]
)
def test_importing_pliant_mdanalysis_registers_the_parser(trajectory, imports):
    code = f"{imports}\nimport sys\nprint(MDAnalysis.Universe(sys.argv[1]).atoms.names[1])"
    assert in_fresh_python(code, trajectory) == "CA\n"


def test_opens_without_us(trajectory):
    code = """
        import sys, warnings
        warnings.simplefilter("ignore")
        import MDAnalysis
        universe = MDAnalysis.Universe(sys.argv[1])
        assert "pliant" not in sys.modules
        print(universe.atoms.n_atoms, len([ts for ts in universe.trajectory]))
        """
    assert in_fresh_python(code, trajectory) == "10 60\n"


def test_follows_h5md_as_its_specification_says(trajectory):
    with h5py.File(trajectory) as file:
        assert file["h5md"].attrs["version"].tolist() == [1, 1]
        assert file["h5md/creator"].attrs["name"] == "pliant"
        assert "name" in file["h5md/author"].attrs
        assert file["h5md/modules/units"].attrs["system"] == "SI"
        box = file["particles/trajectory/box"]
        assert box.attrs["dimension"] == 3
        assert box.attrs["boundary"].tolist() == ["none"] * 3
        position = file["particles/trajectory/position"]
        assert position["value"].dtype == np.float64
        assert h5py.check_string_dtype(position["value"].attrs.get_id("unit").dtype).length is None
        for name in file["observables"]:
            assert file["observables"][name]["step"] == position["step"]  # a hard link
            assert file["observables"][name]["value"].shape == (60,)
        for name in ("bars", "bonds"):
            pairs = file["connectivity"][name]
            assert file[pairs.attrs["particles_group"]] == file["particles/trajectory"]
        stops = h5py.check_enum_dtype(file["observables/stop/value"].dtype)
        assert stops["converged"] == 0 and stops["max_sweeps"] == 1
        origins = h5py.check_enum_dtype(file["parameters/topology/bond_origin"].dtype)
        assert origins == {"file": 0, "residue": 1, "link": 2, "distance": 3}


RECORD_FOR_EVER = """
    import itertools, sys, time
    import numpy as np
    import pliant
    framework = pliant.Framework([(0, 1)], [1.0])
    recorder = pliant.H5mdRecorder(sys.argv[1], framework, flush_seconds=float(sys.argv[2]))
    print("ready", flush=True)
    for step in itertools.count():
        recorder.record(pliant.Frame(step, step / 8, np.full((2, 3), step % 1024)))
        print(recorder.committed_frames, flush=True)
        time.sleep(0.0002)
    """


@pytest.mark.parametrize("flush_seconds", [0, 0.001])
@pytest.mark.parametrize("seed", range(4))
def test_a_killed_writer_leaves_every_committed_frame(tmp_path, seed, flush_seconds):
    path = tmp_path / "out.h5md"
    command = [sys.executable, "-c", textwrap.dedent(RECORD_FOR_EVER), path, str(flush_seconds)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as writer:
        assert writer.stdout.readline() == "ready\n"
        first = writer.stdout.readline()
        while int(first) == 0:
            first = writer.stdout.readline()
        time.sleep(random.Random(seed).uniform(0.02, 0.1))
        os.kill(writer.pid, signal.SIGKILL)
        committed = int((first + writer.stdout.read()).split("\n")[-2])
    with h5py.File(path) as file:
        position = file["particles/trajectory/position"]
        steps = position["step"][:]
        assert len(steps) >= committed
        assert np.array_equal(steps, np.arange(len(steps)))
        assert np.array_equal(position["value"][: len(steps), 1, 2], steps % 1024)
        assert len(file["observables/sweeps/value"]) >= len(position["value"]) >= len(steps)
    frames = [ts.frame for ts in MDAnalysis.Universe(path).trajectory]
    assert frames == list(range(len(steps)))


def test_a_file_is_read_while_it_grows(tmp_path, structure):
    path = tmp_path / "out.h5md"
    recorder = pliant.H5mdRecorder(path, structure.framework(), structure=structure)
    for frame in range(3):
        recorder.record(pliant.Frame(frame, frame, positions_at(frame, 10)))
        recorder.flush()
        universe = MDAnalysis.Universe(path)
        assert universe.trajectory[frame].time == frame
        universe.trajectory.close()  # a file that stays open stays as it was when it was opened
    recorder.close()


def test_the_sidecar_names_the_same_atoms(tmp_path, trajectory, structure, universe):
    sidecar = tmp_path / "out.pdb"
    pliant.write_topology_pdb(sidecar, structure)
    other = MDAnalysis.Universe(sidecar, trajectory)
    assert np.array_equal(other.trajectory[7].positions, positions_at(7, 10))
    for name in ("names", "resnames", "resids", "icodes", "chainIDs"):
        assert np.array_equal(getattr(other.atoms, name), getattr(universe.atoms, name)), name
    # MDAnalysis takes symbols as the file has them, in capitals.
    assert [element.title() for element in other.atoms.elements] == list(universe.atoms.elements)
    assert np.array_equal(np.sort(other.bonds.indices, axis=0), universe.bonds.indices)


def test_mdanalysis_opens_a_sidecar_beyond_the_serials_of_five_digits(tmp_path):
    count = 100_010
    atoms = pliant.Structure(
        np.arange(3.0 * count).reshape(count, 3) % 1000,
        elements=[6] * count,
        bonds=[(0, 1), (count - 2, count - 1)],
    )
    with pytest.warns(pliant.PliantWarning, match="bonds of atoms past 99,999 left out"):
        pliant.write_topology_pdb(tmp_path / "big.pdb", atoms)
    universe = MDAnalysis.Universe(tmp_path / "big.pdb")
    assert universe.atoms.ids[-1] == count
    assert universe.bonds.indices.tolist() == [[0, 1]]
