# SPDX-License-Identifier: MIT
"""pliant contacts, and the model that other commands take it into."""

import csv
import io
import json
from pathlib import Path

import numpy as np
import pytest
from h5md_contents import assert_same_runs, contents

pytest.importorskip("MDAnalysisTests")
import MDAnalysisTests

DATA = Path(MDAnalysisTests.__file__).parent / "data"
OPEN = DATA / "adk_open.pdb"
XRAY = DATA / "1a28.pdb.gz"
TRYPSIN_INHIBITOR = DATA / "mmcif" / "5PTI.cif.gz"

HISTIDINE = """\
ATOM      1  CB  HIS A   7      -1.500   0.000   0.000  1.00  0.00           C
ATOM      2  CG  HIS A   7       0.000   0.000   0.000  1.00  0.00           C
ATOM      3  ND1 HIS A   7       0.800   1.100   0.000  1.00  0.00           N
ATOM      4  CD2 HIS A   7       0.800  -1.100   0.000  1.00  0.00           C
ATOM      5  CE1 HIS A   7       2.100   0.700   0.000  1.00  0.00           C
ATOM      6  NE2 HIS A   7       2.100  -0.650   0.000  1.00  0.00           N
"""


def rows_of(text):
    return list(csv.DictReader(io.StringIO(text)))


def test_json_and_csv_say_the_same(pliant):
    rows = rows_of(pliant("contacts", OPEN, "--csv").out)
    contacts = json.loads(pliant("contacts", OPEN, "--json").out)["contacts"]
    assert len(rows) == len(contacts) > 200
    assert [row["b"] for row in rows] == [contact["b"] for contact in contacts]
    assert [float(row["energy"]) for row in rows] == [contact["energy"] for contact in contacts]


def test_what_was_done_is_reported(pliant):
    assert "note: left out: 180 waters" in pliant("contacts", XRAY).err
    ended = pliant("contacts", XRAY, "--verbose")
    assert ended.code == 0
    assert "note: 180 waters taken out\n" in ended.err
    assert "polar hydrogens placed by rule\n" in ended.err
    assert "warning: side chains: 5 residues lack atoms: A:GLN682 (CG CD OE1 NE2), " in ended.err


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (
            ["--model", "protein", "--bars", "bonds"],
            "--model, --bars: expected one of them: a model has bars of its own",
        ),
        (["--keep-waters"], "--keep-waters: goes with --model molecule or --model protein"),
        (
            ["--model", "molecule", "--floppy-below", "50"],
            "--floppy-below: goes with --model protein",
        ),
        (
            ["--model", "molecule", "--more-contacts", "cation_pi"],
            "--more-contacts: goes with --model protein",
        ),
        (
            ["--model", "protein", "--protonate", "HIS7:ASH"],
            'protonate: "HIS7:ASH": ASH is a form of ASP',
        ),
    ],
)
def test_options_that_do_not_go_together(pliant, tmp_path, arguments, message):
    molecule = tmp_path / "his.pdb"
    molecule.write_text(HISTIDINE)
    ended = pliant("run", molecule, *arguments)
    assert (ended.code, ended.err.splitlines()[-1]) == (2, f"pliant: error: {message}")
    assert not (tmp_path / "his.h5md").exists()


def test_bars_of_bonds_are_said_to_be_free(pliant):
    molecule = Path(__file__).parents[3] / "data/molecules/peptide_20.pdb"
    ended = pliant("run", molecule, "--steps", "1")
    assert ended.code == 0
    assert "note: only bonds are held: angles and planar groups are free" in ended.err


def test_info_says_what_is_missing(pliant):
    facts = json.loads(pliant("info", XRAY, "--json").out)
    assert facts["usual_model"] == "protein"
    assert facts["waters"] == 180
    assert facts["found"] == ["waters: 180", "ligands: A:STR1, B:STR2"]
    assert facts["missing"][0].startswith("hydrogens: of ")
    assert "missing     hydrogens: of " in pliant("info", XRAY).out


