# SPDX-License-Identifier: MIT
"""Results with frames are sequences, can be saved, and connect, whether in memory or in a file."""

from pathlib import Path

import numpy as np
import pytest
from h5md_contents import stored

import pliant

DATA = Path(__file__).parents[3] / "data" / "molecules"
pytestmark = pytest.mark.filterwarnings(
    "ignore:frames reach an amplitude", "ignore:no bond can rotate", "ignore:select. .* bonds"
)
PEPTIDE = DATA / "alanine_dipeptide.pdb"
FRAMES = 6


def sampled(folder):
    return pliant.sample(PEPTIDE, frames=FRAMES, seed=1)


def sampled_to_a_file(folder):
    return pliant.sample(PEPTIDE, frames=FRAMES, seed=1, output=folder / "out.h5md")


def file_of_a_sample(folder):
    sampled_to_a_file(folder)
    return pliant.Trajectory(folder / "out.h5md")


def ran(folder):
    return pliant.run(PEPTIDE, steps=FRAMES - 1, seed=1)


def ran_to_a_file(folder):
    return pliant.run(PEPTIDE, steps=FRAMES - 1, seed=1, output=folder / "out.h5md")


def ran_to_models(folder):
    return pliant.run(PEPTIDE, steps=FRAMES - 1, seed=1, output=folder / "out.pdb")


def went_on(folder):
    pliant.run(PEPTIDE, steps=2, seed=1, output=folder / "out.h5md")
    return pliant.continue_run(folder / "out.h5md", FRAMES - 1)


def sampled_on(folder):
    pliant.sample(PEPTIDE, frames=2, seed=1, output=folder / "out.h5md")
    return pliant.continue_sample(folder / "out.h5md", FRAMES)


def part_of_a_file(folder):
    ran_to_a_file(folder)
    return pliant.Trajectory(folder / "out.h5md")[:]


def found(folder):
    start = DATA / "peptide_20.pdb"
    return pliant.path(start, pliant.sample(start, frames=1, seed=4)[:])


RESULTS = (
    sampled, sampled_to_a_file, file_of_a_sample, ran, ran_to_a_file, ran_to_models, went_on,
    sampled_on, part_of_a_file, found,
)  # fmt: skip


@pytest.fixture(params=RESULTS, ids=lambda make: make.__name__)
def result(request, tmp_path):
    return request.param(tmp_path)


def test_a_result_is_a_sequence_of_frames(result):
    count = len(result.positions)
    assert len(result) == count >= 2
    assert result.positions.shape == (count, len(result.structure), 3)
    assert np.array_equal(np.array(list(result)), result.positions)
    assert np.array_equal(result[-1], result.positions[count - 1])
    assert np.array_equal(result[np.int64(1)], result.positions[1])
    with pytest.raises(IndexError, match=f"frame {count}: there are {count}, numbered from 0"):
        result[count]


def test_a_slice_is_a_trajectory(result):
    part = result[1::2]
    assert isinstance(part, pliant.Trajectory)
    assert np.array_equal(part.positions, result.positions[1::2])
    assert np.array_equal(part[:1].positions, result.positions[1:2])
    mask = np.arange(len(result)) > 0
    assert np.array_equal(result[mask].positions, result.positions[1:])
    assert np.array_equal(result[[1, 0]].positions, result.positions[[1, 0]])
    assert part.structure.names.tolist() == result.structure.names.tolist()


#: endings that convert knows, with how near positions are kept, Angstrom
KEPT = {
    ".h5md": 0, ".pdb": 5e-4, ".cif": 5e-6, ".sdf": 5e-5, ".xyz": 1e-5, ".dcd": 1e-5, ".xtc": 6e-3,
    ".trr": 1e-5,
}  # fmt: skip


@pytest.mark.parametrize("ending", KEPT)
def test_a_result_is_saved_in_any_format(ending, tmp_path):
    pytest.importorskip("MDAnalysis")
    pytest.importorskip("rdkit")
    ensemble = sampled(tmp_path)
    path = ensemble.save(tmp_path / f"saved{ending}")
    topology = PEPTIDE if ending in (".dcd", ".xtc", ".trr") else None
    back = pliant.Trajectory(path, topology=topology)
    assert len(back) == FRAMES
    assert np.abs(back.positions - ensemble.positions).max() <= KEPT[ending]
    with pytest.raises(pliant.FileError, match="exists"):
        ensemble.save(path)
    assert pliant.convert(ensemble, path, overwrite=True, every=2).frames == FRAMES / 2


