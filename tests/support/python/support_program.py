# SPDX-License-Identifier: MIT
"""Runs the small C++ programs of tests/support, which show parts of the library to Python tests."""

import json
import os
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]


def program(name: str) -> Path:
    """The newest build of a program; PLIANT_BUILD names another build folder."""
    folders = [os.environ["PLIANT_BUILD"]] if "PLIANT_BUILD" in os.environ else ["build", "build/*"]
    found = [path for folder in folders for path in ROOT.glob(f"{folder}/tests/support/{name}")]
    if not found:
        raise FileNotFoundError(f"{name} is not built: ./dev test builds it")
    return max(found, key=lambda path: path.stat().st_mtime)


def answers(name: str, words: list[str], questions: list) -> list[str]:
    """One line for each question, from one run of the program."""
    run = subprocess.run(
        [str(program(name)), *map(str, words)],
        input="".join(f"{question}\n" for question in questions),
        capture_output=True,
        text=True,
        check=True,
    )
    lines = run.stdout.splitlines()
    assert len(lines) == len(questions)
    return lines


def ask(words: list[str], questions: list) -> list[dict]:
    """One answer of pliant_print_bonds, which tells what the library makes of molecule files, for
    each question."""
    return [json.loads(line) for line in answers("pliant_print_bonds", words, questions)]


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
