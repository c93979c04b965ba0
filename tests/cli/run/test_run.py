# SPDX-License-Identifier: MIT
import json
import signal
import subprocess
import time

import h5py
import numpy as np
import pytest
from h5md_contents import contents


def test_the_start_is_no_step(tmp_path, pliant):
    graph = tmp_path / "triangle.xml"
    joints = "".join(
        f'<joint id="{n}" x="{x}" y="{y}" z="0"/>'
        for n, x, y in [("a", 0, 0), ("b", 1, 0.5), ("c", 2, 0)]
    )
    bars = "".join(
        f'<bar a="{a}" b="{b}" length="{length}"/>'
        for a, b, length in [("a", "b", 1), ("b", "c", 1), ("a", "c", 3)]
    )
    graph.write_text(f"<graph>{joints}{bars}</graph>")
    words = ["run", graph, "--steps", "20", "--max-sweeps", "10", "--topology", "none"]
    ended = pliant(*words, "-o", tmp_path / "one.h5md")
    assert ended.code == 3
    assert "not converged   20 of 20 steps, and the start\n" in ended.out
    ended = pliant(*words, "-o", tmp_path / "two.h5md", "--walkers", "2")
    assert "not converged   40 of 40 steps, and 2 starts\n" in ended.out


def test_run_says_what_it_did(pliant, ethanol, tmp_path):
    ended = pliant("run", ethanol, "--steps", 20, "--json")
    assert (ended.code, ended.err) == (0, "")
    summary = json.loads(ended.out)
    assert summary["steps"] == 20
    assert summary["frames"] == 21
    assert summary["unconverged_steps"] == 0
    assert 0 < summary["worst_residual"] <= 1e-6
    assert (tmp_path / "ethanol.h5md").exists()
    assert "CONECT" in (tmp_path / "ethanol.pdb").read_text()


def test_every_records_fewer_frames_and_the_last(pliant, ethanol, tmp_path):
    assert pliant("run", ethanol, "--steps", 25, "--every", 10, "-o", "o.h5md").code == 0
    with h5py.File(tmp_path / "o.h5md") as file:
        assert file["particles/trajectory/position/step"][:].tolist() == [0, 10, 20, 25]


def test_every_option_is_recorded(pliant, ethanol, tmp_path):
    pliant("run", ethanol, "-o", "o.h5md", "--steps", 3, "--weighting", 0.75, "--seed", 7)
    with h5py.File(tmp_path / "o.h5md") as file:
        options = file["parameters/run"]
        assert options["weighting"][()] == 0.75
        assert options["seed"].asstr()[()] == "7"
        assert options["technique"].asstr()[()] == "bfs_cycle"


def test_an_unconverged_step_is_recorded_and_reported(pliant, ethanol, tmp_path):
    ended = pliant(
        "run", ethanol, "-o", "o.h5md", "--steps", 5, "--max-sweeps", 1, "--technique", "bfs_cycle"
    )
    assert ended.code == 3
    assert "not converged" in ended.out
    with h5py.File(tmp_path / "o.h5md") as file:
        converged = file["observables/converged/value"][:]
        residual = file["observables/max_residual/value"][:]
    assert not converged.all()
    assert ((residual <= 1e-6) == converged.astype(bool)).all()


def test_outputs_are_not_replaced_unless_asked(pliant, ethanol, tmp_path):
    assert pliant("run", ethanol, "--steps", 2).code == 0
    before = (tmp_path / "ethanol.h5md").read_bytes()
    ended = pliant("run", ethanol, "--steps", 3)
    assert ended.code == 1
    assert ended.err == "pliant: error: ethanol.pdb: exists; --overwrite replaces it\n"
    assert (tmp_path / "ethanol.h5md").read_bytes() == before
    assert pliant("run", ethanol, "--steps", 3, "--overwrite").code == 0


