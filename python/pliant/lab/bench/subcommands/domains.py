# SPDX-License-Identifier: MIT
"""``pliant lab bench domains``."""

from __future__ import annotations

from pliant.lab.options import PAIRS, WORKERS, names, whole
from pliant.lab.pairs.domains import domains as measure

__all__ = ["measure"]


DESCRIPTION = """\
Takes pairs of known structures of one protein. From each of the two, ensembles of several seeds are
made (pliant sample), and domains found as pliant analyse reports them. No seed
should contradict another, and the domains should be those that turn between the two structures by
DynDom's criterion (Hayward and Berendsen 1998). Each pair is a subfolder of --data with two files
(PDB or mmCIF); those with a local.json are pockets and are left out."""
EPILOG = """\
examples:
  pliant lab bench domains --data pairs
  pliant lab bench domains --data pairs --repeats 3 --also 4E43.pdb,1hvr.pdb --csv domains.csv"""
OPTIONS = {
    "--data": PAIRS,
    "--also": names("structures without a pair, to compare seeds only", metavar="FILE,..."),
    "--repeats": whole(1, 10, "ensembles of different seeds that are compared", dest="seeds"),
    "--frames": whole(4, 400, "frames of each ensemble"),
    "--workers": WORKERS,
}
