# SPDX-License-Identifier: MIT
"""The reader by which MDAnalysis shows our files, beside its own."""

import pickle
import shutil

import h5py
import MDAnalysis
import numpy as np
import pliant.mdanalysis
import pytest
from MDAnalysis.coordinates.H5MD import H5MDReader, H5MDWriter
from pliant.trajectory.frames_reader import FramesReader
from pliant.trajectory.h5md import FramesOfH5md

theirs = pytest.importorskip("MDAnalysisTests.coordinates.base")

FRAMES, ATOMS = 40, 6


def record(path, frames, **options):
    """Records positions (F, N, 3), a frame each picosecond."""
    count = frames.shape[1]
    bars = [(k, k + 1) for k in range(count - 1)]
    with pliant.H5mdRecorder(path, pliant.Framework(bars, [1.0] * len(bars)), **options) as out:
        for k, positions in enumerate(frames):
            out.record(pliant.Frame(10 * k, float(k), positions, max_residual=k / 8))
    return str(path)


@pytest.fixture(scope="module")
def frames():
    """Exact as 32-bit floats, and as multiples of 1/256."""
    return np.random.default_rng(1).integers(-4000, 4000, (FRAMES, ATOMS, 3)) / 256


@pytest.fixture(scope="module")
def path(tmp_path_factory, frames):
    return record(tmp_path_factory.mktemp("reader") / "out.h5md", frames)


class Reference(theirs.BaseReference):
    """The frames of MDAnalysis' tests, in a file of ours."""

    def __init__(self, path):
        super().__init__()
        self.reader, self.writer, self.ext = FramesReader, H5MDWriter, "h5md"
        self.dimensions, self.volume = None, 0
        start = np.asarray(self.first_frame.positions, float)
        self.trajectory = record(path, np.array([2**k * start for k in range(5)]))


@pytest.mark.filterwarnings("ignore:asel argument to timeseries:DeprecationWarning")
class TestAsMDAnalysisTestsReaders(theirs.MultiframeReaderTest):
    @pytest.fixture
    def ref(self, tmp_path):
        return Reference(tmp_path / "frames.h5md")


@pytest.mark.parametrize("options", [{}, {"precision": 1 / 256}], ids=["plain", "rounded"])
def test_frames_are_those_of_mdanalysis_own_reader(tmp_path, frames, options):
    path = record(tmp_path / "out.h5md", frames, **options)
    ours, own = MDAnalysis.Universe(path), MDAnalysis.Universe(path, format="H5MD")
    assert type(own.trajectory) is H5MDReader
    assert type(ours.trajectory) is FramesReader
    for units in (ours.trajectory.units, own.trajectory.units):
        assert units == {"time": "ps", "length": "Angstrom", "velocity": None, "force": None}
    for mine, other in zip(ours.trajectory, own.trajectory, strict=True):
        assert (mine.positions == other.positions).all()
        assert (mine.time, mine.dimensions) == (other.time, other.dimensions)
        assert {name: mine.data[name] for name in other.data} == other.data


@pytest.mark.parametrize(
    "choice", [slice(None), slice(1, None, 3), slice(None, None, -1), [5, 6, 7, 3, 39, 38]], ids=str
)
def test_frames_in_any_order(path, frames, choice):
    trajectory = MDAnalysis.Universe(path).trajectory
    expected = frames[choice].astype(np.float32)
    assert (np.array([ts.positions.copy() for ts in trajectory[choice]]) == expected).all()
    assert trajectory.frame == 0


def test_frames_that_follow_one_another_are_read_together(path, monkeypatch):
    counts, read = [], FramesOfH5md.read
    monkeypatch.setattr(
        FramesOfH5md, "read", lambda self, few: counts.append(len(few)) or read(self, few)
    )
    for ts in MDAnalysis.Universe(path).trajectory:
        ts.positions += 1  # of this frame alone
    assert counts == [1, 2, 4, 8, 16, 9, 1]  # the last is that of the first frame again