def test_the_input_is_never_an_output(pliant, ethanol, tmp_path):
    (tmp_path / "link.xyz").hardlink_to(ethanol)
    ended = pliant("run", ethanol, "-o", "link.xyz", "--overwrite")
    assert ended.code == 2
    assert "is both input and output" in ended.err
    assert ethanol.read_text().startswith("9\n")


def test_a_pdb_file_runs_where_it_lies(pliant, ethanol, tmp_path):
    assert pliant("run", ethanol, "--steps", 1).code == 0
    (tmp_path / "ethanol.pdb").rename(tmp_path / "molecule.pdb")
    before = (tmp_path / "molecule.pdb").read_bytes()
    assert pliant("run", "molecule.pdb", "--steps", 1).code == 0
    assert (tmp_path / "molecule.h5md").exists()
    assert "CONECT" in (tmp_path / "molecule-topology.pdb").read_text()
    assert (tmp_path / "molecule.pdb").read_bytes() == before


@pytest.mark.parametrize("output", ["missing/o.h5md", "/dev/full"])
def test_an_output_that_cannot_be_written_is_reported(pliant, ethanol, output):
    ended = pliant("run", ethanol, "-o", output, "--topology", "none")
    assert ended.code == 1
    assert output in ended.err


def test_times_that_are_not_finite_are_refused_before_the_start(pliant, ethanol, tmp_path):
    ended = pliant("run", ethanol, "-o", "o.h5md", "--timestep", "1e308")
    assert (ended.code, ended.out) == (2, "")
    assert "the time of 1000 steps is not finite" in ended.err
    assert [path.name for path in tmp_path.iterdir()] == [ethanol.name]


def test_more_steps_than_pushes_is_refused(pliant, ethanol, tmp_path):
    (tmp_path / "pushes.txt").write_text(
        "pliant-forces 3\nset timestep 0.01\nset tolerance 1e-6\nset max_sweeps 10\n"
        "push 2 100 0 0\n"
    )
    ended = pliant("run", ethanol, "--forces", "pushes.txt", "--steps", 2)
    assert ended.code == 2
    assert "--steps: expected at most 1, the pushes in pushes.txt" in ended.err


@pytest.mark.parametrize("technique", ["auto", "bfs_cycle", "random", "shake"])
def test_walkers_do_not_depend_on_how_many_go_together(pliant, ethanol, tmp_path, technique):
    words = ["run", ethanol, "--technique", technique]
    words += "--perturb displacement --steps 12 --every 5 --topology none".split()
    for name, walkers, threads in (("many", 11, 1), ("two", 11, 2), ("few", 2, 2)):
        ended = pliant(*words, "-o", f"{name}.h5md", "--walkers", walkers, "--threads", threads)
        assert ended.code == 0, ended.err
    for walker in range(11):
        many = contents(tmp_path / f"many-{walker}.h5md")
        for name in ("two", "few")[: 2 if walker < 2 else 1]:
            other = contents(tmp_path / f"{name}-{walker}.h5md")
            assert many.keys() == other.keys()
            for dataset, values in many.items():
                np.testing.assert_array_equal(values, other[dataset], err_msg=dataset)


def test_a_walker_without_output_leaves_the_others_theirs(pliant, ethanol, tmp_path):
    (tmp_path / "o-1.h5md").mkdir()
    words = ["-o", "o.h5md", "--walkers", 3, "--threads", 1, "--steps", 5]
    ended = pliant("run", ethanol, *words, "--perturb", "displacement")
    assert ended.code == 1
    assert "o-1.h5md: is a directory" in ended.err
    for walker in (0, 2):
        positions = contents(tmp_path / f"o-{walker}.h5md")["particles/trajectory/position/value"]
        assert len(positions) == 6


