# SPDX-License-Identifier: MIT
"""pliant conformers: a library in, ranked conformers out; nothing is lost on the way."""

import bz2
import contextlib
import gzip
import json
import os
import re
import signal
import subprocess
import time

import numpy as np
import pytest

pytest.importorskip("rdkit")
from commit_logs import TRIES
from libraries import embedded, library, molecules, record
from pliant.jobs.conformers.journal import Journal
from pliant.jobs.conformers.library import Source, begin, resume
from pliant.jobs.conformers.options import ConformerOptions
from pliant.jobs.conformers.workers import Outcome
from rdkit import Chem
from rdkit.Chem import AllChem

from pliant import FileError, InputError

FAST = ("--frames", 40, "--starts", 2, "--max", 3)
BROKEN = "broken\n\n\n  1  0\nnot an atom line\n$$$$\n"


@pytest.fixture
def with_broken(tmp_path):
    """Twenty records, of which the 7th is broken."""
    records = library(19).split("$$$$\n")[:-1]
    parts = [one + "$$$$\n" for one in records]
    (tmp_path / "library.sdf").write_text("".join([*parts[:6], BROKEN, *parts[6:]]))
    return "library.sdf"


def test_a_library_is_complete_but_for_what_is_broken(pliant, with_broken, tmp_path):
    ended = pliant("conformers", with_broken, "-o", "out.sdf", *FAST, "--json", "--threads", 2)
    assert ended.code == 3
    report = json.loads(ended.out)
    assert report["records"] == 20
    (failed,) = report["failed"]
    assert (failed["number"], failed["name"]) == (7, "broken")
    assert failed["reason"] == (
        'line 5: atom 1 of 1: x (columns 1-10) "not an ato" is not a finite number'
    )
    made = molecules(tmp_path / "out.sdf")
    assert len(made) == report["conformers"] == sum(one["conformers"] for one in report["made"])
    names = [one.GetProp("_Name") for one in made]
    assert list(dict.fromkeys(names)) == [f"molecule {k}" for k in range(1, 20)]
    assert report["missing"] == 19 * 3 - len(made)
    starts = {one.GetProp("_Name"): one for one in molecules(tmp_path / with_broken) if one}
    for one in made:
        start = starts[one.GetProp("_Name")]
        assert Chem.MolToSmiles(one) == Chem.MolToSmiles(start)
        for name in ("pIC50", "note"):
            assert one.GetProp(name) == start.GetProp(name)
        assert one.GetProp("pliant_energy_name").startswith("Pliant's own energy, torsions")
        assert re.fullmatch(r"\d\.\de-\d\d", one.GetProp("pliant_worst_bar"))
    assert_lengths_of_starts(made)
    of_first = [one for one in made if one.GetProp("_Name") == "molecule 4"]
    assert [int(one.GetProp("pliant_conformer")) for one in of_first] == [1, 2, 3]
    energies = [float(one.GetProp("pliant_energy")) for one in of_first]
    assert energies == sorted(energies)


def assert_lengths_of_starts(made):
    """Each start is written once, and its conformers have its lengths."""
    first = [one for one in made if one.HasProp("pliant_start_positions")]
    assert len(first) == len({(one.GetProp("_Name"), one.GetProp("pliant_start")) for one in made})
    for one in first:
        rest = np.array(
            [line.split() for line in one.GetProp("pliant_start_positions").split("\n")]
        )
        found = one.GetConformer().GetPositions()
        for bond in one.GetBonds():
            a, b = bond.GetBeginAtomIdx(), bond.GetEndAtomIdx()
            lengths = [np.linalg.norm(x[a] - x[b]) for x in (rest.astype(float), found)]
            assert abs(lengths[0] - lengths[1]) < 4e-4


