# SPDX-License-Identifier: MIT
"""Asks the C++ library, through pliant_print_bonds, what it makes of molecule files."""

import json
import os
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def program() -> Path:
    """The newest build of pliant_print_bonds; PLIANT_BUILD names another build folder."""
    folders = [os.environ["PLIANT_BUILD"]] if "PLIANT_BUILD" in os.environ else ["build", "build/*"]
    found = [
        path
        for folder in folders
        for path in ROOT.glob(f"{folder}/tests/support/pliant_print_bonds")
    ]
    if not found:
        raise FileNotFoundError("pliant_print_bonds is not built: ./dev test builds it")
    return max(found, key=lambda path: path.stat().st_mtime)


def ask(words: list[str], questions: list) -> list[dict]:
    """One answer for each question, from one run of the program."""
    run = subprocess.run(
        [str(program()), *map(str, words)],
        input="".join(f"{question}\n" for question in questions),
        capture_output=True,
        text=True,
        check=True,
    )
    return [json.loads(line) for line in run.stdout.splitlines()]


def bonds(files: list) -> list[dict]:
    """For each file its "labels" and, as a set of pairs (a, b) with a < b, its "pairs"."""
    answers = ask(["bonds"], files)
    for file, answer in zip(files, answers, strict=True):
        if "error" in answer:
            raise AssertionError(f"{file}: {answer['error']}")
        answer["pairs"] = {(a, b) for a, b, _ in answer["bonds"]}
    return answers


def differences(labels: list[str], ours: set, theirs: set) -> list[str]:
    """Each bond that only one of two has, as text."""
    return [
        f"{labels[a]} - {labels[b]}: {who} only"
        for who, pairs in [("ours", ours - theirs), ("theirs", theirs - ours)]
        for a, b in sorted(pairs)
    ]
