# SPDX-License-Identifier: MIT
"""``pliant lab bench``: run time against error and size, steps, hard cases, ensembles."""

from __future__ import annotations

import argparse
import importlib
import pkgutil
import sys
from collections.abc import Sequence
from types import ModuleType

from pliant.base import console
from pliant.lab.bench import subcommands

EPILOG = """\
pliant lab bench SUBCOMMAND --help explains each.

examples:
  pliant lab bench work-precision protein.pdb -o race.png
  pliant lab bench throughput protein.pdb
  pliant lab bench validity
  pliant lab bench coverage --data pairs
"""


def modules() -> dict[str, ModuleType]:
    """The subcommands by their names, in the order of the help."""
    names = [row.name for row in pkgutil.iter_modules(subcommands.__path__)]
    found = [importlib.import_module(f"{subcommands.__name__}.{name}") for name in names]
    found.sort(key=lambda module: int(module.ORDER))
    return {module.__name__.rpartition(".")[2].replace("_", "-"): module for module in found}


def make_parser() -> console.Parser:
    """What pliant lab bench itself takes: the name of a subcommand."""
    known = modules()
    width = max(map(len, known))
    rows = "\n".join(f"  {name.ljust(width)}  {row.SUMMARY}" for name, row in known.items())
    parser = console.Parser(
        "lab bench",
        "Measures Pliant, with OpenMM's CCMA in the same run. Trust the ratios within one run:\n"
        "times depend on the machine and on its other load.\n\n"
        f"subcommands:\n{rows}",
        EPILOG,
    )
    parser.add_argument("subcommand", metavar="SUBCOMMAND", help="one of the above")
    parser.add_argument(
        "words", metavar="...", nargs=argparse.REMAINDER, help="options of the subcommand"
    )
    return parser


def main(words: Sequence[str] | None = None) -> int:
    """Runs the command; returns its exit code."""
    words = list(sys.argv[1:] if words is None else words)
    parser = make_parser()
    if not words or words[0].startswith("-"):
        parser.parse_args(words)
    known = modules()
    if words[0] not in known:
        parser.error(f"unknown subcommand '{words[0]}'; known: {', '.join(known)}")
    return _run(words[0], known[words[0]], words[1:])


def _run(name: str, row: ModuleType, words: list[str]) -> int:
    parser = console.Parser(f"lab bench {name}", row.DESCRIPTION, row.EPILOG)
    row.add_options(parser)
    parser.add_argument("--json", action="store_true", help="print the result as one JSON object")
    parser.add_argument("--quiet", action="store_true", help="show no progress")
    arguments = parser.parse_args(words)
    return console.run_command(f"lab bench {name}", lambda: int(row.run(arguments)))


if __name__ == "__main__":
    sys.exit(main())