def test_the_report_has_seven_lines(pliant, with_broken):
    ended = pliant("conformers", with_broken, "-o", "out.sdf", *FAST)
    lines = ended.out.splitlines()
    assert [line.split()[0] for line in lines] == (
        "input molecules conformers drawn energy time output".split()
    )
    assert lines[0] == "input       library.sdf, 20 records"
    assert lines[1] == "molecules   19 done, 1 failed (out-failed.csv)"
    assert "have fewer than 3: no more that differ by 0.3 Å" in lines[2]
    assert "warning: record 7 (broken): " in ended.err


def test_bytes_do_not_depend_on_threads_or_compression(pliant, with_broken, tmp_path):
    pliant("conformers", with_broken, "-o", "one.sdf", *FAST, "--threads", 1)
    text = (tmp_path / with_broken).read_bytes()
    (tmp_path / "library.sdf.gz").write_bytes(gzip.compress(text))
    (tmp_path / "again.sdf.bz2").write_bytes(bz2.compress(text.replace(b"\n", b"\r\n")))
    pliant("conformers", "library.sdf.gz", "-o", "two.sdf", *FAST, "--threads", 2)
    pliant("conformers", "again.sdf.bz2", "-o", "three.sdf.gz", *FAST, "--threads", 2)
    one = (tmp_path / "one.sdf").read_bytes()
    assert one == (tmp_path / "two.sdf").read_bytes()
    assert one == gzip.decompress((tmp_path / "three.sdf.gz").read_bytes())
    assert not list(tmp_path.glob(".*"))


def lines_of(journal):
    with contextlib.suppress(FileNotFoundError):
        return journal.read_bytes().count(b"\n")
    return 0


def stopped(command, words, folder, name, number):
    """Sends a signal to a run that has committed some molecules; its exit code and messages.

    Anew, if all was done before it was met; 3 if it cannot be stopped.
    """
    words, journal = [command, *words, "-o", name], folder / f".{name}.journal"
    for _ in range(TRIES):
        (folder / name).unlink(missing_ok=True)
        with subprocess.Popen(words, cwd=folder, stderr=subprocess.PIPE, text=True) as run:
            while run.poll() is None and lines_of(journal) < 5:
                time.sleep(0.01)
            run.send_signal(number)
            code, said = run.wait(), run.stderr.read()
        if code != 3:
            break
    return code, said


def test_ctrl_c_says_how_to_go_on(command, with_broken, tmp_path):
    words = ["conformers", with_broken, "--frames", "400", "--threads", "1"]
    code, said = stopped(command, words, tmp_path, "out.sdf", signal.SIGINT)
    assert code == 130
    assert said.splitlines()[-2:] == [
        "pliant conformers --continue out.sdf goes on",
        "pliant conformers: interrupted",
    ]
    assert (tmp_path / ".out.sdf.journal").exists()


@pytest.mark.parametrize("name", ["out.sdf", pytest.param("out.sdf.gz", marks=pytest.mark.long)])
def test_a_killed_run_goes_on_to_the_same_bytes(pliant, command, with_broken, tmp_path, name):
    words = ["conformers", with_broken, *map(str, FAST), "--threads", "2"]
    assert pliant(*words, "-o", f"whole-{name}").code == 3
    assert stopped(command, words, tmp_path, name, signal.SIGKILL)[0] == -signal.SIGKILL
    journal = tmp_path / f".{name}.journal"
    assert journal.exists()
    assert not (tmp_path / name).exists()
    journal.write_bytes(journal.read_bytes() + b'{"number": 9')  # cut short
    with open(tmp_path / f".{name}.partial", "ab") as file:
        file.write(b"not committed")
    refused = pliant(*words, "-o", name)
    assert refused.code == 1
    assert refused.err == (
        f"pliant conformers: error: {name}: an earlier run is unfinished: --continue {name} goes "
        "on, --overwrite begins anew\n"
    )
    ended = pliant("conformers", "--continue", name, "--json")
    assert ended.code == 3, ended.err
    report = json.loads(ended.out)
    assert report["resumed"] > 3
    assert (report["records"], len(report["failed"])) == (20, 1)
    assert (tmp_path / name).read_bytes() == (tmp_path / f"whole-{name}").read_bytes()
    again = pliant("conformers", "--continue", "out.sdf")
    assert again.code == 1
    assert "out.sdf: nothing to continue: " in again.err
    assert not list(tmp_path.glob(".*"))


