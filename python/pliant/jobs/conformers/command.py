# SPDX-License-Identifier: MIT
"""The command ``pliant conformers``, to which ``pliant sample`` hands small molecules over."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

from pliant._core import FileError, InputError, OptionError
from pliant.adapters.smiles import parsed_smiles
from pliant.base import console
from pliant.base.extras import need
from pliant.base.processes import ended_by_signals
from pliant.jobs.conformers.journal import Journal
from pliant.jobs.conformers.library import Source, begin, complete, resume
from pliant.jobs.conformers.options import ROWS, ConformerOptions
from pliant.jobs.conformers.records import LIGANDS, SMILES, format_of
from pliant.jobs.conformers.report import lines_of
from pliant.jobs.conformers.workers import Outcome

EXIT_SOME_FAILED = 3
COMMON = ("--output", "--max", "--rms", "--energy", "--embed", "--smiles", "--continue")
DESCRIPTION = """\
Makes conformers of small molecules: a library in, ranked and pruned conformers out, as one SDF
with the names and data items of the molecules. Candidates are drawn from several starts (torsions,
rings, large rings closed), without overlaps; those that are alike are left out. Lengths and angles
are those of the start (angles in puckered rings change), unless a force field minimises
(--minimise)."""

EPILOG = """\
FILE is an SDF or MOL file (V2000, V3000) in 3-D with hydrogens, of any number of records, or lines
of a SMILES and a name (.smi), which RDKit makes 3-D; each also as .gz, .bz2 or .xz. Of a salt the
largest molecule is kept. A record that cannot be used is named with the reason, and the rest goes
on.

FILE may also be the PDB, mmCIF or XYZ file of one ligand. Bond orders are those of the file
(chem_comp_bond of mmCIF, doubled CONECT of PDB). Where it has none, RDKit guesses them from the
hydrogens, if all are there. With --smiles TEXT, bond orders, charges and hydrogens are those of the
SMILES, and heavy atoms stay where they are. A SMILES of another molecule or isomer is refused.
--select takes the ligand out of a complex. It and the other options under Molecule and Model go
with the file of one ligand.

The output does not depend on --threads; after a kill --continue gives the same bytes.

Each conformer has the data items pliant_conformer (from 1, lowest energy first), pliant_start,
pliant_energy with pliant_energy_name, pliant_worst_bar (largest error of a held length), where
axes cannot turn pliant_axes (P or M of each), and pliant_start_positions with the first conformer
of each start, whose lengths it keeps.

Exit codes: 0 done, 1 bad input or file, 2 bad option, 3 some records failed, 130 ended by Ctrl-C.

examples:
  pliant conformers library.sdf -o out.sdf
  pliant conformers library.smi.gz -o out.sdf.gz --max 20 --window 10
  pliant conformers --smiles "CC(=O)Oc1ccccc1C(=O)O" -o aspirin.sdf
  pliant conformers drawings.sdf --embed -o out.sdf --energy MMFF94s --minimise
  pliant conformers ligand.pdb --smiles "CC(=O)Oc1ccccc1C(=O)O" -o out.sdf
  pliant conformers complex.pdb --select "resname STI" --smiles TEXT -o out.sdf
  pliant conformers --continue out.sdf              after Ctrl-C or a crash
  pliant conformers library.sdf --shard 3/16 -o part03.sdf     on the 3rd of 16 machines
