# SPDX-License-Identifier: MIT
"""The command ``pliant path``."""

from __future__ import annotations

import argparse
import csv
import os
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from pliant._core import OptionError, PathOptions, path_rows
from pliant.base import console
from pliant.base.new_file import new_text
from pliant.base.output_names import check_trajectory_name
from pliant.base.said import notes_shown_by

if TYPE_CHECKING:
    from pliant.jobs.path.found import MolecularPath

EXIT_SHORT = 3  #: the end was not reached

ATTEMPTS = 10  #: of --backtrack without a number

EPILOG = """\
Residues are matched by chain and number, else by sequence. Contacts that both structures have are
held on the way; those in only one of them, or of unmatched atoms, are not held. Ligands
and metals are matched by chain, number and name. Bonds, angles and planar groups are those of
START, exact in each frame, and atoms do not overlap.

--select, --frame, --contacts and --floppy-below are about START; all other options under
Molecule and Model hold for END, too. Contacts that are given replace those found in START.

If the direct path does not reach END, parts that keep their shape are rotated as rigid bodies,
provided that one of them turns by 45 degrees or more.

A path shows that a route exists, and which contacts have to break on it. It does not show how fast
or how likely it is, or that the molecule takes it.

exit codes: 0 END was reached (CA to 0.5 A, heavy atoms to 1 A), 1 bad input or file, 2 bad option,
3 END was not reached

examples:
  pliant path open.pdb closed.pdb -o closing.h5md
  pliant path 1cll.pdb 5ggm.pdb -o p.h5md --both --backtrack
  pliant path 4ake.cif 1ake.cif -o closing.h5md --atoms heavy --csv closing.csv
  pliant analyse closing.h5md
"""

#: options that --help shows
COMMON = ("--output", "--select", "--atoms", "--both", "--backtrack", "--csv")


def write_table(path: MolecularPath, file: str | os.PathLike[str], overwrite: bool) -> None:
    """One line a frame, as CSV."""
    rows = path.as_json()["frames"]
    with new_text(file, overwrite=overwrite) as stream:
        writer = csv.DictWriter(stream, list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)


def make_parser() -> console.Parser:
    """The options of pliant path."""
    parser = console.Parser(
        "path",
        "Finds a path from one structure of a molecule to another: frames with exact bonds and\n"
        "angles and no overlaps, which keep the contacts that both structures have.",
        EPILOG,
        COMMON,
    )
    add = parser.add_argument
    add("start", metavar="START", help="PDB or mmCIF file to start from")
    add("end", metavar="END", help="PDB or mmCIF file of the same molecule, to go to")
    add(
        "-o", "--output", metavar="FILE", required=True, help="H5MD trajectory or PDB file to write"
    )
    console.add_rows(parser, path_rows(), {"backtrack": ATTEMPTS})
    add("--csv", metavar="FILE", help="also write the table of frames")
    add("--overwrite", action="store_true", help="replace existing outputs")
    add("--json", action="store_true", help="print the report as one JSON object")
    return parser


def main(words: Sequence[str] | None = None) -> int:
    """Runs the command; returns its exit code."""
    arguments = make_parser().parse_args(words)
    return console.run_command("path", lambda: _path(arguments))


def _path(arguments: argparse.Namespace) -> int:
    from pliant.jobs.path import walk

    _check_outputs(arguments)
    options = PathOptions(**console.given(arguments, path_rows()))
    with notes_shown_by(console.note):
        start, end = options.start_of(arguments.start), options.end_of(arguments.end)
    with console.progress("path") as show:
        path = walk.find(
            start,
            end,
            options,
            arguments.output,
            arguments.overwrite,
            lambda done: show(done, walk.WHOLE),
        )
    if arguments.csv:
        write_table(path, arguments.csv, arguments.overwrite)
    if arguments.json:
        console.print_json({"output": arguments.output, **path.as_json()})
    else:
        _print(path, arguments.output)
    return console.EXIT_OK if path.arrived else EXIT_SHORT


def _check_outputs(arguments: argparse.Namespace) -> None:
    check_trajectory_name(arguments.output)
    if arguments.csv and not Path(arguments.csv).resolve().parent.is_dir():
        raise OptionError(f"--csv {arguments.csv}: its directory does not exist")
    if arguments.csv and Path(arguments.csv).exists() and not arguments.overwrite:
        raise OptionError(f"--csv {arguments.csv}: exists; --overwrite replaces it")
    names = [n for n in (arguments.start, arguments.end, arguments.output, arguments.csv) if n]
    if len({os.path.realpath(name) for name in names}) < len(names):
        raise OptionError("two of the files are one: START, END, --output and --csv must differ")


def _print(path: MolecularPath, output: str) -> None:
    first, last = path.frames[0], path.frames[-1]
    worst = max(frame.max_residual for frame in path.frames)
    for note in path.notes:
        console.note(note)
    what = "arrived" if path.arrived else "did not arrive"
    turned = f", turning a piece by {path.turned:.0f} degrees" if path.turned else ""
    detours = f", after {console.counted(path.attempts, 'detour')}" if path.attempts else ""
    lines = [
        ("path", f"{what}: {first.to_end:.2f} A from the end at first, {last.to_end:.2f} now"),
        ("left out", "; ".join(path.model.left_out)),
        (
            "frames",
            f"{len(path.frames)}; {path.atoms} of {path.matched} residues, superposed"
            f"{turned}{detours}",
        ),
        (
            "contacts",
            f"{path.held} of both structures held; {last.lost} of {path.only_start} of the start "
            f"alone lost, {last.made} of {path.only_end} of the end alone made",
        ),
        *(
            ("tightest", f"{one.atoms}: {one.overlap:.3f} A too near in frame {one.step}")
            for one in path.tight_places(1)
        ),
        ("quality", f"Bonds and angles are off by {worst:.0e} at most."),
        ("written", f"{console.printable_name(output)}, in {path.seconds:.1f} s"),
    ]
    for label, text in lines:
        if text:
            print(f"{label:15s} {text}")
    if not path.arrived:
        print("what stands in the way may be contacts, loops, or parts that would pass each other;")
        print("--both and --backtrack try other ways round")


if __name__ == "__main__":
    sys.exit(main())
