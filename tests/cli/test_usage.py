# SPDX-License-Identifier: MIT
"""Wrong calls: one line that names the option and what was expected, exit code 2, no output."""

import os
import stat

import pytest


def test_no_command_prints_usage_and_fails(pliant):
    ended = pliant()
    assert ended.code == 2
    assert ended.out == ""
    assert ended.err.startswith("pliant: molecular flexibility")


def test_version(pliant):
    ended = pliant("--version")
    assert (ended.code, ended.err) == (0, "")
    assert ended.out.startswith("pliant 1.")


def test_unknown_command_suggests_the_nearest(pliant):
    ended = pliant("inffo")
    assert ended.code == 2
    assert ended.err == (
        'pliant: no command named "inffo" (did you mean "info"?); '
        "known: study, sample, conformers, analyse, rigidity, path, fit, design, run, "
        "compare, check, ensemble, play, watch, info, contacts, convert, lab\n"
    )


def test_a_name_of_before_says_what_does_its_work_now(pliant):
    for old, now in (("demo", "pliant study --demo"), ("bench", "pliant lab bench")):
        ended = pliant(old, "--help")
        assert (ended.code, ended.err) == (2, f"pliant: error: {old}: is {now} now\n")


def test_the_laboratory_knows_its_commands(pliant):
    ended = pliant("lab", "tecniques")
    assert ended.code == 2
    assert ended.err == (
        'pliant: error: no command of pliant lab named "tecniques" (did you mean "techniques"?); '
        "known: bench, experiment, structgen, forcegen, order, techniques\n"
    )
    assert pliant("lab").code == 2


def test_a_program_on_path_is_a_command(pliant, tmp_path):
    program = tmp_path / "pliant-hello"
    program.write_text('#!/bin/sh\necho "hello $1"\nexit 7\n')
    program.chmod(program.stat().st_mode | stat.S_IXUSR)
    path = f"{tmp_path}:{os.environ['PATH']}"
    ended = pliant("hello", "there", env={**os.environ, "PATH": path})
    assert (ended.code, ended.out) == (7, "hello there\n")


def test_unknown_option_suggests_the_nearest(pliant, ethanol):
    ended = pliant("run", ethanol, "--step", "3")
    assert ended.code == 2
    assert 'unexpected argument "--step" (did you mean --steps?)' in ended.err


#: options of pliant run, what they expect, and what is refused
NUMBERS = {
    "--steps": ("a whole number from 0", ["-5", "3.7", "99999999999999999999", "", "10 "]),
    "--tolerance": ("a number above 0", ["0", "nan", "1e-400", "1,5"]),
    "--threads": ("a whole number from 1 to 4096", ["0", "100000"]),
    "--seed": ("a whole number from 0 to 18446744073709551615", [str(2**64)]),
}


@pytest.mark.parametrize(
    ("option", "value"), [(name, value) for name, row in NUMBERS.items() for value in row[1]]
)
def test_numbers_are_checked(pliant, ethanol, option, value):
    ended = pliant("run", ethanol, option, value)
    assert ended.code == 2
    assert f'{option}: expected {NUMBERS[option][0]}, found "{value}"' in ended.err
    assert not ethanol.with_suffix(".h5md").exists()


def test_seed_is_64_bits(pliant, ethanol):
    assert pliant("run", ethanol, "--steps", 1, "--seed", 2**64 - 1).code == 0


def test_an_option_given_twice_is_refused(pliant, ethanol):
    ended = pliant("run", ethanol, "--steps", "10", "--steps", "20")
    assert ended.code == 2
    assert "--steps" in ended.err


@pytest.mark.parametrize(
    ("option", "nearest"),
    [("--technique", "bfs_cycle"), ("--perturb", "force"), ("--bars", "bonds")],
)
def test_choices_suggest_the_nearest(pliant, ethanol, option, nearest):
    ended = pliant("run", ethanol, option, nearest[:-1])
    assert ended.code == 2
    assert f'did you mean "{nearest}"?' in ended.err