"""


def make_parser() -> console.Parser:
    """The options of pliant conformers."""
    parser = console.Parser("conformers", DESCRIPTION, EPILOG, COMMON)
    add = parser.add_argument
    text = "SDF, MOL or SMILES file; PDB, mmCIF or XYZ file of one ligand"
    add("file", metavar="FILE", nargs="?", help=text)
    text = "SDF to write, or .sdf.gz (default: FILE's name-conformers.sdf)"
    add("-o", "--output", metavar="FILE", help=text)
    text = "continue an unfinished output; the result is as if it had never stopped"
    add("--continue", dest="go_on", metavar="FILE", help=text)
    console.add_rows(parser, ROWS)
    text = "only each n-th record from the i-th on, to share a library among machines"
    add("--shard", metavar="i/n", type=_shard, default=(1, 1), help=text)
    add("--overwrite", action="store_true", help="replace an existing or unfinished output")
    add("--json", action="store_true", help="print the summary as one JSON object")
    add("--quiet", action="store_true", help="print nothing but errors")
    add("--verbose", action="store_true", help="print notes on each molecule")
    return parser


def _shard(text: str) -> tuple[int, int]:
    first, _, of = text.partition("/")
    if first.isdecimal() and of.isdecimal() and 1 <= int(first) <= int(of):
        return int(first), int(of)
    raise argparse.ArgumentTypeError(f"expected i/n with i from 1 to n, found '{text}'")


def main(words: Sequence[str] | None = None) -> int:
    """Runs the command; returns its exit code."""
    parser = make_parser()
    arguments = parser.parse_args(words)
    return console.run_command("conformers", lambda: _conformers(arguments))


def _conformers(arguments: argparse.Namespace) -> int:
    journal = _resumed(arguments) if arguments.go_on is not None else _begun(arguments)
    is_quiet = arguments.quiet or arguments.json
    total, done = journal.asked["records"], len(journal.outcomes)

    def on_done(outcome: Outcome) -> None:
        nonlocal done
        done += 1
        show(done, total)
        if not arguments.json:
            _say(outcome, arguments.verbose)

    try:
        with (
            ended_by_signals("conformers"),
            console.progress("molecules", is_quiet, rate=True) as show,
        ):
            found = complete(journal, arguments.threads, on_done)
    except (KeyboardInterrupt, SystemExit):
        again = f"pliant conformers --continue {console.printable_name(journal.output)}"
        print(f"{again} goes on", file=sys.stderr)
        raise
    if arguments.json:
        console.print_json(found.as_json())
    elif not arguments.quiet and found.conformers:
        print("\n".join(lines_of(found)))
    if not found.conformers:
        print("pliant conformers: error: no record gave a conformer", file=sys.stderr)
        return console.EXIT_FAILED
    return EXIT_SOME_FAILED if found.failed else console.EXIT_OK


def _begun(arguments: argparse.Namespace) -> Journal:
    given = console.given(arguments, ROWS)
    kind = arguments.file and format_of(arguments.file, given.get("format"))
    is_ligand = kind in LIGANDS
    smiles = given.pop("smiles", None) if arguments.file is None else None
    if arguments.file is None and smiles is None:
        raise OptionError("expected FILE or --smiles TEXT, or --continue FILE")
    options = ConformerOptions("--", **given)
    options.check_energy()
    options.check_source(is_ligand=is_ligand)
    output = _output(arguments)
    source = Source(arguments.file or "", smiles or "", arguments.shard)
    if is_ligand:
        need("a PDB, mmCIF or XYZ file", "rdkit")
    elif smiles is not None or kind in SMILES:
        need("a SMILES", "rdkit")
    if arguments.smiles is not None:
        _check_smiles(arguments.smiles)
    if options.embed:
        need("--embed", "rdkit")
    return begin(source, options, output, arguments.overwrite)


def _check_smiles(text: str) -> None:
    try:
        parsed_smiles(text)
    except InputError as error:
        raise OptionError(f"--smiles: {error}") from None


def _output(arguments: argparse.Namespace) -> Path:
    if arguments.output is None:
        if arguments.file is None:
            raise OptionError("--smiles: needs --output FILE.sdf")
        name = Path(arguments.file).name
        return Path(name[: name.lower().rindex(format_of(name))] + "-conformers.sdf")
    output = Path(arguments.output)
    if format_of(output) != ".sdf" or output.suffix.lower() not in (".sdf", ".gz"):
        raise OptionError(f"--output {output}: expected a name that ends in .sdf or .sdf.gz")
    if not output.parent.is_dir():
        raise FileError(f"--output {output}: there is no folder {output.parent}")
    return output


def _resumed(arguments: argparse.Namespace) -> Journal:
    free = ("go_on", "threads", "json", "quiet", "verbose")
    if given := make_parser().given_besides(arguments, free):
        raise OptionError(f"{given}: --continue goes on with what was asked for before")
    return resume(Path(arguments.go_on))


def _say(outcome: Outcome, is_verbose: bool) -> None:
    for text in [outcome.reason] if outcome.reason else outcome.warnings:
        console.warn(f"{outcome.called}: {text}")
    for text in outcome.notes if is_verbose else ():
        console.note(f"{outcome.called}: {text}")


if __name__ == "__main__":
    sys.exit(main())
