# SPDX-License-Identifier: MIT
"""pliant check on the command line: exit codes, table, JSON, picture."""

import json
import struct

import pytest
from json_shape import holds
from made_trajectories import molecule_run
from pliant.report.check.command import main


@pytest.fixture(scope="module")
def ethanol():
    return molecule_run("CCO", frames=6)


@pytest.fixture
def path(ethanol, tmp_path):
    return str(ethanol.write(tmp_path / "ethanol.h5md"))


def test_a_good_trajectory_ends_with_0(path, capsys):
    assert main([path, "--quiet"]) == 0
    out = capsys.readouterr().out
    assert out.splitlines()[1].startswith(
        f"{path}: 6 frames, 9 atoms, 8 bars, tolerance 1e-06; 6 frames shown"
    )
    assert out.startswith("All checks passed: bars of all 6 frames.\n")
    for line in ("OpenMM leaves our frames where they are", "Pliant, default", "OpenMM, no angles"):
        assert line in out


def test_a_tampered_trajectory_ends_with_1(ethanol, tmp_path, capsys):
    positions = ethanol.positions.copy()
    recorded = ethanol.residual()
    positions[3, 0, 0] += 0.01
    made = type(ethanol)(
        positions,
        ethanol.bars,
        ethanol.rest_lengths,
        ethanol.bonds,
        ethanol.elements,
        max_residual=recorded,
    )
    path = made.write(tmp_path / "tampered.h5md")
    assert main([str(path), "--quiet"]) == 1
    out = capsys.readouterr().out
    first = out.splitlines()[0]
    assert first.startswith(
        "Do not use these frames as they are. Checks failed: bars of all frames"
    )
    assert "OpenMM leaves our frames where they are: " in first and " allowed)" in first
    assert "frames_stay" not in out and "energies_vanish" not in out


def test_a_missing_file_ends_with_1_and_one_line(tmp_path, capsys):
    assert main([str(tmp_path / "none.h5md")]) == 1
    assert capsys.readouterr().err == (
        f"pliant check: error: {tmp_path / 'none.h5md'}: no such file\n"
    )


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--frames", "0"], "--frames: expected a whole number from 1 or all, found '0'"),
        (["--starts", "none"], "--starts: expected a whole number from 1 or all, found 'none'"),
        (["--what"], "unrecognized arguments: --what"),
    ],
)
def test_a_bad_option_ends_with_2(words, message, capsys):
    with pytest.raises(SystemExit) as stopped:
        main(["out.h5md", *words])
    assert stopped.value.code == 2
    assert capsys.readouterr().err.splitlines()[0] == f"pliant check: error: {message}"


NUMBER = (int, float, type(None))
SCHEMA = {
    "verdict": str,
    "verdict_text": str,
    "file": str,
    "passed": bool,
    "covers": {"frames": int, "md_starts": int, "left_out": dict, "ligands": list},
    "pliant": str,
    "openmm": str,
    "atoms": int,
    "bars": int,
    "pinned": int,
    "tolerance": {"relative": float, "length": float},
    "frames": {"total": int, "not_converged": int, "shown_to_openmm": [int]},
    "checks": [
        {
            "name": str,
            "title": str,
            "status": str,
            "measured": str,
            "allowed": str,
            "notes": [str],
            "figures": dict,
        }
    ],
    "side_by_side": [
        {
            "name": str,
            "whose": str,
            "description": str,
            "results": [
                {
                    "displacement": float,
                    "structures": int,
                    "whole": int,
                    "residual_before": NUMBER,
                    "residual_after": NUMBER,
                    "worst_residual_after": NUMBER,
                    "seconds": NUMBER,
                    "ready_seconds": NUMBER,
                    "outcome": str,
                    "claimed": (int, type(None)),
                    "false_claims": (int, type(None)),
                }
            ],
        }
    ],
    "force_field": type(None),  # of no protein
    "notes": [str],
    "picture": (str, type(None)),
}


def test_json_is_one_object_of_a_fixed_shape(path, capsys):
    assert main([path, "--json"]) == 0
    captured = capsys.readouterr()
    assert captured.err == ""
    report = json.loads(captured.out)
    holds(report, SCHEMA)
    assert [check["name"] for check in report["checks"]] == [
        "record",
        "frames_stay",
        "broken_copies_move",
        "energies_agree",
        "energies_vanish",
        "resolver_honest",
    ]
    assert {check["status"] for check in report["checks"]} == {"passed"}
    results = report["side_by_side"][0]["results"]
    assert [one["displacement"] for one in results] == [0.01, 0.03, 0.1, 0.3]


def test_the_picture_is_where_it_was_wanted(path, tmp_path, capsys):
    folder = tmp_path / "new" / "folder"
    assert main([path, "-o", str(folder)]) == 0
    picture = folder / "ethanol.check.png"
    assert f"picture  {picture}\n" in capsys.readouterr().out
    header = picture.read_bytes()[:24]
    assert header[:8] == b"\x89PNG\r\n\x1a\n"
    width, height = struct.unpack(">II", header[16:])
    assert width > 1200 and height > 800


def test_help_names_every_option(capsys):
    with pytest.raises(SystemExit) as stopped:
        main(["--help-all"])
    assert stopped.value.code == 0
    out = capsys.readouterr().out
    options = ["-o", *(f"--{name}" for name in "frames thorough starts reference json".split())]
    options.append("--force-field, --no-force-field")
    for option in options:
        assert option in out
