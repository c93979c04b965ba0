# SPDX-License-Identifier: MIT
"""``pliant lab bench work-precision``."""

from __future__ import annotations

from pliant.lab.bench.work_precision import REPEATS
from pliant.lab.bench.work_precision import work_precision as measure
from pliant.lab.options import BARS, DISPLACEMENT, TECHNIQUES, among, flag, numbers, whole, word

__all__ = ["measure"]

TOLERANCES = ",".join(f"1e-{k}" for k in range(2, 13))

DESCRIPTION = """\
Breaks a molecule once. Every technique with every weighting, and OpenMM's CCMA in the
same process, repair it to one tolerance after another. All take turns, and the median
processor time counts, so that other load on the machine affects all alike. Errors are
measured again in double precision. Contenders that take too long or do not reach a
tolerance are named and not tried again. CCMA runs twice: as in
Context.applyConstraints, which starts from what the techniques start from, and as in
dynamics, where it is given the intact structure. Where gmx or gmx_d is installed, LINCS
and SHAKE of GROMACS' mdrun take part, as in dynamics. Their times are those for
constraints in its log, their errors those of its trajectory. Of LINCS's settings, the
fastest that meets a tolerance counts."""
EPILOG = """\
examples:
  pliant lab bench work-precision protein.pdb -o race.png --csv race.csv
  pliant lab bench work-precision protein.pdb --bars angles --technique blocks,bfs_reverse
"""
PICTURE = ("pliant.lab.bench.work_precision_picture", "run time against error")
OPTIONS = {
    "path": word("FILE", "molecule file, as for pliant run"),
    "--bars": BARS,
    "--displacement": DISPLACEMENT,
    "--seed": whole(0, 0, "seed of the displacement"),
    "--tolerance": numbers(
        TOLERANCES, "relative tolerances, the largest first", "T,T,...", dest="tolerances"
    ),
    "--technique": TECHNIQUES,
    "--repeats": whole(1, REPEATS, "number of rounds; the median is reported"),
    "--mass-weighted": flag("also share corrections in proportion to inverse mass"),
    "--peers": among(
        ("all", "openmm", "none"), "all", "other programs: OpenMM; GROMACS where it is installed"
    ),
}
