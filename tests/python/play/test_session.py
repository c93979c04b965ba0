# SPDX-License-Identifier: MIT
"""What a person does in the page: steps, pins, undo, bar by bar, and the same by `pliant run`."""

import subprocess
import sys
from pathlib import Path

import h5py
import numpy as np
import pytest
from h5md_contents import positions_in
from real_files import CAFFEINE, PEPTIDE
from wasm_solver import ROOT, Solver, sha1

import pliant

COMMAND = Path(sys.executable).with_name("pliant")


def drag(solver, steps=3, joint=4, force=(900.0, 40.0, -70.0), **more):
    for _ in range(steps):
        reply = solver.ask("pull", forces=[[joint, *force]], **more)
    return reply


def replayed(path, text, tmp_path, *options):
    """Positions of all frames of `pliant run --forces`."""
    forces, out = tmp_path / "forces.txt", tmp_path / "out.h5md"
    forces.write_text(text)
    words = [*"--topology none --overwrite --quiet".split(), *options]
    subprocess.run([COMMAND, "run", path, "--forces", forces, "-o", out, *words], check=False)
    return positions_in(out)


def test_a_pull_is_a_step_of_a_motion_that_is_steered(solver):
    solver.open(CAFFEINE)
    settings = {"technique": "bfs_cycle", "timestep": 0.02, "damping": 0.1}
    solver.ask("settings", **settings)
    structure = pliant.read(str(CAFFEINE))
    structure.perceive_bonds()
    built = pliant.build_model(structure, "bonds")
    steering = pliant.Steering()
    motion = pliant.Motion(built.framework, built.positions, push=[], **settings)
    motion.add(steering)
    motion.start()
    for force in ((30.0, -4.0, 11.0), (-9.0, 0.5, 0.25)):
        steering.pull([(3, force), (7, force)])
        frame = motion.step()
        reply = solver.ask("pull", forces=[[3, *force], [7, *force]])
        assert reply["positions"]["sha1"] == sha1(frame.positions)
        assert (reply["sweeps"], reply["projections"]) == (frame.sweeps, frame.projections)
        assert reply["residual"] == frame.max_residual


def test_what_breaks_and_what_is_left_is_reported_of_each_bar(solver):
    solver.open(CAFFEINE)
    reply = drag(solver, steps=1, whole=True)
    assert max(map(abs, reply["residuals"])) == pytest.approx(reply["residual"], rel=1e-6)
    assert abs(reply["residuals"][reply["worst"]]) == pytest.approx(reply["residual"], rel=1e-6)
    opened = solver.ask("open", name="c.sdf", file=str(CAFFEINE), model="bonds", whole=True)
    bars = np.reshape(opened["bars"], (-1, 2))
    broken = np.flatnonzero(np.abs(reply["broken"]) > 1e-6)
    assert set(broken) == set(np.flatnonzero((bars == 4).any(axis=1)))


def test_a_joint_that_is_pinned_stays(solver):
    start = solver.ask("open", name="p.pdb", file=str(PEPTIDE), model="bonds", whole=True)
    for technique in ("blocks", "bfs_cycle", "newton", "shake", "units", "froda"):
        solver.ask("settings", technique=technique)
        moved = drag(solver, pins=[0, 6, 200], whole=True)
        before, after = (np.reshape(r["positions"], (-1, 3)) for r in (start, moved))
        np.testing.assert_array_equal(after[[0, 6, 200]], before[[0, 6, 200]])
        assert np.linalg.norm(after[4] - before[4]) > 0.05
        assert moved["converged"]
        solver.ask("undo", steps=3)


def test_bar_by_bar_ends_where_a_pull_ends(solver):
    solver.open(PEPTIDE)
    solver.ask("settings", technique="bfs_cycle")
    pulled = drag(solver, steps=1)
    solver.ask("undo")
    shown = solver.ask("resolution", forces=[[4, 900.0, 40.0, -70.0]], whole=True)
    assert sha1(shown["positions"]) == pulled["positions"]["sha1"]
    events, moved = np.reshape(shown["events"], (-1, 4)), np.reshape(shown["moved"], (-1, 2, 3))
    assert len(events) == shown["projections"]
    assert events[-1, 3] + 1 == shown["sweeps"]
    positions = np.reshape(shown["pushed"], (-1, 3))
    for (_, near, far, _), ends in zip(events, moved, strict=True):
        positions[[near, far]] = ends
    np.testing.assert_allclose(positions, np.reshape(shown["positions"], (-1, 3)), atol=1e-5)


