# SPDX-License-Identifier: MIT
"""The subcommand ``pliant analyse``: figures, tables and a report page of a trajectory."""

from __future__ import annotations

import argparse
import sys
import warnings
from collections.abc import Callable, Sequence
from pathlib import Path

from pliant._core import OptionError
from pliant.base.console import (
    EXIT_OK,
    MOST_PROCESSES,
    Parser,
    note,
    print_json,
    run_command,
    stages,
    whole_number,
)
from pliant.report.build import Report, print_lines
from pliant.trajectory.freed_memory import give_back_freed_memory
from pliant.trajectory.shards.plan import is_ensemble

DESCRIPTION = """\
Analyses a trajectory and writes figures (PNG), tables (CSV) and one page, report.html, which
opens in a browser without a network and shows the molecule moving.

It shows how flexible each residue is, with an error; which parts move together; collective
motions; for sampler reach or pocket, what else the molecule could look like: shapes, what turned
about which hinges, pockets that opened; contacts kept and lost; and whether the stereochemistry is
sound: bond angles, chirality, planar groups, peptide bonds, Ramachandran, overlaps, and every bar
(fixed distance) of every frame.

It takes any trajectory that MDAnalysis reads. What cannot be computed from a file is left out,
and the page says so. The folder also holds files for other programs: flexibility.csv,
bfactors.pdb, modes.nmd (ProDy, VMD), shapes.pdb, ensemble.pdb with scripts for PyMOL and
ChimeraX."""

EPILOG = """\
examples:
  pliant analyse caffeine.h5md
  pliant analyse adk.h5md -o adk-report --select "not name H*"
  pliant analyse adk.h5md --distance "resid 55" "resid 169"
  pliant sample adk.pdb --sampler reach -o far.h5md && pliant analyse far.h5md
  pliant analyse run.xtc --topology run.pdb --superpose "name CA" --frames 100::10
  pliant analyse out.h5md --superpose "name CA and resid 8:14 80:90" --representatives 10
  pliant analyse many --workers 2          the folder of pliant ensemble

For the folder of pliant ensemble, which may be larger than memory, it reports the flexibility of
residues with errors, collective motions, contacts, clusters, and whether two halves agree.
Torsions, stereochemistry, domains, shapes and report.html are left out. Only -o, --workers and the
output options can be given.

MDAnalysis selections: "protein and name CA", "resid 10:50", "not name H*", "index 0:99".
Exit code: 0 analysed (even if bonds are off: see the verdict, or --json),
1 the input cannot be read, 2 wrong usage."""