@pytest.mark.parametrize(
    "look",
    [
        lambda ts: ts.data,
        lambda ts: ts.copy().data,
        lambda ts: pickle.loads(pickle.dumps(ts)).data,
        lambda ts: ts.copy_slice([0, 2]).data,
    ],
    ids=["itself", "copy", "pickle", "slice"],
)
def test_numbers_are_read_when_somebody_looks(path, monkeypatch, look):
    asked, numbers = [], FramesOfH5md.numbers
    monkeypatch.setattr(
        FramesOfH5md, "numbers", lambda self, frame: asked.append(frame) or numbers(self, frame)
    )
    trajectory = MDAnalysis.Universe(path, time_offset=100).trajectory
    assert [ts.time for ts in trajectory] == [100 + k for k in range(FRAMES)]
    assert asked == []
    trajectory[7].data["mine"] = 1
    trajectory[9].time = 3.5
    data = look(trajectory.ts)
    assert (data["step"], data["max_residual"]) == (90, 9 / 8)
    assert (data["time"], data["time_offset"], data["mine"]) == (3.5, 100, 1)
    assert asked == [7, 9]


def test_a_copy_keeps_what_was_done_to_the_frame(path):
    universe = MDAnalysis.Universe(path)
    universe.trajectory[3].positions[0] = 1, 2, 3
    for other in (universe.copy(), pickle.loads(pickle.dumps(universe))):
        assert other.atoms.positions[0].tolist() == [1, 2, 3]
        assert next(other.trajectory).frame == 4
    assert universe.trajectory.frame == 3


def test_frames_in_memory_and_of_several_files(path, frames):
    universe = MDAnalysis.Universe(path)
    universe.transfer_to_memory(step=2)
    assert (universe.trajectory.timeseries(order="fac") == frames[::2].astype(np.float32)).all()
    chain = MDAnalysis.Universe(path, [path, path]).trajectory
    assert (chain[FRAMES + 4].positions == frames[4].astype(np.float32)).all()
    assert len(chain) == 2 * FRAMES


def test_what_its_writer_writes_is_read_as_any_other_file(path, frames, tmp_path):
    universe = MDAnalysis.Universe(path)
    with universe.trajectory.Writer(str(tmp_path / "few.h5md"), n_atoms=2) as writer:
        for _ in universe.trajectory[:3]:
            writer.write(universe.atoms[2:4])
        writer.h5md_file.close()  # which it leaves open
    copied = MDAnalysis.Universe(tmp_path / "few.h5md").trajectory
    assert type(copied) is H5MDReader
    assert (copied[2].positions == frames[2, 2:4].astype(np.float32)).all()
    assert copied.ts.data["max_residual"] == 2 / 8


def test_a_file_is_known_by_who_wrote_it(tmp_path, path):
    ours, another = (shutil.copy(path, tmp_path / name) for name in ("ours.h5", "another.h5md"))
    assert MDAnalysis.Universe(ours).atoms.masses.tolist() == [1.0] * ATOMS
    assert type(MDAnalysis.Universe(path, ours).trajectory) is FramesReader
    with h5py.File(another, "r+") as file:
        file["h5md/creator"].attrs["name"] = "another"
    assert type(MDAnalysis.Universe(another).trajectory) is H5MDReader


def test_a_frame_that_cannot_be_read_is_no_end(tmp_path, frames):
    path = record(tmp_path / "out.h5md", frames, precision=1 / 256)
    with h5py.File(path) as file:
        place = file["particles/trajectory/position/value"].id.get_chunk_info(20).byte_offset
    with open(path, "r+b") as file:
        file.seek(place)
        file.write(bytes(8))
    universe = MDAnalysis.Universe(path)
    with pytest.raises(pliant.InputError, match=r"out\.h5md: .*position/value"):
        for _ in universe.trajectory:
            pass
    with pytest.raises(pliant.FileError, match="position/value"):
        universe.trajectory[20]
    assert (universe.trajectory[21].positions == frames[21].astype(np.float32)).all()