IN_THE_WAY = (
    "pliant conformers: error: out.sdf: came to be meanwhile: once it has another name or place, "
    "--continue out.sdf ends the run\n"
)
UNUSABLE = (
    "pliant conformers: error: out.sdf: its unfinished run is damaged, or of another version of "
    "Pliant; --overwrite begins anew\n"
)


@pytest.fixture
def unfinished(command, with_broken, tmp_path):
    """A run that was killed: its folder with a library, .out.sdf.partial and .out.sdf.journal."""
    words = ["conformers", with_broken, *map(str, FAST), "--threads", "1"]
    assert stopped(command, words, tmp_path, "out.sdf", signal.SIGKILL)[0] == -signal.SIGKILL
    return tmp_path


def test_what_is_damaged_is_not_continued(pliant, unfinished):
    partial, journal = unfinished / ".out.sdf.partial", unfinished / ".out.sdf.journal"
    records, notes = partial.read_bytes(), journal.read_bytes()
    lines = notes[: notes.rindex(b"\n") + 1].splitlines(keepends=True)
    flipped = bytearray(records)
    flipped[100] ^= 1
    for damaged in (
        (bytes(flipped), notes),
        (records[:100], notes),
        (records, b"".join([*lines[:2], *lines[3:]])),
        (records, b"".join([*lines[:2], lines[1], *lines[2:]])),
        (records, b'{"a": 1}\n'),
        (records, b"{}"),
        (records, b"\xff\n" + notes),
    ):
        partial.write_bytes(damaged[0])
        journal.write_bytes(damaged[1])
        ended = pliant("conformers", "--continue", "out.sdf")
        assert (ended.code, ended.err) == (1, UNUSABLE)
        assert partial.read_bytes() == damaged[0]


def test_another_input_is_not_continued(pliant, unfinished):
    path = unfinished / "library.sdf"
    path.write_text(path.read_text()[:-6] + " $$$$\n")  # of the same size
    ended = pliant("conformers", "--continue", "out.sdf")
    assert (ended.code, ended.err) == (
        1,
        "pliant conformers: error: library.sdf: is not the file that out.sdf was begun with\n",
    )


def test_an_input_that_changed_far_behind_its_begin_is_not_continued(tmp_path):
    path, output = tmp_path / "library.sdf", tmp_path / "out.sdf"
    text = library(1) + library(1).replace("$$$$", f"> <note>\n{2**21 * 'a'}\n\n$$$$")
    path.write_text(text)
    source = Source(str(path))
    begin(source, ConformerOptions(), output, overwrite=False).close()
    resume(output).close()
    path.write_text(text.replace("a\n\n$$$$", "b\n\n$$$$"))
    with pytest.raises(InputError) as caught:
        resume(output)
    assert str(caught.value) == f"{path}: is not the file that {output} was begun with"


def test_another_file_of_the_name_is_kept(pliant, unfinished):
    output = unfinished / "out.sdf"
    output.write_text("another's")
    ended = pliant("conformers", "--continue", "out.sdf")
    assert (ended.code, ended.err) == (1, IN_THE_WAY)
    assert output.read_text() == "another's"


def test_a_file_that_came_to_be_meanwhile_is_kept(tmp_path):
    output = tmp_path / "out.sdf"
    journal = Journal.begin(output, {}, overwrite=False)
    journal.add(Outcome(1, "one", text=b"made\n"))
    output.write_text("another's")
    with pytest.raises(FileError, match="came to be meanwhile"):
        journal.publish()
    journal.close()
    output.unlink()
    journal = Journal.resume(output)
    journal.publish()
    journal.close()
    assert output.read_bytes() == b"made\n"
    assert not list(tmp_path.glob(".*"))