def test_what_does_not_go_bar_by_bar_says_so_and_steps(solver):
    solver.open(CAFFEINE)
    solver.ask("settings", technique="newton")
    shown = solver.ask("resolution", forces=[[4, 900.0, 40.0, -70.0]])
    assert shown["events"] is None
    assert shown["why"] == "on_bar: technique newton does not go bar by bar; orderings do"
    assert shown["step"] == 1
    assert drag(solver, steps=1)["step"] == 2


def test_the_same_push_with_another_technique_leaves_the_session_as_it_is(solver):
    solver.open(PEPTIDE)
    solver.ask("settings", technique="blocks")
    drag(solver)
    stands = solver.ask("state")
    other = solver.ask("again", technique="newton")
    assert solver.ask("state") == stands
    solver.ask("undo")
    solver.ask("settings", technique="newton")
    assert drag(solver, steps=1)["positions"]["sha1"] == other["positions"]["sha1"]


def test_undo_goes_back_to_the_same_bits(solver):
    solver.open(PEPTIDE)
    hashes = [solver.ask("state")["hash"]]
    for _ in range(4):
        drag(solver, steps=1)
        hashes.append(solver.ask("state")["hash"])
    assert len(set(hashes)) == 5
    assert solver.ask("undo")["step"] == 3
    assert solver.ask("state")["hash"] == hashes[3]
    assert solver.ask("undo", steps=2)["steps"] == 2
    assert solver.ask("state")["hash"] == hashes[1]
    drag(solver, steps=1)
    assert solver.ask("state")["hash"] == hashes[2]


@pytest.mark.parametrize("model", ["bonds", "angles", "protein"])
def test_pliant_run_replays_a_session_to_the_same_bits(solver, tmp_path, model):
    solver.open(PEPTIDE, model)
    solver.ask("settings", tolerance=1e-4, damping=0.2, seed="12", max_sweeps=300)
    drag(solver)
    solver.ask("settings", technique="bfs_cycle", weighting=0.75, timestep=0.015)
    drag(solver, joint=40, pins=[4, 90])
    undone = drag(solver, joint=50)
    solver.ask("undo")
    solver.ask("settings", perturb="force_all", force=3)
    solver.ask("wander", steps=4)
    drag(solver, pins=[])
    last = solver.ask("pull", forces=[])
    assert last["step"] == undone["step"] - 1 + 4 + 3 + 1
    text = solver.ask("forces")["text"]
    assert f"input model {model}\n" in text
    frames = replayed(PEPTIDE, text, tmp_path)  # what it was made for is in the file
    assert len(frames) == last["step"] + 1
    assert sha1(frames[-1]) == last["positions"]["sha1"]


def test_the_text_of_a_session(solver):
    solver.open(CAFFEINE)
    solver.ask("settings", technique="newton")
    solver.ask("pull", forces=[[2, 1, 0.1, -3e-7], [0, 4, 5, 6]], pins=[5])
    solver.ask("wander", steps=2, pins=[])
    solver.ask("wander", steps=1)
    solver.ask("pull", forces=[[2, 7, 8, 9]])
    solver.ask("pull", forces=[[2, 7, 8, 9]])
    heading, structure, *lines = solver.ask("forces")["text"].splitlines()
    assert (heading, structure.split()[0]) == ("pliant-forces 3", "structure")
    assert lines == [
        "joints 24", "bars 25", "input model bonds", "set technique newton", "pin 5",
        "force 2 1 0.1 -3e-07", "force 0 4 5 6", "step", "pin", "wander 3",
        "force 2 7 8 9", "step 2",
    ]  # fmt: skip  # a table: a row a line


