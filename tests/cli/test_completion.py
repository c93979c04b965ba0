# SPDX-License-Identifier: MIT
"""pliant --completion: what bash, zsh and fish themselves make of the scripts."""

import os
import shutil
import subprocess
from pathlib import Path

import pytest

COMMANDS = ("info", "run", "sample", "lab", "rigidity", "analyse")


def shell(name, *words, script):
    if shutil.which(name) is None:
        pytest.skip(f"{name} is not installed")
    done = subprocess.run(
        [name, *words, script],
        capture_output=True,
        text=True,
        check=False,
        timeout=900,
        env={**os.environ, "HOME": "/nonexistent"},
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def in_bash(command, *words):
    """What bash offers for the last of the words."""
    folder = Path(command).parent
    line = " ".join(f"'{word}'" for word in ("pliant", *words))
    return shell(
        "bash",
        "--norc",
        "-c",
        script=f"PATH={folder}:$PATH; source <(pliant --completion bash) || exit 1; "
        f"COMP_WORDS=({line}); COMP_CWORD={len(words)}; _pliant; "
        'printf "%s\\n" "${COMPREPLY[@]}"',
    ).split()


def test_bash_completes_commands(command):
    assert in_bash(command, "ru") == ["run"]
    assert set(COMMANDS) <= set(in_bash(command, ""))
    assert in_bash(command, "--comp") == ["--completion"]


@pytest.mark.parametrize(
    ("words", "options"),
    [
        (("run", "--max-s"), ["--max-sweeps"]),
        (("run", "in.pdb", "--max-i"), ["--max-input"]),
        (("sample", "--amp"), ["--amplitude"]),
        (("analyse", "--super"), ["--superpose"]),
        (("analyse", "--out"), ["--output"]),
        (("lab", "bench", "work-precision", "--no-s"), []),
    ],
)
def test_bash_completes_options(command, words, options):
    assert in_bash(command, *words) == options


def test_bash_completes_subcommands(command):
    assert in_bash(command, "lab", "tech") == ["techniques"]
    assert in_bash(command, "lab", "bench", "thr") == ["throughput"]
    assert "--sizes" in in_bash(command, "lab", "bench", "step", "--")


def test_every_option_of_a_help_is_offered(command):
    text = subprocess.run([command, "run", "--help-all"], capture_output=True, text=True).stdout
    lines = [line for line in text.splitlines() if line.startswith("  -")]
    words = [word for line in lines for word in line.split()[0].split(",")]
    options = {word for word in words if word.startswith("--")}
    assert len(options) > 30
    assert set(in_bash(command, "run", "--")) == options


def test_zsh_takes_it(command):
    folder = Path(command).parent
    script = (
        f"PATH={folder}:$PATH; autoload -U compinit && compinit -D; "
        "source <(pliant --completion zsh) && _pliant_options pliant run; "
        "print -l ${_comps[pliant]}; _pliant_subcommands pliant lab bench"
    )
    said = shell("zsh", "-f", "-c", script=script).split()
    assert {"--max-sweeps", "_pliant", "throughput"} <= set(said)


def test_fish_completes(command):
    folder = Path(command).parent
    script = (
        f"set -x PATH {folder} $PATH; pliant --completion fish | source; "
        'complete -C "pliant ru"; complete -C "pliant run --max-s"; '
        'complete -C "pliant lab bench thr"'
    )
    said = [line.split("\t")[0] for line in shell("fish", "-c", script=script).splitlines()]
    assert said == ["run", "--max-sweeps", "throughput"]


def test_another_shell_is_refused(pliant):
    ended = pliant("--completion", "tcsh")
    assert (ended.code, ended.err) == (
        2,
        'pliant: error: no shell named "tcsh"; known: bash, zsh, fish\n',
    )
    ended = pliant("--completion")
    assert (ended.code, ended.err) == (
        2,
        "pliant: error: --completion: expected bash, zsh or fish after it\n",
    )