def test_interrupt_names_the_files_of_walkers_that_were_begun(command, ethanol, tmp_path):
    words = ["run", ethanol, "-o", "o.h5md", "--walkers", "9", "--threads", "1", "--json"]
    running = subprocess.Popen(
        [command, *words, "--steps", "1000000000", "--every", "1000"],
        cwd=tmp_path,
        stdout=subprocess.PIPE,
        text=True,
    )
    while not (tmp_path / "o-7.h5md").exists():
        time.sleep(0.02)
    running.send_signal(signal.SIGINT)
    out, _ = running.communicate(timeout=900)
    assert running.returncode == 130
    assert json.loads(out)["outputs"] == [f"o-{walker}.h5md" for walker in range(8)]
    for walker in range(8):
        with h5py.File(tmp_path / f"o-{walker}.h5md") as file:
            assert len(file["particles/trajectory/position/step"]) > 0


def test_interrupt_leaves_a_readable_file(command, ethanol, tmp_path):
    running = subprocess.Popen(
        [command, "run", ethanol, "-o", "o.h5md", "--steps", "1000000000"],
        cwd=tmp_path,
        stdout=subprocess.PIPE,
        text=True,
    )
    path = tmp_path / "o.h5md"
    while not path.exists() or path.stat().st_size < 100_000:  # hundreds of frames
        time.sleep(0.02)
    running.send_signal(signal.SIGINT)
    out, _ = running.communicate(timeout=900)
    assert running.returncode == 130
    assert "stopped early" in out
    with h5py.File(tmp_path / "o.h5md") as file:
        position = file["particles/trajectory/position"]
        assert len(position["value"]) == len(position["step"]) > 1
        assert np.isfinite(position["value"][-1]).all()


BARS = """pliant-bars 1
bars bonds
limit 3 8 0 4.5            # a cable from a hydrogen of one end to that of the other
limit 0 8 2.5 inf given -3 7
sterics H H 1.6
"""


def distances(positions, pairs):
    return np.linalg.norm(positions[:, pairs[:, 0]] - positions[:, pairs[:, 1]], axis=2)


def test_limits_of_a_bars_file_are_kept_and_recorded(pliant, ethanol, tmp_path):
    (tmp_path / "bars.txt").write_text(BARS)
    ended = pliant("run", ethanol, "-o", "o.h5md", "--steps", 200, "--bars", "bars.txt")
    assert (ended.code, ended.err) == (0, "")
    with h5py.File(tmp_path / "o.h5md") as file:
        positions = file["particles/trajectory/position/value"][:]
        pairs = file["connectivity/limits"][:]
        assert file["observables/max_limit/value"][:].max() <= 0.01
        assert file["observables/max_overlap/value"][:].max() <= 0.1
        assert file["parameters/input/bars"].asstr()[()] == "bars.txt"
        assert file["parameters/run/tolerance_limit"][()] == 0.01
    assert pairs.tolist() == [[3, 8], [0, 8]]
    lengths = distances(positions, pairs)
    assert lengths[:, 0].max() <= 4.5 + 0.01
    assert lengths[:, 1].min() >= 2.5 - 0.01
    # They are what holds the two ends: without them both are left.
    pliant("run", ethanol, "-o", "free.h5md", "--steps", 200)
    with h5py.File(tmp_path / "free.h5md") as file:
        free = distances(file["particles/trajectory/position/value"][:], pairs)
    assert free[:, 0].max() > 4.51 or free[:, 1].min() < 2.49


def test_a_bars_file_is_no_output(pliant, ethanol, tmp_path):
    (tmp_path / "bars.txt").write_text(BARS)
    ended = pliant("run", ethanol, "--bars", "bars.txt", "-o", "bars.txt", "--overwrite")
    assert ended.code == 2
    assert (tmp_path / "bars.txt").read_text() == BARS


GRAPH = """<graph>
<joint id="a" x="0" y="0" z="0"/><joint id="b" x="1" y="0" z="0"/>
<joint id="c" x="1" y="1" z="0"/><joint id="d" x="0" y="1" z="0.2"/>
<bar a="a" b="b"/><bar a="b" b="c"/><bar a="c" b="d"/>
</graph>"""


