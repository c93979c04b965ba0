# SPDX-License-Identifier: MIT
"""``pliant bench``: run time against error, against size, auto, runs, stress and more."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence

from pliant import console
from pliant.lab.bench.run_subcommands import RUN_SUBCOMMANDS
from pliant.lab.bench.subcommands import SUBCOMMANDS, Subcommand

ALL_SUBCOMMANDS = (*SUBCOMMANDS, *RUN_SUBCOMMANDS)

EPILOG = """\
pliant bench SUBCOMMAND --help tells more of each.

examples:
  pliant bench work-precision protein.pdb --png race.png
  pliant bench scaling --sizes 1e3,1e4,1e5
  pliant bench throughput protein.pdb
  pliant bench auto
  pliant bench record
  pliant bench stress
"""


def make_parser() -> console.Parser:
    """What pliant bench itself takes: the name of a subcommand."""
    width = max(len(row.name) for row in ALL_SUBCOMMANDS)
    rows = "\n".join(f"  {row.name.ljust(width)}  {row.summary}" for row in ALL_SUBCOMMANDS)
    parser = console.Parser(
        "bench",
        "Measures Pliant, with OpenMM's CCMA in the same run. Ratios within one run are what to\n"
        "trust: times depend on the machine, and on what else it does.\n\n"
        f"subcommands:\n{rows}",
        EPILOG,
    )
    parser.add_argument("subcommand", metavar="SUBCOMMAND", help="one of the above")
    parser.add_argument("words", metavar="...", nargs=argparse.REMAINDER,
        help="options of the subcommand")  # fmt: skip
    return parser


def main(words: Sequence[str] | None = None) -> int:
    """Runs the command; returns its exit code."""
    words = list(sys.argv[1:] if words is None else words)
    parser = make_parser()
    if not words or words[0].startswith("-"):
        parser.parse_args(words)
    rows = {row.name: row for row in ALL_SUBCOMMANDS}
    if words[0] not in rows:
        parser.error(f"unknown subcommand '{words[0]}'; known: {', '.join(rows)}")
    return _run(rows[words[0]], words[1:])


def _run(row: Subcommand, words: list[str]) -> int:
    parser = console.Parser(f"bench {row.name}", row.description, row.epilog)
    row.add_options(parser)
    parser.add_argument("--json", action="store_true", help="print the result as one JSON object")
    parser.add_argument("--quiet", action="store_true", help="show no progress")
    arguments = parser.parse_args(words)
    return console.run_command(f"bench {row.name}", lambda: row.run(arguments))


if __name__ == "__main__":
    sys.exit(main())
