# SPDX-License-Identifier: MIT
"""pliant rigidity on graphs, and the options and selections that graphs have."""

import json
import shutil

import h5py
import numpy as np
import pytest
from real_files import MECHANISMS

BANANA, FOUR_BAR = MECHANISMS / "double_banana.xml", MECHANISMS / "four_bar.xml"


def test_the_report_of_the_double_banana(pliant, tmp_path):
    shutil.copy(BANANA, tmp_path / "banana.xml")
    ended = pliant("rigidity", "banana.xml")
    assert (ended.code, ended.err) == (0, "")
    assert ended.out.splitlines() == [
        "banana.xml",
        "joints                              8   in space, none pinned",
        "bars                               18   18 redundant: any one of them can go",
        "independent bars                   17   rank of the rigidity matrix: "
        "singular values above 1e-09",
        "self-stresses                       1",
        "internal degrees of freedom         1   at these positions, and 6 of the whole",
        "  at almost all positions           1",
        "  by counting bars                  0   pebble game: in space it can miss freedoms",
        "",
        "Overconstrained parts: any one bar of a part can go, and no freedom comes",
        "joints    bars  self-stresses  which bars",
        "     8      18              1  N-a, S-a, N-b, S-b, N-c, S-c, ...",
    ]


def test_json_and_csv_have_each_bar(pliant):
    found = json.loads(pliant("rigidity", FOUR_BAR, "--json").out)
    assert (found["dimension"], found["joints"], found["pinned"]) == (2, 5, 2)
    assert (found["degrees_of_freedom"], found["motions_of_the_whole"]) == (1, 0)
    assert found["at_almost_all_positions"]["degrees_of_freedom"] == 1
    assert found["by_counting"]["degrees_of_freedom"] == 1
    assert (found["tolerance"], found["rank_by"]) == (1e-9, "singular values")
    assert [(bar["a"], bar["redundant"]) for bar in found["bars"]][:2] == [
        ("O", False),
        ("A", False),
    ]
    table = pliant("rigidity", FOUR_BAR, "--csv").out.splitlines()
    assert table[:2] == ["a,b,redundant,redundant_at_almost_all", "O,A,0,0"]
    assert len(table) == 6


def test_rounded_coordinates_are_warned_of(pliant, tmp_path):
    joints = '<joint id="a" x="0" y="0"/><joint id="b" x="1" y="0"/><joint id="c" x="2" y="1e-6"/>'
    bars = '<bar a="a" b="b"/><bar a="b" b="c"/><bar a="a" b="c"/>'
    (tmp_path / "line.xml").write_text(f'<graph dimension="2">{joints}{bars}</graph>')
    ended = pliant("rigidity", "line.xml")
    assert ended.err == (
        "warning: the positions are nearly special: singular values below 0.0001 count in the "
        "rank: 1, the least 7.1e-07; if rounded coordinates are the reason, so many degrees of "
        "freedom are missing\n"
    )


@pytest.mark.parametrize(
    ("command", "words", "message"),
    [
        ("run", ["--model", "angles"], "--model angles: is for molecules; a graph XML file has "
         "bars of its own (--bars takes a bars file)"),
        ("run", ["--bars", "angles"], "--bars angles: is for molecules; a graph XML file has bars "
         "of its own (--bars takes a bars file)"),
        ("run", ["--select", "all"], "--select: is for molecules; a graph XML file has joints and "
         "bars as they stand"),
        ("info", ["--frame", 2], "--frame: is for molecules; a graph XML file has joints and bars "
         "as they stand"),
        ("rigidity", ["--hbond-cutoff", -2], "--hbond-cutoff: is for molecules; a graph XML file "
         "has joints and bars as they stand"),
        ("rigidity", ["--dilution"], "--dilution: is for molecules, not for a graph"),
        ("rigidity", ["-o", "out"], "--output: is for molecules, not for a graph"),
    ],
)  # fmt: skip  # a table: a row a line
def test_an_option_for_molecules_is_refused_by_its_name(pliant, command, words, message):
    ended = pliant(command, FOUR_BAR, *words)
    assert (ended.code, ended.err) == (2, f"pliant: error: {message}\n")


def test_what_takes_no_graph_says_what_does(pliant, tmp_path):
    shutil.copy(FOUR_BAR, tmp_path / "four.xml")
    ended = pliant("sample", "four.xml")
    assert (ended.code, ended.err) == (
        1,
        "pliant: error: four.xml: is a graph by its extension .xml, and no molecule: pliant run, "
        "play, order, info and rigidity take it; in Python pliant.read_graph_xml reads it\n",
    )


def test_joints_are_selected_by_their_id(pliant, tmp_path):
    words = ["--steps", 20, "--pin", "id A", "--save", "id A C", "-o", "o.h5md"]
    assert pliant("run", FOUR_BAR, *words).code == 0
    with h5py.File(tmp_path / "o.h5md") as file:
        at = file["particles/trajectory/position/value"][:]
    assert at.shape == (21, 2, 3)
    assert np.ptp(at[:, 0], axis=0).max() == 0 and np.ptp(at[:, 1], axis=0).max() > 0
    pulled = pliant("run", FOUR_BAR, "--steps", 60, "--pull", "id C", "-1,0,0", "-o", "p.h5md")
    assert pulled.code == 0 and "pulled          id C: " in pulled.out
