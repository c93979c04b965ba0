# SPDX-License-Identifier: MIT
"""``pliant lab bench step``."""

from __future__ import annotations

from pliant.lab.bench.step import ROUNDS, STEPS, TECHNIQUES
from pliant.lab.bench.step import steps_of_pushes as measure
from pliant.lab.bench.step_scenes import BARS, FRAMEWORKS, MODELS, MOLECULES
from pliant.lab.options import TOLERANCE, among, flag, names, number, numbers, whole, word

__all__ = ["measure"]

KINDS = ", ".join([*FRAMEWORKS, *MOLECULES])
USUAL = f"default {','.join(TECHNIQUES)}; auto if not bonds"

DESCRIPTION = """\
Runs frameworks for many steps with one joint pushed in each, small and large ones by
turns. Times are those of push and resolve in the run's own summary, without recording
and without what only the first step takes. The ratio is that of the medians, and its
range that of the quartiles. Techniques that visit only the region of a push cost the
same in any size, except for what no longer fits into the caches of the processor. At the
end bars and limits are measured again. Where one is broken, or a step did not converge,
it is named, and the exit code is 1.

protein and zigzag are points and bars; peptide is one long chain of alanines with all
atoms, copies are molecules of 200 atoms side by side. With FILE the molecules of files
take their place, and the ratio is to the smallest."""
EPILOG = """\
examples:
  pliant lab bench step
  pliant lab bench step --kinds zigzag --technique bfs_cycle --sizes 1e3,1e4 --steps 100
  pliant lab bench step --kinds peptide,copies,zigzag --bars angles --sizes 1e2,1e3,1e4
  pliant lab bench step --kinds peptide --model protein --sizes 2e3,2e4 --memory
  pliant lab bench step peptide_20.pdb adk_open.pdb --model protein
"""
OPTIONS = {
    "files": word("FILE", "molecule files in place of kinds and sizes", nargs="*"),
    "--sizes": numbers("1e4,1e6", "numbers of joints", "N,N,..."),
    "--kinds": names(f"kinds of framework: {KINDS}", ("protein",)),
    "--bars": among(BARS, "bonds", "what becomes a bar"),
    "--model": among(
        (*BARS, *MODELS), None, "as for pliant run; replaces --bars; without atoms there is none"
    ),
    "--technique": names(f"techniques (see pliant lab techniques; {USUAL})", dest="techniques"),
    "--weighting": number(0.5, "weighting of the techniques", "W"),
    "--tolerance": TOLERANCE,
    "--steps": whole(1, STEPS, "steps of a round at most"),
    "--repeats": whole(1, ROUNDS, "number of rounds; the median is reported", dest="rounds"),
    "--memory": flag("measure the memory too, each in a process of its own"),
}