#: options that an ensemble heeds; any other is refused
WITH_ENSEMBLE = ("file", "output", "workers", "dpi", "json", "quiet")
#: options that --help shows
COMMON = ("--output", "--topology", "--select", "--superpose", "--distance", "--representatives")


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs the subcommand with a list of arguments (default: sys.argv); returns the exit code."""
    options = _parser().parse_args(arguments)
    give_back_freed_memory()
    return run_command("analyse", lambda: _analyse(options))


def _parser() -> Parser:
    parser = Parser("analyse", DESCRIPTION, EPILOG, COMMON)
    add = parser.add_argument
    add(
        "file",
        metavar="FILE",
        help="trajectory of pliant sample or run (H5MD), or of another program; or the folder of\n"
        "an ensemble",
    )
    text = "folder for the results (default: FILE's name with -report)"
    add("-o", "--output", metavar="DIR", help=text)
    text = "file of atoms and bonds, if FILE holds none (PDB, GRO, PSF ...)"
    add("--topology", metavar="FILE", help=text)
    _add_choice_of_atoms(parser.add_argument_group("atoms").add_argument)
    _add_choice_of_frames(parser.add_argument_group("frames").add_argument)
    _add_output(parser.add_argument_group("output").add_argument)
    return parser


def _add_choice_of_atoms(add: Callable[..., object]) -> None:
    add("--select", metavar="SELECTION", default="all", help="atoms to analyse (default: all)")
    add(
        "--superpose",
        metavar="SELECTION",
        help="atoms to superpose, also used for the PCA (default: CA and P atoms if they form "
        "chains, else all but hydrogens)",
    )
    add(
        "--reference",
        metavar="FILE",
        help="structure to compare frames with (default: the PDB that run and sample write beside "
        "FILE, else the first frame)",
    )
    text = "measure the distance of the centres of two selections; may be given again"
    add("--distance", nargs=2, metavar=("A", "B"), action="append", default=[], help=text)
    add("--mass-weighted", action="store_true", help="weigh the PCA by mass")


def _add_choice_of_frames(add: Callable[..., object]) -> None:
    text = "frames to analyse, numbered from 0: 100:200, 100: or ::10 (default: all)"
    add("--frames", type=_slice, metavar="START:STOP:STEP", default=slice(None), help=text)
    text = "number of processes; more than 1 is worth it only for gigabytes (default: 1)"
    add("--workers", type=whole_number(1, most=MOST_PROCESSES), default=1, metavar="N", help=text)


def _slice(text: str) -> slice:
    """ "100:200:2" as Python takes it."""
    try:
        first, colon, rest = text.partition(":")
        stop, _, step = rest.partition(":")
        parts = [int(part) if part else None for part in (first, stop, step)]
        if not colon or parts[2] == 0:
            raise ValueError
    except ValueError:
        expected = "expected START:STOP:STEP, such as 100:200 or ::10"
        raise argparse.ArgumentTypeError(f"{expected}, found {text!r}") from None
    return slice(*parts)


def _add_output(add: Callable[..., object]) -> None:
    text = "also write N frames that represent all others as representatives.pdb"
    add("-k", "--representatives", type=whole_number(1), metavar="N", help=text)
    text = "resolution of the figures, dots per inch (default: 150)"
    add("--dpi", type=whole_number(50, most=1200), default=150, metavar="N", help=text)
    add("--json", action="store_true", help="print the results as one JSON object")
    add("--quiet", action="store_true", help="print nothing but errors")


def _analyse_ensemble(options: argparse.Namespace) -> int:
    from pliant.report.save import save
    from pliant.report.shards.sections import SECTIONS
    from pliant.shards.flexibility import flexibility
    from pliant.trajectory.shards.plan import folder_of

    if given := _parser().given_besides(options, WITH_ENSEMBLE):
        raise OptionError(f"{given}: goes with one file, not with an ensemble")
    folder = folder_of(Path(options.file))
    output = Path(options.output or f"{folder.absolute().name}-report")
    with stages(options.quiet) as on_stage:
        report = Report(flexibility(folder, options.workers, on_stage), SECTIONS)
        on_stage("figure")
        saved = save(report, output, options.dpi)
    if options.json:
        outputs = saved.as_json(files="models")
        print_json({"ensemble": str(folder), **report.values, "outputs": outputs})
    elif not options.quiet:
        print_lines([*report.lines(), *saved.lines()])
    return EXIT_OK


def _analyse(options: argparse.Namespace) -> int:
    if is_ensemble(options.file):
        return _analyse_ensemble(options)
    # Imported here, so that --help and errors of usage are immediate.
    from pliant.report.suite import analyse

    with warnings.catch_warnings(), stages(options.quiet) as on_stage:
        warnings.simplefilter("ignore")
        report = analyse(
            options.file,
            options.output or f"{Path(options.file).stem}-report",
            topology=options.topology,
            select=options.select,
            superpose=options.superpose,
            mass_weighted=options.mass_weighted,
            reference=options.reference,
            distances=[(a, b) for a, b in options.distance],
            start=options.frames.start,
            stop=options.frames.stop,
            step=options.frames.step,
            representatives=options.representatives,
            workers=options.workers,
            dpi=options.dpi,
            on_stage=on_stage,
        )
    if options.json:
        print_json(report.as_json())
    elif not options.quiet:
        for text in report.analysis.cautions:
            note(text)
        for name, why in report.analysis.skipped.items():
            note(f"no {name}: {why}")
        print_lines(report.facts())
    return EXIT_OK


if __name__ == "__main__":
    sys.exit(main())