@pytest.mark.parametrize(("kept", "bars"), [("bars bonds\n", 4), ("", 1)])
def test_a_bars_file_adds_to_a_graph(pliant, tmp_path, kept, bars):
    (tmp_path / "g.xml").write_text(GRAPH)
    (tmp_path / "bars.txt").write_text(f"pliant-bars 1\n{kept}bar a c\nlimit a d 0.9 1.1\n")
    ended = pliant("run", "g.xml", "-o", "g.h5md", "--steps", 100, "--bars", "bars.txt")
    assert (ended.code, ended.err) == (0, "")
    with h5py.File(tmp_path / "g.h5md") as file:
        positions = file["particles/trajectory/position/value"][:]
        assert len(file["connectivity/bars"]) == bars
    lengths = distances(positions, np.array([[0, 2], [0, 3]]))
    assert np.abs(lengths[:, 0] / np.sqrt(2) - 1).max() <= 1e-6
    assert lengths[:, 1].min() >= 0.89 and lengths[:, 1].max() <= 1.11


def test_only_molecules_have_angles(pliant, tmp_path):
    (tmp_path / "g.xml").write_text(GRAPH)
    (tmp_path / "bars.txt").write_text("pliant-bars 1\nbars angles\n")
    ended = pliant("run", "g.xml", "--bars", "bars.txt")
    assert (ended.code, ended.out) == (1, "")
    assert "bars.txt: bars angles: only molecules have angles" in ended.err
    assert pliant("run", "g.xml", "--bars", "angles").code == 2


def paths_to_one_file(folder):
    """Pairs of names of one file that is not there: the same, by a folder, by links."""
    (folder / "sub").mkdir()
    (folder / "alias").symlink_to(folder / "sub")
    (folder / "dangling.h5md").symlink_to("sub/y.h5md")
    (folder / "chain.h5md").symlink_to("dangling.h5md")
    names = "y y", "y sub/../y", "sub/y alias/y", "dangling sub/y", "chain alias/y"
    return [tuple(f"{name}.h5md" for name in two.split()) for two in names]


@pytest.mark.parametrize("other", ["--record-forces", "--topology"])
@pytest.mark.parametrize("case", range(5))
def test_two_outputs_of_one_name_are_refused(pliant, ethanol, tmp_path, other, case):
    one, two = paths_to_one_file(tmp_path)[case]
    before = sorted(tmp_path.rglob("*"))
    for first, second in ((one, two), (two, one)):
        words = ("run", ethanol, "--steps", 3, "--overwrite", "-o", first, other, second)
        ended = pliant(*words)
        assert (ended.code, ended.out) == (2, "")
        assert "two outputs are this one file" in ended.err
    assert sorted(tmp_path.rglob("*")) == before


def test_an_earlier_trajectory_survives_outputs_that_clash(pliant, ethanol, tmp_path):
    assert pliant("run", ethanol, "--steps", 3, "-o", "x.h5md").code == 0
    good = (tmp_path / "x.h5md").read_bytes()
    (tmp_path / "hard.h5md").hardlink_to(tmp_path / "x.h5md")
    for name in ("x.h5md", "hard.h5md"):
        for option in ("--topology", "--record-forces"):
            ended = pliant("run", ethanol, "--overwrite", "-o", "x.h5md", option, name)
            assert ended.code == 2 and "two outputs are this one file" in ended.err
    assert (tmp_path / "x.h5md").read_bytes() == good


def test_files_are_compared_before_the_molecule_is_read(pliant, tmp_path):
    (tmp_path / "bad.xyz").write_text("no molecule")
    ended = pliant("run", "bad.xyz", "-o", "y.h5md", "--topology", "y.h5md")
    assert ended.code == 2 and "two outputs" in ended.err


