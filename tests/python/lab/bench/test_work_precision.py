# SPDX-License-Identifier: MIT
"""Work against precision: what is measured is true, and who fails is reported."""

import csv
import json
import math

import numpy as np
import pytest
from pliant.lab.bench import work_precision as race
from pliant.lab.bench.command import main
from pliant.lab.bench.contenders import Repair
from pliant.lab.bench.nearest import nearest_whole
from pliant.lab.bench.target import read_target, target_of
from pliant.lab.bench.work_precision import compare_with_openmm, fastest_to
from pliant.lab.bench.work_precision_rows import TOO_SHORT, Row
from real_files import CAFFEINE
from scipy.optimize import minimize

import pliant


@pytest.fixture(scope="module")
def diagram():
    return race.work_precision(CAFFEINE, tolerances=(1e-3, 1e-8), repeats=2, peers="openmm")


def test_every_technique_that_can_takes_part(diagram):
    raced = {row.method for row in diagram.rows}
    able = {row.name for row in pliant.techniques() if not row.forests_only}
    lanes = {"bfs_cycle_lanes", "blocks_lanes", "shake_lanes", "newton_lanes"}
    assert raced == able | {"ccma", "ccma_dynamics", "shake_dynamics"} | lanes
    assert {row.method for row in diagram.rows if row.walkers > 1} == lanes


def test_walkers_in_lanes_answer_as_one_alone(diagram):
    by_method = {(row.method, row.weighting, row.tolerance): row for row in diagram.rows}
    for (method, weighting, tolerance), row in by_method.items():
        if row.walkers > 1:
            alone = by_method[method.removesuffix("_lanes"), weighting, tolerance]
            assert (row.sweeps, row.projections) == (alone.sweeps, alone.projections)
            assert row.max_residual == alone.max_residual
            assert row.displacement == alone.displacement


def test_all_are_whole_and_timed_on_a_small_molecule(diagram):
    for row in diagram.rows:
        assert row.outcome == "whole", row
        assert row.max_residual <= row.tolerance * (1 + 1e-9)
        # A difference of two times can come out as nothing on a busy machine.
        assert row.ns_per_bar > 0 or (row.method, row.note) == ("ccma_dynamics", TOO_SHORT)
        assert row.repeats >= 1


def test_a_time_that_is_nothing_is_too_short_to_tell():
    rows = [Row("ccma", 0.5, 1e-6), Row("blocks", 0.5, 1e-6), Row("newton", 0.5, 1e-6)]
    for row, seconds in zip(rows, (0.0, 2e-6, -1e-9), strict=True):
        row.outcome, row.max_residual = "whole", 1e-7
        race._time(row, seconds, 4)
    assert [row.note for row in rows] == [TOO_SHORT, "", TOO_SHORT]
    assert np.isnan([row.ns_per_bar for row in rows]).tolist() == [True, False, True]
    assert rows[1].ns_per_bar == pytest.approx(500)
    compare_with_openmm(rows)
    assert np.isnan(rows[1].ratio_to_openmm)


def test_nobody_moves_less_than_to_the_nearest_whole_structure(diagram):
    assert diagram.nearest_displacement > 0
    tight = [row for row in diagram.rows if row.tolerance == 1e-8]
    assert all(row.displacement_ratio > 1 - 1e-6 for row in tight)
    assert all(row.mass_displacement_ratio > 1 - 1e-6 for row in tight)


def test_newton_is_nearest_by_mass_and_shake_has_the_answer_of_openmm(diagram):
    tight = {row.method: row for row in diagram.rows if row.tolerance == 1e-8}
    assert tight["newton"].mass_displacement_ratio == pytest.approx(1.0, abs=1e-6)
    assert tight["shake"].distance_to_ccma < 1e-7
    assert tight["shake_dynamics"].distance_to_ccma < 1e-7
    assert tight["ccma"].distance_to_ccma == 0.0
    assert tight["blocks"].distance_to_ccma > 1e-3  # another answer, as whole


def test_nearest_is_what_a_general_minimiser_finds():
    framework = pliant.Framework([[0, 1], [1, 2]], [1.0, 1.5])
    whole = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1.5, 0]])
    target = target_of(framework, whole, np.array([1.0, 2.0, 5.0]), "angle")
    broken = target.broken(0.1, 3)
    found = nearest_whole(target, broken, target.masses)
    slow = minimize(
        lambda x: np.sum(np.repeat(target.masses, 3) * (x - broken.ravel()) ** 2),
        broken.ravel(),
        constraints={
            "type": "eq",
            "fun": lambda x: np.linalg.norm(np.diff(x.reshape(3, 3), axis=0), axis=1) - [1, 1.5],
        },
        method="SLSQP",
        options={"ftol": 1e-15},
    )
    assert found == pytest.approx(slow.x.reshape(3, 3), abs=1e-6)


def test_what_cannot_be_whole_has_no_nearest_whole_structure():
    framework = pliant.Framework([[0, 1], [1, 2], [0, 2]], [1.0, 1.0, 3.0])
    target = target_of(framework, np.eye(3), np.ones(3), "triangle_1_1_3")
    assert nearest_whole(target, target.broken(0.1, 0)) is None


