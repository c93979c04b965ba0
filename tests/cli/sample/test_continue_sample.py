# SPDX-License-Identifier: MIT
"""pliant sample --continue: the bits of one sample, after its end, Ctrl-C and any kill."""

import json
import os
import subprocess
import time
from pathlib import Path

import h5py
import numpy as np
import pytest
from h5md_contents import assert_same_runs, contents
from interruptions import interrupt_again_and_again

PEPTIDE = Path(__file__).parents[3] / "data" / "molecules" / "cyclic_hexapeptide.pdb"
COMMON = ["--amplitude", "0.4", "--topology", "none", "--quiet"]


@pytest.mark.parametrize(
    "options",
    [
        [],
        ["--precision", 0.01],
        ["--sampler", "dilute", "--seed", 18446744073709551615],
        ["--free-torsions"],
    ],
)
def test_two_parts_are_the_whole(pliant, tmp_path, options):
    pliant("sample", PEPTIDE, "-o", "whole.h5md", "--frames", 9, *COMMON, *options)
    pliant("sample", PEPTIDE, "-o", "part.h5md", "--frames", 4, *COMMON, *options)
    ended = pliant("sample", "--continue", "part.h5md", "--frames", 9, "--threads", 2, "--quiet")
    assert (ended.code, ended.err) == (0, "")
    assert_same_runs(tmp_path / "whole.h5md", tmp_path / "part.h5md")


def test_it_names_the_model_of_the_file(pliant, tmp_path):
    pliant("sample", PEPTIDE, "-o", "part.h5md", "--frames", 2, "--model", "molecule", *COMMON)
    ended = pliant("sample", "--continue", "part.h5md", "--frames", 3, "--json")
    assert json.loads(ended.out)["model"] == "molecule"
    ended = pliant("sample", "--continue", "part.h5md", "--frames", 4, "--verbose")
    assert "model           molecule: " in ended.out


def test_free_torsions_have_no_preferences(pliant, tmp_path):
    for name, options in (("held", []), ("free", ["--free-torsions"])):
        pliant("sample", PEPTIDE, "-o", f"{name}.h5md", "--frames", 2, *COMMON, *options)
        with h5py.File(tmp_path / f"{name}.h5md") as file:
            assert ("torsion_preferences" in file["parameters"]) is (name == "held")
    ended = pliant("sample", PEPTIDE, "--model", "angles", "--free-torsions")
    assert ended.code == 2
    assert "--free-torsions: goes with --model molecule or --model protein" in ended.err


def test_it_needs_no_other_file_and_says_what_it_added(pliant, tmp_path):
    (tmp_path / "in.pdb").write_bytes(PEPTIDE.read_bytes())
    pliant("sample", "in.pdb", "-o", "part.h5md", "--frames", 3, *COMMON)
    (tmp_path / "in.pdb").unlink()
    ended = pliant("sample", "--continue", "part.h5md", "--frames", 5, "--seed", 0)
    assert ended.code == 0, ended.err
    assert "frames          2 added by sampler modes; amplitude " in ended.out
    assert os.listdir(tmp_path) == ["part.h5md"]


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--seed", 5], "--seed: is 0 in the run of o.h5md, not 5; a run goes on as it began"),
        (["--amplitude", 1], "--amplitude: is 0.4 in the run of o.h5md, not 1; "
                             "a run goes on as it began"),
        (["--sampler", "turns"], "--sampler: is modes in the run of o.h5md, not turns; "
                                 "a run goes on as it began"),
        (["--model", "angles"], "--model: is protein in the run of o.h5md, not angles; "
                                "a run goes on as it began"),
        (["--assembly", 1], "--assembly: is none in the run of o.h5md, not 1; "
                            "a run goes on as it began"),
        (["--overwrite"], "--overwrite: does not go with --continue, which adds to o.h5md"),
        (["--frames", 2], "--frames 2: o.h5md has 3 frames already; "
                          "frames are counted from the start of the sample"),
        (["other.pdb"], "FILE: is cyclic_hexapeptide.pdb in the run of o.h5md, not other.pdb; "
                        "a run goes on as it began"),
        (["-o", "p.h5md"], "--output p.h5md: --continue adds to o.h5md itself"),
    ],
)  # fmt: skip  # a table: a row a line
def test_what_contradicts_the_file_is_refused(pliant, tmp_path, words, message):
    pliant("sample", PEPTIDE, "-o", "o.h5md", "--frames", 3, *COMMON)
    before = (tmp_path / "o.h5md").read_bytes()
    ended = pliant("sample", "--continue", "o.h5md", *words)
    assert (ended.code, ended.err) == (2, f"pliant: error: {message}\n")
    assert (tmp_path / "o.h5md").read_bytes() == before


def test_runs_and_samples_are_not_mixed_up(pliant, ethanol):
    pliant("run", ethanol, "-o", "run.h5md", "--steps", 3)
    pliant("sample", PEPTIDE, "-o", "sample.h5md", "--frames", 2, *COMMON)
    ended = pliant("sample", "--continue", "run.h5md")
    assert (ended.code, ended.err) == (
        1,
        "pliant: error: run.h5md: holds steps of a run: pliant run --continue and continue_run go "
        "on with them\n",
    )
    ended = pliant("run", "--continue", "sample.h5md")
    assert (ended.code, ended.err) == (
        1,
        "pliant: error: sample.h5md: holds frames of a sample: pliant sample --continue and "
        "continue_sample go on with them\n",
    )
    ended = pliant("sample", "--continue", "none.h5md")
    assert (ended.code, ended.err) == (1, "pliant: error: none.h5md: is not there\n")


