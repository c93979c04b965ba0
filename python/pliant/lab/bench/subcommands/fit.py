# SPDX-License-Identifier: MIT
"""``pliant lab bench fit``."""

from __future__ import annotations

from pliant.lab.options import PAIRS, WORKERS, whole
from pliant.lab.pairs.fits import fits as measure

__all__ = ["measure"]


DESCRIPTION = """\
Takes pairs of known structures of one protein. Distances between alpha carbons of the one, +-1 A
(10 also +-0.5 and 3), or a density map of it are given to pliant fit of the other. How near does it
come? Distances are designed from the start alone (5, 10, 20), drawn at random (10), or designed and
one of ten wrong by 15 A: is that one named? Maps are of all atoms at 5 A with noise, 8 A, also with
half of the density missing, and 12 A. By a SAXS curve of it with noise a frame is chosen; the frame
that is nearest to it stands beside that. Each pair is a subfolder of --data with two files (PDB or
mmCIF)."""
EPILOG = """\
examples:
  pliant lab bench fit --data pairs
  pliant lab bench fit --data pairs --residues 350 --csv fits.csv"""
OPTIONS = {
    "--data": PAIRS,
    "--residues": whole(10, 350, "leave out proteins with more residues"),
    "--seed": whole(0, 0, "seed of ensembles and of what is drawn"),
    "--workers": WORKERS,
}
