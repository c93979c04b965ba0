# SPDX-License-Identifier: MIT
"""``pliant lab bench``: run time against error and size, steps, hard cases, ensembles."""

from __future__ import annotations

import argparse
import importlib
import sys
from collections.abc import Sequence

from pliant.base import console
from pliant.base.extras import need
from pliant.lab.bench import subcommands
from pliant.lab.results import Results, write_csv

#: Modules of ``subcommands``, in the order of the help.
BENCHES = {
    "work-precision": "run time against error: every technique and OpenMM on one broken molecule",
    "throughput": "conformers made whole per second, on one thread and on several",
    "stress": "every technique on hard cases: far, tiny, huge, redundant, impossible",
    "step": "cost of a step after a push of one joint, in small and in large molecules",
    "reading": "what MDAnalysis takes to read a frame of ours, and one of DCD",
    "study": "what a study takes, stage by stage",
    "validity": "sampled ensembles beside NMR, MD, crystals and known motions, with ANM and GNM",
    "coverage": "whether the ensemble of one known structure contains the other, with ANM",
    "fit": "how near fits to distances of the other structure of a pair come to it",
    "domains": "whether reported domains repeat between seeds, and are those of known pairs",
    "conformers": "conformers of small molecules beside ETKDGv3 (RDKit) and CONFORGE (CDPKit)",
}

COMMON = ("csv", "output", "json", "quiet", "help_all")  #: options of all benches

EPILOG = """\
pliant lab bench SUBCOMMAND --help explains each.

examples:
  pliant lab bench work-precision protein.pdb -o race.png
  pliant lab bench throughput protein.pdb
  pliant lab bench stress
  pliant lab bench validity
  pliant lab bench coverage --data pairs
"""


def make_parser() -> console.Parser:
    """What pliant lab bench itself takes: the name of a subcommand."""
    width = max(map(len, BENCHES))
    rows = "\n".join(f"  {name.ljust(width)}  {summary}" for name, summary in BENCHES.items())
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
    if words[0] not in BENCHES:
        parser.error(f"unknown subcommand '{words[0]}'; known: {', '.join(BENCHES)}")
    return console.run_command(f"lab bench {words[0]}", lambda: _run(words[0], words[1:]))


def _run(name: str, words: list[str]) -> int:
    bench = importlib.import_module(f"{subcommands.__name__}.{name.replace('-', '_')}")
    parser = console.Parser(f"lab bench {name}", bench.DESCRIPTION, bench.EPILOG)
    for option, how in bench.OPTIONS.items():
        parser.add_argument(option, **how)
    parser.add_argument("--csv", metavar="FILE", help="write the rows as CSV")
    if hasattr(bench, "PICTURE"):
        text = f"draw {bench.PICTURE[1]} (PNG)"
        parser.add_argument("-o", "--output", metavar="FILE", help=text)
    parser.add_argument("--json", action="store_true", help="print the result as one JSON object")
    parser.add_argument("--quiet", action="store_true", help="show no progress")
    given = vars(parser.parse_args(words))
    picture = given.get("output")
    if picture:
        need("a picture of pliant lab bench", "matplotlib", extra="lab")
    with console.progress(name, given["quiet"] or given["json"]) as show:
        own = {option: value for option, value in given.items() if option not in COMMON}
        found: Results = bench.measure(**own, progress=show)
    if given["csv"]:
        write_csv(found.rows, given["csv"])
    if picture:
        importlib.import_module(bench.PICTURE[0]).draw(found, picture)
    console.print_json(found.as_json()) if given["json"] else found.print_report()
    return console.EXIT_FAILED if found.faults else console.EXIT_OK


if __name__ == "__main__":
    sys.exit(main())