@pytest.mark.parametrize("form", ["--csv", "--json"])
def test_contacts_given_back_give_the_same_bits(pliant, tmp_path, form):
    """The list goes out and comes in again: the same limits, the same frames."""
    common = ("--frames", 2, "--quiet", "--topology", "none")
    (tmp_path / "contacts.txt").write_text(pliant("contacts", TRYPSIN_INHIBITOR, form).out)
    pliant("sample", TRYPSIN_INHIBITOR, "-o", "found.h5md", *common)
    ended = pliant(
        "sample", TRYPSIN_INHIBITOR, "-o", "given.h5md", "--contacts", "contacts.txt", *common
    )
    assert ended.code == 0, ended.err
    found, given = contents(tmp_path / "found.h5md"), contents(tmp_path / "given.h5md")
    assert len(found["parameters/limit/most"]) > 100
    for name, value in found.items():
        if name != "parameters/model/contacts":
            assert np.array_equal(value, given[name]), name


def test_contacts_left_out_of_the_json_are_not_held(pliant, tmp_path):
    listed = json.loads(pliant("contacts", OPEN, "--json").out)
    listed["contacts"] = [c for c in listed["contacts"] if c["kind"] != "hydrophobic"]
    (tmp_path / "edited.json").write_text(json.dumps(listed, indent=1))
    ended = pliant("contacts", OPEN, "--contacts", "edited.json", "--json")
    assert json.loads(ended.out) == listed


def test_side_chains_are_built_where_asked(pliant):
    lacking = pliant("contacts", XRAY)
    assert "; --fill-side-chains builds them" in lacking.err
    filled = pliant("contacts", XRAY, "--fill-side-chains")
    assert filled.code == 0
    assert "atoms of 5 residues built by rule, which is a guess: A:GLN682" in filled.err
    assert "lack atoms" not in filled.err


CATION_PI = ("--more-contacts", "cation_pi")


def test_kinds_that_are_not_usual_are_found_where_asked(pliant, tmp_path):
    usual = pliant("contacts", TRYPSIN_INHIBITOR, "--csv").out
    more = pliant("contacts", TRYPSIN_INHIBITOR, "--csv", "--verbose", *CATION_PI)
    assert ", metal 0, cation_pi 1\n" in more.err
    (row,) = rows_of(more.out)[len(rows_of(usual)) :]
    assert more.out.startswith(usual)
    assert (row["kind"], row["a"]) == ("cation_pi", "A:LYS41:NZ")
    assert row["b"].startswith("A:TYR10:C")
    (tmp_path / "more.csv").write_text(more.out)
    assert pliant("contacts", TRYPSIN_INHIBITOR, "--contacts", "more.csv", "--csv").out == more.out


@pytest.mark.parametrize(
    ("command", "counter"), [(["sample"], "--frames"), (["run", "--model", "protein"], "--steps")]
)
def test_what_goes_on_keeps_its_kinds(pliant, tmp_path, command, counter):
    """Two parts are the whole; asking for other kinds than the file has is refused."""
    common = ("--topology", "none", "--quiet", *CATION_PI)
    for name, count in (("whole", 4), ("part", 2)):
        ended = pliant(*command, TRYPSIN_INHIBITOR, "-o", f"{name}.h5md", counter, count, *common)
        assert ended.code == 0, ended.err
    go_on = (*command, "--continue", "part.h5md", counter, 4, "--quiet")
    assert "--more-contacts: is cation_pi in the run of part.h5md, not metal;" in (
        pliant(*go_on, "--more-contacts", "metal").err
    )
    assert pliant(*go_on, *CATION_PI).err == ""
    assert_same_runs(tmp_path / "whole.h5md", tmp_path / "part.h5md")
    found = contents(tmp_path / "part.h5md")
    assert found["parameters/model/more_contacts"] == b"cation_pi"
    assert 5 in found["parameters/limit/kind"]
