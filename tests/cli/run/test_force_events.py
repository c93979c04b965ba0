# SPDX-License-Identifier: MIT
"""Force files with events: `pliant run --forces` repeats what was done by hand."""

import json

import h5py
import numpy as np
import pytest
from h5md_contents import positions_in

import pliant as library

EVENTS = """pliant-forces 3
set technique bfs_cycle
set damping 0.25
pin 2
force 1 30 -4 11
force 0 1 2 3
step
pin
set timestep 0.02
force 1 -9 0.5 0.25
step
step
set perturb force_all
set seed 4
wander 3
"""

MOLECULE = """
  made by hand

  3  2  0  0  0  0  0  0  0  0999 V2000
    0.0000    0.0000    0.0000 C   0  0
    1.5000    0.0000    0.0000 C   0  0
    2.1000    1.2000    0.0000 O   0  0
  1  2  1  0
  2  3  1  0
M  END
"""


@pytest.fixture
def session(tmp_path):
    (tmp_path / "m.mol").write_text(MOLECULE)
    (tmp_path / "s.txt").write_text(EVENTS)
    return tmp_path


def by_hand():
    """The same with a Motion for each change, in Python."""
    structure = library.read_text(MOLECULE, "m.mol")
    structure.perceive_bonds()
    seen = []

    def go_on(state, pin, steps, pull=(), push=(), **options):
        framework = structure.framework(pin=pin)
        motion = library.Motion(
            framework, state, "bfs_cycle", push=list(push), damping=0.25, **options
        )
        steering = library.Steering()
        steering.pull(pull)
        if not push:
            motion.add(steering)
        if not seen:
            seen.append(motion.start().positions.copy())
        for _ in range(steps):
            seen.append(motion.step().positions.copy())
            steering.release()
        return motion.state

    state = go_on(
        library.State(structure.positions), "element O", 1, [(1, (30, -4, 11)), (0, (1, 2, 3))]
    )
    state = go_on(state, "", 2, [(1, (-9, 0.5, 0.25))], timestep=0.02)
    go_on(state, "", 3, push=["force_all"], timestep=0.02, seed=4)
    return np.array(seen)


def test_a_session_is_repeated_bit_by_bit(pliant, session):
    ended = pliant("run", "m.mol", "--forces", "s.txt", "--json")
    assert ended.code == 0, ended.err
    np.testing.assert_array_equal(positions_in(session / "m.h5md"), by_hand())
    report = json.loads(ended.out)
    assert (report["steps"], report["frames"], report["technique"]) == (6, 7, "bfs_cycle")


@pytest.mark.parametrize(
    ("settings", "relative", "length"),
    [
        ("set tolerance 1e-4\nstep\nset tolerance 1e-8\nstep\n", 1e-4, 0),
        ("set tolerance 1e-8\nstep\n", 1e-6, 0),  # of the start
        ("set tolerance_length 0.001\nstep\nset tolerance_length 0\nstep\n", 1e-6, 0.001),
        ("set tolerance 0.1\nstep\nset tolerance_length 1e-3\nstep\n", 0.1, 0.15),
    ],
)
def test_the_loosest_tolerance_is_recorded(pliant, session, settings, relative, length):
    (session / "s.txt").write_text("pliant-forces 3\n" + settings)
    assert pliant("run", "m.mol", "--forces", "s.txt").code == 0
    with h5py.File(session / "m.h5md") as file:
        run = file["parameters/run"]
        assert run["tolerance"][()] == relative
        assert run["tolerance_length"][()] == pytest.approx(length, rel=1e-9)
        assert run["perturb"][()] == b"events"


OPTIONS = [
    ["--technique", "blocks"],
    ["--steps", "2"],
    ["--seed", "2"],
    ["--walkers", "2"],
    ["--ordering", "s.txt"],
    ["--record-forces", "f.txt"],
]


@pytest.mark.parametrize("options", OPTIONS, ids=lambda options: options[0])
def test_what_the_file_says_is_no_option(pliant, session, options):
    ended = pliant("run", "m.mol", "--forces", "s.txt", *options)
    assert ended.code == 2
    assert f"{options[0]}: s.txt says itself, step by step, what is done" in ended.err
    assert not (session / "m.h5md").exists()


def test_nothing_goes_on_with_it(pliant, session):
    assert pliant("run", "m.mol", "--forces", "s.txt").code == 0
    ended = pliant("run", "--continue", "m.h5md")
    assert ended.code == 1
    assert "m.h5md: its run cannot go on: it follows a force file with events" in ended.err


REFUSED = [
    ("pliant-forces 3\npin 0\n", "s.txt: holds no step"),
    ("pliant-forces 3\nset technique bfs_cylce\nstep\n", "s.txt:2: no technique named"),
    ("pliant-forces 3\nstep\nset weighting 2\n", "s.txt:3: weighting = 2: must be"),
    ("pliant-forces 3\nset colour red\nstep\n", "s.txt:2: no option named"),
    ("pliant-forces 3\nforce C9 1 2 3\nstep\n", "s.txt:2: "),
    ("pliant-forces 2\nstep\n", 's.txt:1: expected "pliant-forces 3", found "pliant-forces 2"'),
    ("pliant-forces 3\ninput model proteen\nstep\n", "s.txt:2: input: no model named"),
    ("pliant-forces 3\ninput colour red\nstep\n", "s.txt:2: input: no option named"),
]


@pytest.mark.parametrize(("text", "message"), REFUSED)
def test_what_is_wrong_is_reported_with_its_line(pliant, session, text, message):
    (session / "s.txt").write_text(text)
    ended = pliant("run", "m.mol", "--forces", "s.txt")
    assert ended.code == 1
    assert message in ended.err
    assert not list(session.glob("m.h5md*"))