@pytest.mark.parametrize("option", ["--forces", "--ordering", "--bars"])
def test_no_output_is_any_input(pliant, ethanol, tmp_path, option):
    (tmp_path / "in.txt").write_text("mine")
    (tmp_path / "link.h5md").hardlink_to(tmp_path / "in.txt")
    for output in ("-o", "--record-forces", "--topology"):
        ended = pliant("run", ethanol, option, "in.txt", output, "link.h5md", "--overwrite")
        assert ended.code == 2 and "link.h5md: is both input and output" in ended.err
    assert (tmp_path / "in.txt").read_text() == "mine"


FOREIGN = {"dcd": "DCD", "xtc": "XTC", "xyz": "XYZ", "DCD": "DCD", "trr": "TRR"}
FOREIGN |= {"nc": "NetCDF", "cif": "mmCIF"}
CONVERTIBLE = ("cif", "dcd", "xtc", "xyz", "trr")


@pytest.mark.parametrize("extension", FOREIGN)
def test_a_name_of_another_format_is_refused(pliant, ethanol, tmp_path, extension):
    ended = pliant("run", ethanol, "--steps", 2, "-o", f"out.{extension}")
    assert (ended.code, ended.out) == (2, "")
    how = f', of which "pliant convert out.h5md -o out.{extension}" makes this one'
    assert ended.err.endswith(
        f"--output out.{extension}: is a name of {FOREIGN[extension]}; trajectories are written as "
        "H5MD or PDB: expected a name such as out.h5md"
        f"{how if extension.lower() in CONVERTIBLE else ''}\n"
    )
    assert [path.name for path in tmp_path.iterdir()] == ["ethanol.xyz"]


@pytest.mark.parametrize("name", ["out.h5md", "out.h5", "out", "out.v2"])
def test_other_names_are_taken(pliant, ethanol, tmp_path, name):
    assert pliant("run", ethanol, "--steps", 2, "-o", name, "--topology", "none").code == 0
    assert (tmp_path / name).read_bytes().startswith(b"\x89HDF")


@pytest.mark.parametrize("option", ["-o", "--topology", "--record-forces", "--forces", "--bars"])
def test_an_empty_name_is_refused(pliant, ethanol, tmp_path, option):
    ended = pliant("run", ethanol, option, "")
    assert (ended.code, ended.out) == (2, "")
    assert 'expected the name of a file, found ""' in ended.err
    assert [path.name for path in tmp_path.iterdir()] == ["ethanol.xyz"]


@pytest.mark.parametrize("command", ["run", "sample"])
def test_a_dry_run_makes_nothing(pliant, ethanol, tmp_path, command):
    before = set(tmp_path.iterdir())
    ended = pliant(command, ethanol, "--dry-run", "--json")
    assert (ended.code, ended.out, ended.err) == (0, "", "")
    assert set(tmp_path.iterdir()) == before


@pytest.mark.parametrize(
    ("command", "words", "code", "message"),
    [
        ("run", ("--technique", "shaek"), 2, 'no choice named "shaek"'),
        ("run", ("--save", "element Q"), 2, "--save"),
        ("sample", ("--model", "protien"), 2, 'did you mean "protein"?'),
        ("run", ("--forces", "none.txt"), 1, "none.txt"),
    ],
)
def test_a_dry_run_reports_what_is_bad(pliant, ethanol, command, words, code, message):
    ended = pliant(command, ethanol, *words, "--dry-run")
    assert (ended.code, ended.out) == (code, "")
    assert message in ended.err


@pytest.mark.parametrize("command", ["run", "sample"])
def test_a_run_that_would_go_on_stays_as_it_is(pliant, ethanol, tmp_path, command):
    more = {"run": ("--steps", 3), "sample": ("--frames", 3)}[command]
    assert pliant(command, ethanol, "-o", "a.h5md", *more).code == 0
    before = (tmp_path / "a.h5md").read_bytes()
    further = (more[0], 9)
    ended = pliant(command, "--continue", "a.h5md", *further, "--dry-run")
    assert (ended.code, ended.out) == (0, "")
    assert (tmp_path / "a.h5md").read_bytes() == before