class Pretender:
    """Says that it is done and changes nothing, or what the test wants."""

    whose, weighting, method, walkers = "pliant", None, "pretender", 1

    def __init__(self, change=lambda x: x):
        self.change, self.asked = change, []

    def prepare(self, tolerance):
        self.asked.append(tolerance)

    def repair(self, broken):
        return Repair(self.change(broken.copy()), 1e-6, "converged")


def rows_of(contender):
    target = read_target(CAFFEINE)
    found = race.prepare(target, "bonds", 0.1, 0, (1e-2, 1e-4))
    race.race(found, [contender], target.broken(0.1, 0), 1, 1.0)
    return found.rows


def test_a_false_claim_is_seen_through():
    first, second = rows_of(Pretender())
    assert (first.outcome, first.note) == ("not converged", "said to have converged")
    assert (second.outcome, second.note) == ("stopped", "not converged at 1e-02")


def test_what_is_no_number_is_reported():
    first, second = rows_of(Pretender(lambda x: x * math.nan))
    assert (first.outcome, second.outcome) == ("not finite", "stopped")


def test_who_takes_too_long_is_stopped_and_asked_no_more():
    # Four bars of a length that they cannot all have: sweeps go on for ever.
    framework = pliant.Framework([[0, 1], [1, 2], [0, 2]], [1.0, 1.0, 3.0])
    target = target_of(framework, np.eye(3), np.ones(3), "triangle")
    found = race.WorkPrecision(target, "bonds", 0.1, math.nan, math.nan, 1.0, (1e-2, 1e-4))
    endless = next(c for c in race.our_contenders(target) if c.method == "bfs_cycle")
    endless.prepare = lambda tolerance: setattr(
        endless, "_resolver", pliant.Resolver(framework, tolerance=tolerance, max_sweeps=10**12)
    )
    race.race(found, [endless], np.eye(3), 1, 0.3)
    assert [row.outcome for row in found.rows] == ["stopped", "stopped"]
    assert [row.note for row in found.rows] == ["took more than 0.3 s", "stopped at 1e-02"]


def test_ratios_compare_times_to_the_same_error():
    rows = [
        Row("ccma", None, 1e-2, "whole", 50.0, max_residual=9e-3),
        Row("ccma", None, 1e-4, "whole", 200.0, max_residual=9e-5),
        Row("blocks", None, 1e-2, "whole", 10.0, max_residual=1e-12),
        Row("blocks", None, 1e-4, "whole", 10.0, max_residual=1e-12),
        Row("blocks", None, 1e-6, "whole", 10.0, max_residual=1e-12),
    ]
    compare_with_openmm(rows)
    assert [row.ratio_to_openmm for row in rows] == [1.0, 1.0, 5.0, 20.0, math.inf]
    assert fastest_to(rows, "ccma", 1e-3) == 200.0


def test_the_command_writes_json_csv_and_a_picture(tmp_path, capsys):
    options = "--tolerance 1e-2,1e-6 --repeats 1 --technique blocks,bfs_cycle --peers openmm --json"
    words = ["work-precision", str(CAFFEINE), *options.split()]
    words += ["--csv", str(tmp_path / "a.csv"), "-o", str(tmp_path / "a.png")]
    assert main(words) == 0
    said = json.loads(capsys.readouterr().out)
    assert said["joints"] == 24 and said["bars"] == 25
    keys = set(
        "method weighting tolerance ns_per_bar sweeps projections max_residual displacement "
        "walkers".split()
    )
    assert all(keys <= set(row) for row in said["rows"])
    with open(tmp_path / "a.csv", newline="") as file:
        assert len(list(csv.DictReader(file))) == len(said["rows"]) == 2 * (2 * (1 + 3) + 2)
    assert (tmp_path / "a.png").read_bytes().startswith(b"\x89PNG")


def test_the_table_names_everyone(capsys):
    words = "--tolerance 1e-6 --repeats 1 --quiet --peers openmm".split()
    assert main(["work-precision", str(CAFFEINE), *words]) == 0
    out = capsys.readouterr().out
    assert all(
        name in out for name in ("blocks", "bfs_cycle 0.75", "OpenMM CCMA", "moved, by mass:")
    )


@pytest.mark.parametrize(
    ("words", "code", "message"),
    [
        (["work-precision", str(CAFFEINE), "--technique", "none"], 2, 'no technique named "none"'),
        (["work-precision", "none.pdb"], 1, "none.pdb"),
        (["step", "--kinds", "cube"], 2, 'no kind named "cube"; known: protein, zigzag'),
        (["throughput", str(CAFFEINE), "--technique", "none"], 2, 'no technique named "none"'),
    ],
)
def test_what_the_user_did_wrong_is_one_line(words, code, message, capsys):
    assert main(words) == code
    said = capsys.readouterr().err
    assert message in said and said.count("\n") == 1


@pytest.mark.parametrize("words", [["nonsense"], [], ["--nonsense"]])
def test_no_such_subcommand_ends_with_2(words, capsys):
    with pytest.raises(SystemExit) as ended:
        main(words)
    assert ended.value.code == 2
    assert "pliant lab bench: error: " in capsys.readouterr().err