@pytest.mark.parametrize("is_linked", [True, False])
def test_a_kill_while_the_output_gets_its_name(tmp_path, is_linked):
    output = tmp_path / "out.sdf"
    journal = Journal.begin(output, {}, overwrite=False)
    journal.add(Outcome(1, "one", text=b"made\n"))
    journal.close()
    partial = tmp_path / ".out.sdf.partial"
    os.link(partial, output)
    if not is_linked:
        partial.unlink()
    with pytest.raises(FileError, match="nothing to continue: it is finished"):
        Journal.resume(output)
    assert output.read_bytes() == b"made\n"
    assert not list(tmp_path.glob(".*"))


def test_shards_hold_all_records(pliant, with_broken, tmp_path):
    pliant("conformers", with_broken, "-o", "whole.sdf", *FAST)
    parts = []
    for k in (1, 2, 3):
        pliant("conformers", with_broken, "-o", f"{k}.sdf", *FAST, "--shard", f"{k}/3")
        parts += (tmp_path / f"{k}.sdf").read_text().split("$$$$\n")[:-1]
    whole = (tmp_path / "whole.sdf").read_text().split("$$$$\n")[:-1]
    assert sorted(parts) == sorted(whole)


def test_smiles_files_and_texts(pliant, tmp_path):
    (tmp_path / "some.smi").write_text("smiles name\nCCCO propanol\n\nCC(=O)O.[Na]\nC1CC ring\n")
    ended = pliant("conformers", "some.smi", "-o", "some-conformers.sdf", "--frames", 20, "--json")
    assert ended.code == 3
    report = json.loads(ended.out)
    assert [one["number"] for one in report["made"]] == [1, 2]
    assert report["made"][1]["notes"][0] == "the largest of 2 molecules is kept"
    assert report["failed"] == [
        {
            "number": 3,
            "name": "ring",
            "reason": "SMILES 'C1CC': expected a molecule, RDKit cannot read it",
        }
    ]
    names = [one.GetProp("_Name") for one in molecules(tmp_path / "some-conformers.sdf")]
    assert list(dict.fromkeys(names)) == ["propanol", "CC(=O)O.[Na]"]
    ended = pliant("conformers", "--smiles", "C[C@H](F)CO", "-o", "one.sdf", "--frames", 20)
    assert ended.code == 0
    assert {Chem.MolToSmiles(Chem.RemoveHs(one)) for one in molecules(tmp_path / "one.sdf")} == {
        "C[C@H](F)CO"
    }


def test_stereo_that_is_left_open_is_said_of_each_record(pliant, tmp_path):
    drawn = Chem.MolFromSmiles("CC(F)C=CO")
    AllChem.Compute2DCoords(drawn)
    (tmp_path / "drawn.sdf").write_text(record(drawn, "drawn"))
    (tmp_path / "some.smi").write_text("C[C@H](F)CO given\nCC(F)CCO open\n")
    said = "1 stereo centre is not given: one isomer was made"
    ended = pliant("conformers", "some.smi", "-o", "out.sdf", *FAST, "--quiet")
    assert (ended.code, ended.err) == (0, f"warning: record 2 (open): {said}\n")
    ended = pliant("conformers", "--smiles", "CC(F)CO", "-o", "one.sdf", *FAST, "--json")
    assert json.loads(ended.out)["made"][0]["warnings"] == [said]
    ended = pliant("conformers", "drawn.sdf", "-o", "drawn-out.sdf", *FAST, "--embed")
    assert ended.err == (
        "warning: record 1 (drawn): 1 stereo centre and 1 double bond are not given: one isomer "
        "was made\n"
    )


