# SPDX-License-Identifier: MIT
"""The command ``pliant study``."""

from __future__ import annotations

import argparse
import gc
import shutil
import sys
import textwrap
import warnings
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from pliant._core import OptionError
from pliant.base import console
from pliant.base.force_field_options import add_options, taken
from pliant.jobs.process import molecule_rows
from pliant.trajectory.freed_memory import give_back_freed_memory

COMMON = (
    *("--output", "--distances", "--map", "--resolution", "--frames", "--smiles", "--select"),
)
#: of 20 residues, where the build puts it (python/CMakeLists.txt)
HELIX = Path(__file__).parents[2] / "static" / "examples" / "peptide_20.pdb"

DESCRIPTION = """\
Studies a molecule and answers, on one page: how far it moves, which parts are flexible, what moves
together, what else it could look like, and what was left out. With END, another structure of the
same molecule, a path to it is found as well; with measured distances or a density map, whether it
agrees with them. For a small molecule, conformers are studied.

It does what pliant sample, analyse, path, fit and check do by default, one after the other. To
choose options yourself, use those commands."""

EPILOG = """\
The folder has:
  report.html            the page, for any browser
  ensemble.h5md, .pdb    the frames; MDAnalysis opens them, pliant convert writes other formats
  representatives.pdb    20 frames that represent all, for docking or to look at
  shapes.pdb             one frame for each other shape of a protein
  path.h5md              the path to END
  fitted.pdb             the structure that agrees best with the data
  show.pml, show.cxc     load all of these in PyMOL and ChimeraX
  and tables (CSV) and figures (PNG)

If OpenMM is installed, it minimises 3 to 5 frames of a protein to test whether they can be used to
start MD, with its ligands if AmberTools is installed; --no-check leaves this out.

Exit code: 0 done (whatever the answers are), 1 a file cannot be read or written, 2 bad option.

examples:
  pliant study --demo
  pliant study protein.pdb
  pliant study open.pdb closed.pdb -o opening
  pliant study open.pdb --distances measured.csv --map map.mrc --resolution 8 --place
  pliant study drug.sdf --frames 200
  pliant study --smiles "CC(=O)Oc1ccccc1C(=O)O" -o aspirin
"""


def make_parser() -> console.Parser:
    """The options of pliant study."""
    parser = console.Parser("study", DESCRIPTION, EPILOG, COMMON)
    add = parser.add_argument
    add("file", metavar="FILE", nargs="?", help="molecule: PDB, mmCIF, XYZ or SDF")
    add("end", metavar="END", nargs="?", help="another structure of it, to find a path to")
    text = "folder for the results (default: FILE's name with -study)"
    add("-o", "--output", metavar="DIR", help=text)
    text = "instead of FILE: a small molecule, which RDKit makes three-dimensional"
    add("--smiles", metavar="TEXT", help=text)
    add("--distances", metavar="FILE", help="measured distances (CSV), as pliant fit takes them")
    add("--map", metavar="FILE", help="density map (MRC, CCP4) to fit FILE to")
    add("--resolution", metavar="A", type=float, help="of the map, Angstrom")
    add("--half", metavar="FILE", help="other half map, to judge the fit by")
    add("--place", action="store_true", help="put FILE into the map first")
    add("--demo", action="store_true", help="instead of FILE: a helix that comes with Pliant")
    text = "frames of the ensemble (default: as pliant sample)"
    add("--frames", metavar="N", type=console.whole_number(4), help=text)
    add("--seed", metavar="N", type=console.whole_number(0), default=0, help="seed (default: 0)")
    add("--no-check", action="store_true", help="do not let OpenMM minimise frames")
    add_options(parser.add_argument_group("force field of the check").add_argument)
    add("--overwrite", action="store_true", help="replace the results of an earlier study")
    add("--json", action="store_true", help="print the results as one JSON object")
    add("--quiet", action="store_true", help="print nothing but errors")
    console.add_rows(parser, molecule_rows())
    return parser


def main(words: Sequence[str] | None = None) -> int:
    """Runs the command; returns its exit code."""
    arguments = make_parser().parse_args(words)
    give_back_freed_memory()
    gc.set_threshold(20_000)  # usual: 700, of the hundred thousand objects that are imported
    return console.run_command("study", lambda: _study(arguments))


def _study(arguments: argparse.Namespace) -> int:
    from pliant.report.study.studied import LABELS
    from pliant.report.study.suite import study

    file = arguments.file
    if arguments.demo:
        if file is not None or arguments.smiles is not None:
            raise OptionError("--demo: goes with neither FILE nor --smiles")
        file = HELIX
    with warnings.catch_warnings(), console.stages(arguments.quiet) as on_stage:
        found = study(
            file,
            arguments.end,
            arguments.output,
            distances=arguments.distances,
            map=arguments.map,
            resolution=arguments.resolution,
            half=arguments.half,
            place=arguments.place,
            smiles=arguments.smiles,
            frames=arguments.frames,
            seed=arguments.seed,
            check=not arguments.no_check,
            **taken(arguments),
            overwrite=arguments.overwrite,
            quiet=arguments.quiet or arguments.json,
            on_stage=on_stage,
            **console.given(arguments, molecule_rows()),
        )
    if arguments.json:
        console.print_json(found.as_json())
    elif not arguments.quiet:
        for text in found.sampled.facts["warnings"]:
            console.warn(text)
        for what, answer in found.answered.items():
            _print(LABELS.get(what, what), answer.text)
            _print("", answer.more)
    return console.EXIT_OK


def _print(label: str, text: str) -> None:
    """Beside its label; on a terminal no longer than its lines. Nothing without a text."""
    width = shutil.get_terminal_size().columns if sys.stdout.isatty() else sys.maxsize
    look: dict[str, Any] = {"break_long_words": False, "break_on_hyphens": False}
    look |= {"initial_indent": f"{label:<14}", "subsequent_indent": " " * 14}
    if text:
        print(textwrap.fill(console.printable(text), width, **look))


if __name__ == "__main__":
    sys.exit(main())
