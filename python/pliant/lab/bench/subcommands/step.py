# SPDX-License-Identifier: MIT
"""``pliant lab bench step``."""

from __future__ import annotations

import argparse

from pliant.base import console

ORDER = 5
SUMMARY = "cost of a step after a push of one joint, in small and in large molecules"
DESCRIPTION = """\
Runs frameworks for many steps with one joint pushed in each, small and large ones by
turns. Times are those of push and resolve in the run's own summary, without recording
and without what only the first step takes. The ratio is that of the medians, and its
range that of the quartiles. Techniques that visit only the region of a push cost the
same in any size, except for what no longer fits into the caches of the processor. At the
end bars and limits are measured again. Where one is broken, or a step did not converge,
it is named, and the exit code is 1.

chain, tree, protein and zigzag are points and bars; peptide is one long chain of alanines
with all atoms, copies are molecules of 200 atoms side by side. With FILE the molecules
of files take their place, and the ratio is to the smallest."""
EPILOG = """\
examples:
  pliant lab bench step
  pliant lab bench step --kinds chain --technique bfs_cycle --sizes 1e3,1e4 --steps 100
  pliant lab bench step --kinds peptide,copies,zigzag --bars angles --sizes 1e2,1e3,1e4
  pliant lab bench step --kinds peptide --model protein --sizes 2e3,2e4 --memory
  pliant lab bench step peptide_20.pdb adk_open.pdb --model protein
"""


def add_options(parser: console.Parser) -> None:
    """Those of this subcommand."""
    from pliant.lab.bench.step import ROUNDS, STEPS, TECHNIQUES
    from pliant.lab.bench.step_scenes import BARS, FRAMEWORKS, MODELS, MOLECULES

    add = parser.add_argument
    text = "numbers of joints (default 1e4,1e6)"
    add("--sizes", metavar="N,N,...", type=console.positive_numbers, default="1e4,1e6", help=text)
    text = f"kinds of framework: {', '.join([*FRAMEWORKS, *MOLECULES])} (default protein)"
    add("--kinds", metavar="NAME,...", type=console.words, default=("protein",), help=text)
    add("files", metavar="FILE", nargs="*", help="molecule files in place of kinds and sizes")
    text = "what becomes a bar (default bonds)"
    add("--bars", choices=BARS, default="bonds", help=text)
    text = "as for pliant run; replaces --bars; without atoms there is none"
    add("--model", choices=[*BARS, *MODELS], help=text)
    text = (
        f"techniques (see pliant lab techniques; default {','.join(TECHNIQUES)}; auto if not bonds)"
    )
    add("--technique", metavar="NAME,...", type=console.words, default=(), help=text)
    text = "weighting of the techniques (default 0.5)"
    add("--weighting", metavar="W", type=console.positive_number, default=0.5, help=text)
    text = "relative tolerance (default 1e-6)"
    add("--tolerance", metavar="T", type=console.positive_number, default=1e-6, help=text)
    text = f"steps of a round at most (default {STEPS})"
    add("--steps", metavar="N", type=console.whole_number(1), default=STEPS, help=text)
    text = f"number of rounds; the median is reported (default {ROUNDS})"
    add("--repeats", metavar="N", type=console.whole_number(1), default=ROUNDS, help=text)
    text = "measure the memory too, each in a process of its own"
    add("--memory", action="store_true", help=text)
    add("--csv", metavar="FILE", help="write the rows as CSV")


def run(arguments: argparse.Namespace) -> int:
    """Measures and prints; returns the exit code."""
    from pliant.lab.bench.rows import write_csv
    from pliant.lab.bench.step import TECHNIQUES, print_report, steps_of_pushes

    model = arguments.model or arguments.bars
    usual = TECHNIQUES if model == "bonds" else ("auto",)
    with console.progress("techniques", arguments.quiet or arguments.json) as show:
        found = steps_of_pushes(
            arguments.sizes,
            kinds=arguments.kinds,
            files=arguments.files,
            model=model,
            techniques=arguments.technique or usual,
            weighting=arguments.weighting,
            tolerance=arguments.tolerance,
            steps=arguments.steps,
            rounds=arguments.repeats,
            memory=arguments.memory,
            progress=show,
        )
    if arguments.csv:
        write_csv(found.rows, arguments.csv)
    console.print_json(found.as_json()) if arguments.json else print_report(found)
    return console.EXIT_FAILED if found.faults else console.EXIT_OK
