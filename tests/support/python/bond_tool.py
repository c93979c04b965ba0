# SPDX-License-Identifier: MIT
"""Asks the C++ library, through pliant_print_bonds, what it makes of molecule files."""

import json

from support_program import ROOT, answers

__all__ = ["ROOT", "ask", "bonds", "differences"]


def ask(words: list[str], questions: list) -> list[dict]:
    """One answer for each question, from one run of the program."""
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