def test_the_file_that_a_sample_in_memory_saves_is_that_of_its_output(tmp_path):
    kept, written = tmp_path / "kept.h5md", tmp_path / "written.h5md"
    for options in ({"frames": 4}, {"frames": 4, "sampler": "dilute"}):
        for path in (kept, written):
            path.unlink(missing_ok=True)
        pliant.sample(DATA / "peptide_20.pdb", output=written, **options).save(kept)
        assert without_times(kept) == without_times(written)


def without_times(path):
    return {name: value for name, value in stored(path).items() if "second" not in name}


def numbers_of(report):
    found = report.as_json()
    return {name: found[name] for name in found if name not in ("input", "outputs", "notes")}


def test_an_ensemble_in_memory_is_analysed_as_its_file_is(tmp_path):
    pytest.importorskip("MDAnalysis")
    ensemble = pliant.sample(DATA / "peptide_20.pdb", frames=8, output=tmp_path / "out.h5md")
    of_file = numbers_of(pliant.analyse(tmp_path / "out.h5md"))
    assert numbers_of(pliant.sample(DATA / "peptide_20.pdb", frames=8).analyse()) == of_file
    assert numbers_of(pliant.analyse(ensemble)) == of_file
    assert len(ensemble[2:].analyse().analysis.frames) == 6


def test_frames_of_a_file_are_read_when_they_are_asked_for(tmp_path, monkeypatch):
    written = ran_to_a_file(tmp_path)
    read = []
    positions = pliant.H5mdReader.positions

    class Reader:
        def __init__(self, path):
            self.reader = pliant.H5mdReader(path)

        def positions(self, frame):
            read.append(frame)
            return positions(self.reader, frame)

        def __len__(self):
            return len(self.reader)

        def __getattr__(self, name):
            return getattr(self.reader, name)

    monkeypatch.setattr("pliant._core.H5mdReader", Reader)
    part = written[2:5]
    assert read == []
    _ = part[1]
    assert read == [3]


def test_frames_of_a_long_run_are_not_kept(monkeypatch):
    monkeypatch.setattr("pliant.trajectory.results.MOST_KEPT", 1000)
    done = pliant.run(PEPTIDE, steps=4)
    assert done.steps == 4
    with pytest.raises(pliant.InputError, match=r'pliant\.run\(\.\.\., output="run\.h5md"\)'):
        len(done)


def test_a_run_of_a_framework_has_frames():
    structure = pliant.read(PEPTIDE)
    done = pliant.run(structure.framework(), structure.positions, steps=2)
    assert len(done) == 3
    assert len(done.structure) == len(structure)


def test_frames_that_are_not_of_the_molecule_are_refused():
    with pytest.raises(pliant.InputError, match=r"positions: 2 atoms, but .* has 22"):
        pliant.Trajectory(PEPTIDE, np.zeros((4, 2, 3)))
    with pytest.raises(pliant.InputError, match=r"expected shape \(N, 3\) or \(F, N, 3\)"):
        pliant.Trajectory(PEPTIDE, np.zeros(3))


def test_representatives_are_chosen_of_a_file(tmp_path):
    pytest.importorskip("MDAnalysis")
    ensemble = pliant.sample(PEPTIDE, frames=FRAMES, output=tmp_path / "out.h5md")
    chosen = pliant.representatives(tmp_path / "out.h5md", 2)
    assert len(chosen.frames) == 2
    assert pliant.representatives(ensemble, 2).frames.tolist() == chosen.frames.tolist()
    with pytest.raises(pliant.InputError, match=r"pliant\.representatives\(pliant\.sample\("):
        pliant.representatives(ensemble.structure, 2)


def test_analyse_compares_with_the_topology_that_sample_writes(tmp_path, monkeypatch):
    """`pliant sample x.pdb` writes x.h5md and x-topology.pdb: x.pdb has other atoms."""
    import subprocess

    from pliant.base.console import command_path
    from pliant.base.output_names import start_beside

    pytest.importorskip("MDAnalysis")
    monkeypatch.chdir(tmp_path)
    structure = pliant.read(DATA / "peptide_20.pdb").select("not element H")
    pliant.write_topology_pdb("x.pdb", structure)
    subprocess.run([command_path(), "sample", "x.pdb", "--frames", "8", "--quiet"], check=True)
    assert start_beside("x.h5md") == Path("x-topology.pdb")
    found = pliant.analyse("x.h5md")
    notes = " ".join(found.as_json().get("notes", []))
    assert "not compared" not in notes
    from pliant.measure.stages.reference import reference_of

    assert reference_of(found.analysis).name == "x-topology.pdb"