@pytest.mark.parametrize("command", ["run", "sample"])
def test_what_was_ended_before_its_first_frame_is_named(pliant, tmp_path, command):
    (tmp_path / ".o.h5md.partial").write_bytes(b"as a killed writer leaves it")
    ended = pliant(command, "--continue", "o.h5md")
    assert (ended.code, ended.err) == (
        1,
        "pliant: error: o.h5md: is not there, but .o.h5md.partial is: its writer was ended before "
        "the first frame; begin anew\n",
    )


def test_a_file_without_nodes_is_reported(pliant, tmp_path):
    pliant("sample", PEPTIDE, "-o", "o.h5md", "--frames", 2, *COMMON)
    with h5py.File(tmp_path / "o.h5md", "r+") as file:
        del file["parameters/checkpoint"]
    ended = pliant("sample", "--continue", "o.h5md", "--frames", 9)
    assert ended.code == 1
    assert ended.err.startswith("pliant: error: o.h5md: has no checkpoint")


def test_a_sample_that_is_done_has_nothing_to_do(pliant, tmp_path):
    pliant("sample", PEPTIDE, "-o", "o.h5md", "--frames", 3, *COMMON)
    before = (tmp_path / "o.h5md").read_bytes()
    ended = pliant("sample", "--continue", "o.h5md")
    assert ended.code == 0
    assert "o.h5md has all of its 3 frames; --frames N goes on up to N in all" in ended.err
    assert (tmp_path / "o.h5md").read_bytes() == before


def test_frames_that_come_out_otherwise_are_not_added_to(pliant, tmp_path):
    """As if another version of Pliant, whose bits are others, had written the file."""
    pliant("sample", PEPTIDE, "-o", "o.h5md", "--frames", 3, *COMMON)
    with h5py.File(tmp_path / "o.h5md", "r+") as file:
        file["particles/trajectory/position/value"][-1, 0, 0] += 1e-9
    before = contents(tmp_path / "o.h5md")["particles/trajectory/position/value"]
    ended = pliant("sample", "--continue", "o.h5md", "--frames", 5, "--quiet")
    assert (ended.code, ended.err) == (
        1,
        f"pliant: error: {tmp_path}/o.h5md: the frame of step 2 is not what the run gives now: "
        "it was written by another version of Pliant\n",
    )
    after = contents(tmp_path / "o.h5md")["particles/trajectory/position/value"]
    assert np.array_equal(before, after)


def check_interruptions(command, tmp_path, times, seed):
    start = ["sample", str(PEPTIDE), "--frames", "250", "--threads", "1", *COMMON, "-o"]
    before = time.monotonic()
    subprocess.run([command, *start, "whole.h5md"], cwd=tmp_path, check=True)
    seconds = 1.5 * (time.monotonic() - before) / times
    words = [*start, "left.h5md"]

    def complete(steps):
        return np.array_equal(steps, np.arange(len(steps)))

    interrupt_again_and_again(command, tmp_path, words, times, seconds, seed, complete)
    assert_same_runs(tmp_path / "whole.h5md", tmp_path / "left.h5md")
    assert sorted(os.listdir(tmp_path)) == ["left.h5md", "whole.h5md"]


def test_interruptions_leave_no_trace(command, tmp_path):
    check_interruptions(command, tmp_path, 8, 1)


@pytest.mark.long
@pytest.mark.parametrize("seed", range(10))
def test_many_interruptions_leave_no_trace(command, tmp_path, seed):
    check_interruptions(command, tmp_path, 25, seed)


def test_redraws_and_contacts_are_recorded(pliant, tmp_path):
    """Counts of contacts by NumPy, from positions and the limits of the file."""
    pliant("sample", PEPTIDE, "-o", "m.h5md", "--frames", 20, "--amplitude", 1, "--quiet")
    options = (
        "--frames 20 --amplitude 1 --quiet --sampler dilute --contact-energy 9.6 --topology none"
    )
    pliant("sample", PEPTIDE, "-o", "d.h5md", *options.split())
    for name in ("m.h5md", "d.h5md"):
        found = contents(tmp_path / name)
        held, broken, off, redraws = (
            found[f"observables/{what}/value"]
            for what in ("contacts_held", "contacts_broken", "contacts_off", "redraws")
        )
        groups = found["parameters/limit/group"]
        assert groups.min() >= 0
        count = len(np.unique(groups))
        assert count > 0 and np.array_equal(held + broken + off, np.full(20, count))
        assert redraws.min() >= 0 and redraws.dtype == np.int64
        places = found["particles/trajectory/position/value"]
        ends = places[:, found["connectivity/limits"]]
        lengths = np.linalg.norm(ends[:, :, 1] - ends[:, :, 0], axis=2)
        out = (lengths > found["parameters/limit/most"] + 0.1) | (
            lengths < found["parameters/limit/least"] - 0.1
        )
        wrong = np.array([len(np.unique(groups[row])) for row in out])
        assert (broken == 0).all()  # such a frame is not written
        assert (wrong <= off).all()
        assert (off == 0).all() if name == "m.h5md" else off.max() > 0
        states = found["connectivity/contact_states/value"]
        for k, count in enumerate((held, broken, off)):
            assert np.array_equal((states == k).sum(axis=1), count)
        for c, group in enumerate(dict.fromkeys(groups.tolist())):
            is_out = out[:, groups == group].any(axis=1)
            assert (states[is_out, c] == 2).all()  # what is out of its interval is switched off