def test_several_walkers_leave_the_session_where_it_is(solver):
    solver.open(PEPTIDE)
    stands = solver.ask("state")
    walkers = solver.ask("wander", steps=3, walkers=3)["walkers"]
    assert len({walker["positions"]["sha1"] for walker in walkers}) == 3
    assert solver.ask("state") == stands
    alone = solver.ask("wander", steps=3, last=True)["frames"][-1]
    assert alone["positions"]["sha1"] == walkers[0]["positions"]["sha1"]


def test_walkers_go_on_until_something_else_happens(solver):
    solver.open(PEPTIDE)
    whole = solver.ask("wander", steps=4, walkers=2)["walkers"]
    begun = solver.ask("wander", steps=1, walkers=2)["walkers"]
    on = solver.ask("wander", steps=3, walkers=2, go_on=True)["walkers"]
    for end, first, last in zip(whole, begun, on, strict=True):
        assert first["positions"] != last["positions"] == end["positions"]
    solver.ask("settings", max_sweeps=999)
    anew = solver.ask("wander", steps=1, walkers=2, go_on=True)["walkers"]
    assert [walker["step"] for walker in anew] == [walker["step"] for walker in begun]


REFUSED = [
    ("nonsense", {}, 'no call named "nonsense"'),
    ("settings", {"technique": "bfs_cylce"}, 'did you mean "bfs_cycle"?'),
    ("settings", {"tolerance": -1}, "tolerance = -1: must be positive and finite"),
    ("settings", {"tolerance": "much"}, 'tolerance = "much": expected a number'),
    ("settings", {"max_sweeps": 1.5}, "max_sweeps = 1.5: expected a whole number"),
    ("pull", {"forces": [[1000000, 0, 0, 1]]}, "joint 1000000 of 24 does not exist"),
    ("pull", {"forces": [[1, 0, 0]]}, "forces: expected rows of joint, x, y, z, found [1,0,0]"),
    ("pull", {"forces": [], "pins": [-1]}, "joint -1: expected a whole number from 0"),
    ("pull", {"forces": [], "pins": [99]}, "pinned joint 99 of 24 does not exist"),
    ("pull", {"forces": [[1, None, 0, 0]]}, "request: "),
    ("example", {"name": "nothing"}, 'no example named "nothing"'),
]


@pytest.mark.parametrize(("what", "fields", "message"), REFUSED)
def test_what_is_refused_changes_nothing(solver, what, fields, message):
    solver.open(CAFFEINE)
    stands, settings = solver.ask("state"), solver.ask("settings")
    with pytest.raises(ValueError) as raised:
        solver.ask(what, **fields)
    assert message in str(raised.value)
    assert solver.ask("state") == stands
    assert solver.ask("settings") == settings
    assert drag(solver, steps=1)["step"] == 1


def test_nothing_is_open_at_first(solver):
    assert solver
    with Solver() as fresh, pytest.raises(ValueError, match=r"^nothing is open$"):
        fresh.ask("pull", forces=[])


@pytest.mark.parametrize(
    ("path", "options"),
    [(CAFFEINE, ["--model", "bonds"]), (ROOT / "data/mechanisms/four_bar.xml", [])],
)
def test_a_session_tells_the_parameters_that_pliant_run_records(solver, tmp_path, path, options):
    solver.open(path)
    drag(solver, 2, joint=1, force=(30.0, 1.0, 0.0))
    solver.ask("settings", technique="newton", tolerance_length=1e-4, seed=7)
    drag(solver, 3, joint=2, force=(30.0, 1.0, 0.0))
    parameters = solver.ask("recorded", name=path.name)["parameters"]
    replayed(path, solver.ask("forces")["text"], tmp_path, *options)
    types = {"int64": np.int64, "float64": np.float64, "bool": np.bool_, "text": bytes}
    with h5py.File(tmp_path / "out.h5md") as file:
        rows = []

        def keep(name, item):
            if item.parent.parent.name == "/parameters" and item.shape == ():
                rows.append(name)

        file.visititems(keep)
        expected = {row.removeprefix("parameters/"): file[row][()] for row in rows}
    found = {name: (types[kind], value) for name, kind, value in parameters}
    assert set(found) == set(expected)
    for name, (kind, value) in found.items():
        if name != "run/forces":  # a session replays no file
            text = value.encode() if isinstance(value, str) else value
            assert (text, kind) == (expected[name], type(expected[name])), name
