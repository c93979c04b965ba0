# SPDX-License-Identifier: MIT
"""--dry-run: what is bad is reported, and nothing is made."""

import pytest


@pytest.mark.parametrize("command", ["run", "sample"])
def test_nothing_is_made(pliant, ethanol, tmp_path, command):
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
def test_what_is_bad_is_reported(pliant, ethanol, command, words, code, message):
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