def test_what_a_library_has_twice_is_done_again_and_said(pliant, command, tmp_path):
    texts = [record(embedded("C[C@H](F)CO"), "one"), record(embedded("C[C@@H](F)CO"), "mirrored")]
    texts += [record(embedded("OC[C@@H](C)F", 3), "another order"), library(9)]
    (tmp_path / "some.sdf").write_text("".join(texts))
    said = [
        "warning: record 3 (another order): the same molecule as record 2 (mirrored): done again",
        "warning: record 5 (molecule 2): the same molecule as record 1 (one): done again",
        "warning: record 12 (molecule 9): the same molecule as record 4 (molecule 1): done again",
    ]
    words = ["conformers", "some.sdf", *map(str, FAST), "--threads", "1"]
    assert pliant(*words, "-o", "whole.sdf").err.splitlines() == said
    assert stopped(command, words, tmp_path, "out.sdf", signal.SIGKILL)[0] == -signal.SIGKILL
    ended = pliant("conformers", "--continue", "out.sdf", "--json")
    made = json.loads(ended.out)["made"]
    assert [made[k - 1]["warnings"] for k in (3, 5, 12)] == [
        [one.partition("): ")[2]] for one in said
    ]


def test_hydrogens_that_are_missing_are_added_and_said(pliant, tmp_path):
    whole = Chem.RWMol(embedded("CCCO"))
    whole.RemoveAtom(6)
    (tmp_path / "part.sdf").write_text(record(whole.GetMol(), "part"))
    ended = pliant("conformers", "part.sdf", "-o", "out.sdf", *FAST)
    said = "1 missing hydrogen was added: 1 to C1"
    assert (ended.code, ended.err) == (0, f"warning: record 1 (part): {said}\n")
    assert {one.GetNumAtoms() for one in molecules(tmp_path / "out.sdf")} == {12}


def test_what_cannot_be_used_is_refused_with_the_remedy(pliant, tmp_path):
    drawn = Chem.MolFromSmiles("C[C@H](F)CO")
    AllChem.Compute2DCoords(drawn)
    bare = Chem.RemoveHs(embedded("C[C@@H](N)CO"))
    salt = Chem.AddHs(Chem.MolFromSmiles("CCC(=O)[O-].[Na+]"))
    AllChem.EmbedMolecule(salt, randomSeed=1)
    parts = ((drawn, "drawn"), (bare, "bare"), (salt, "salt"))
    texts = [record(*one, ID=one[1]) for one in parts]
    (tmp_path / "few.sdf").write_text("".join(texts[:2]))
    (tmp_path / "odd.sdf").write_text("".join(texts))
    ended = pliant("conformers", "few.sdf", "-o", "out.sdf", *FAST)
    assert ended.code == 1
    assert ended.err.splitlines() == [
        "warning: record 1 (drawn): the molecule is a 2-D drawing: --embed makes it 3-D, with "
        "hydrogens, by RDKit",
        "warning: record 2 (bare): the molecule is without its hydrogens: --embed makes it 3-D, "
        "with hydrogens, by RDKit",
        "pliant conformers: error: no record gave a conformer",
    ]
    assert not (tmp_path / "out.sdf").exists()
    ended = pliant("conformers", "odd.sdf", "-o", "out.sdf", *FAST, "--embed", "--verbose")
    assert ended.code == 0
    assert "note: record 2 (bare): made 3-D by RDKit, with hydrogens" in ended.err
    assert "; the largest component was kept of 1 record with several" in ended.out
    found = {}
    for one in molecules(tmp_path / "out.sdf"):
        found.setdefault(one.GetProp("ID"), set()).add(Chem.MolToSmiles(Chem.RemoveHs(one)))
        assert one.GetProp("ID") == one.GetProp("_Name")
    assert found == {"drawn": {"C[C@H](F)CO"}, "bare": {"C[C@@H](N)CO"}, "salt": {"CCC(=O)[O-]"}}


def test_minimised_conformers_are_said_to_be(pliant, tmp_path):
    (tmp_path / "one.sdf").write_text(record(embedded("CCCO"), "one"))
    ended = pliant(
        "conformers", "one.sdf", "-o", "out.sdf", *FAST, "--energy", "MMFF94s", "--minimise"
    )
    assert "; minimised: lengths and angles are the force field's\n" in ended.out
    for one in molecules(tmp_path / "out.sdf"):
        assert not one.HasProp("pliant_worst_bar")
        assert one.GetProp("pliant_lengths") == (
            "minimised: lengths and angles are the force field's"
        )
