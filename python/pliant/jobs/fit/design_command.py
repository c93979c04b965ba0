# SPDX-License-Identifier: MIT
"""The command ``pliant design``."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence

from pliant.base import console
from pliant.base.said import notes_shown_by
from pliant.jobs.fit.command import molecule_rows
from pliant.jobs.fit.design import design

DESCRIPTION = """\
Says which distances of a molecule to measure: those that tell most about the shapes in its reach,
each by what the ones before do not tell."""

EPILOG = """\
From START alone an ensemble is made. Pairs are more than 8 residues apart; residues are exposed
(no more neighbours within 10 A than half of them have), no GLY or PRO, for cross-links LYS alone.
"explained" is the share of the variance of all distances. It stops where a pair adds less than
0.1 %.

examples:
  pliant design open.pdb --distances 10
  pliant design open.pdb --method deer --exclude A:45,A:46
"""

#: options that --help shows
COMMON = ("--distances", "--method", "--exclude", "--frames", "--seed", "--select")


def make_parser() -> console.Parser:
    """The options of pliant design."""
    parser = console.Parser("design", DESCRIPTION, EPILOG, COMMON)
    add, number = parser.add_argument, console.whole_number
    add("start", metavar="START", help="PDB or mmCIF file of a protein or nucleic acid")
    text = "how many at most (default: 10)"
    add("--distances", metavar="N", type=number(1), default=10, help=text)
    text = "what can be seen: fret 20 to 80 A, deer 15 to 60, crosslink LYS up to 30 (default: any)"
    add("--method", choices=("any", "fret", "deer", "crosslink"), default="any", help=text)
    text = "residues that cannot be labelled, such as A:45,A:46"
    add("--exclude", metavar="NAMES", type=console.words, default=(), help=text)
    text = "frames of the ensemble (default: 400)"
    add("--frames", metavar="N", type=number(50), default=400, help=text)
    add("--seed", metavar="N", type=number(0), default=0, help="of the ensemble (default: 0)")
    console.add_rows(parser, molecule_rows())
    add("--json", action="store_true", help="print the result as one JSON object")
    return parser


def main(words: Sequence[str] | None = None) -> int:
    """Runs the command; returns its exit code."""
    arguments = make_parser().parse_args(words)
    return console.run_command("design", lambda: _design(arguments))


def _design(arguments: argparse.Namespace) -> int:
    with notes_shown_by(console.note):
        found = design(
            arguments.start,
            arguments.distances,
            method=arguments.method,
            exclude=arguments.exclude,
            frames=arguments.frames,
            seed=arguments.seed,
            **console.given(arguments, molecule_rows()),
        )
    if arguments.json:
        console.print_json(found.as_json())
    else:
        for label, text in found.facts():
            print(f"{label:23s} {text}")
    return console.EXIT_OK


if __name__ == "__main__":
    sys.exit(main())
