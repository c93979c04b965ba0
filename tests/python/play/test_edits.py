# SPDX-License-Identifier: MIT
"""Why a pull is held, and what a person cuts and adds: the same by `pliant run`."""

import h5py
import numpy as np
import pytest
from test_session import CAFFEINE, PEPTIDE, drag, replayed
from wasm_solver import sha1


def first_contact(solver):
    opened = solver.ask("open", name="p.pdb", file=str(PEPTIDE), model="protein", whole=True)
    return opened["contacts"][:2]


def test_pliant_run_replays_edits_to_the_same_bits(solver, tmp_path):
    a, b = first_contact(solver)
    drag(solver)
    solver.ask("edit", edits=[["cut", a, b]])
    drag(solver, joint=a)
    length = solver.ask("pair", a=10, b=70)["distance"] + 0.05
    solver.ask("edit", edits=[["bar", 4, 90], ["bar", 10, 70, length]])
    drag(solver, joint=b, force=(9.0, 4.0, -7.0))
    solver.ask("edit", edits=[["cut", 4, 90]])
    solver.ask("undo")
    solver.ask("edit", edits=[["restore", a, b]])
    last = drag(solver, force=(9.0, 4.0, -7.0))
    frames = replayed(PEPTIDE, solver.ask("forces")["text"], tmp_path)
    assert len(frames) == last["step"] + 1 == 13
    assert sha1(frames[-1]) == last["positions"]["sha1"]
    assert np.linalg.norm(frames[-1][10] - frames[-1][70]) == pytest.approx(length, abs=1e-3)
    told = {row[0]: row[2] for row in solver.ask("recorded", name=PEPTIDE.name)["parameters"]}
    with h5py.File(tmp_path / "out.h5md") as file:
        recorded = file["parameters/run/edits"][()].decode()
    assert recorded == told["run/edits"]
    steps = [text.split(":")[0] for text in recorded.split("; ")]
    assert steps == ["after step 3", "after step 6", "after step 6", "after step 9"]


def test_undo_takes_edits_back_in_their_order(solver):
    a, b = first_contact(solver)
    stands = [solver.ask("state")["hash"]]
    whole = len(solver.ask("edited", whole=True)["contacts"])
    solver.ask("edit", edits=[["cut", a, b]])
    drag(solver, 1)
    stands.append(solver.ask("state")["hash"])
    solver.ask("edit", edits=[["restore", a, b]])
    drag(solver, 1)
    assert solver.ask("undo")["edited"] is False
    assert solver.ask("undo")["edited"] is True
    assert solver.ask("state")["hash"] == stands[1]
    assert len(solver.ask("edited", whole=True)["contacts"]) == whole - 2
    assert solver.ask("undo", steps=2)["edited"] is True
    assert solver.ask("state")["hash"] == stands[0]
    assert len(solver.ask("edited", whole=True)["contacts"]) == whole
    assert solver.ask("edited")["changes"] == []


def test_an_edit_tells_which_techniques_and_clusters_there_are(solver):
    opened = solver.ask("open", name="c.sdf", file=str(CAFFEINE), model="bonds", whole=True)
    bars = np.reshape(opened["bars"], (-1, 2)).tolist()
    edited = solver.ask("edit", edits=[["cut", *bars[0]]], whole=True)
    assert np.reshape(edited["bars"], (-1, 2)).tolist() == bars[1:]
    assert drag(solver, whole=True)["residuals"].__len__() == len(bars) - 1
    assert set(edited["unfit"]) <= set(opened["unfit"])


REFUSED = [
    ([["cut", 0, 9999]], "joint 9999 of 24 does not exist"),
    ([["cut", 0]], 'edits: expected rows of a word and two joints, found ["cut",0]'),
    ([["bend", 0, 1]], 'edits: expected cut, bar, restore or turn, found "bend"'),
    ([["bar", 3, 3, 1.0]], "expected two joints"),
    ([["bar", 3, 4, "long"]], 'bar: expected a length above 0, found "long"'),
    ([["restore", 0, 1]], "is as it was at the start"),
    ([], "edits: expected rows of a word and two joints, found none"),
]


@pytest.mark.parametrize(("edits", "message"), REFUSED)
def test_an_edit_that_is_refused_changes_nothing(solver, edits, message):
    solver.open(CAFFEINE)
    stands, text = solver.ask("state"), solver.ask("forces")["text"]
    with pytest.raises(ValueError) as raised:
        solver.ask("edit", edits=edits)
    assert message in str(raised.value)
    assert (solver.ask("state"), solver.ask("forces")["text"]) == (stands, text)


class Hand:
    """The page's strong hand on one joint."""

    def __init__(self, solver, joint, mass, place, reach):
        self.solver, self.joint, self.mass = solver, joint, mass
        self.settings = solver.ask("settings")
        self.now = self.before = place
        self.target = place + reach

    def step(self):
        way = 0.8 * (self.target - self.now)
        way *= min(1.0, 0.6 / np.linalg.norm(way))
        effort = way - (1 - self.settings["damping"]) * (self.now - self.before)
        force = effort * self.mass / (100 * self.settings["timestep"] ** 2)
        moved = self.solver.ask("pull", forces=[[self.joint, *force]], whole=True)
        self.before, self.now = self.now, np.reshape(moved["positions"], (-1, 3))[self.joint]

    def way(self, steps):
        """How far the joint gets in so many steps, which are taken back."""
        start, before = self.now, self.before
        along = (self.target - start) / np.linalg.norm(self.target - start)
        best = 0.0
        for _ in range(steps):
            self.step()
            best = max(best, float(along @ (self.now - start)))
        self.solver.ask("undo", steps=steps)
        self.now, self.before = start, before
        return best


def test_what_holds_a_pull_frees_it_when_it_is_cut(solver):
    hand, found = held(solver, "LEU8:CG")
    cuts = [["cut", line["a"], line["b"]] for line in found["lines"] if line["cut"]]
    assert found["frees"] and cuts, found["said"]
    assert f"held by {len(cuts)} hydrogen bond" in found["said"]
    way = hand.way(24)
    solver.ask("edit", edits=cuts)
    free = hand.way(24)
    assert free > way + 0.02
    assert [way, free] == pytest.approx([found["asItIs"], found["without"]], abs=1e-6)


def test_what_frees_nothing_is_not_said_to_hold(solver):
    hand, found = held(solver, "THR5:O")
    assert not found["frees"]
    assert "cutting that does not free it" in found["said"]
    assert "held by 1 hydrogen bond" not in found["said"]
    way = hand.way(24)
    solver.ask(
        "edit", edits=[["cut", line["a"], line["b"]] for line in found["lines"] if line["cut"]]
    )
    assert hand.way(24) < way + 0.02


def held(solver, name):
    """A pull outwards after 30 steps, and why it is held."""
    opened = solver.ask("open", name="p.pdb", file=str(PEPTIDE), model="protein", whole=True)
    joint = next(k for k, label in enumerate(opened["names"]) if label.endswith(name))
    places = np.reshape(opened["positions"], (-1, 3))
    away = places[joint] - places.mean(axis=0)
    mass = opened["mass"][joint]
    hand = Hand(solver, joint, mass, places[joint], 20 * away / np.linalg.norm(away))
    for _ in range(30):
        hand.step()
    stands = solver.ask("state")
    found = solver.ask("why", joint=joint, target=hand.target.tolist())
    assert solver.ask("state") == stands
    return hand, found
