# SPDX-License-Identifier: MIT
"""Lets MDAnalysis open trajectories of Pliant by themselves: ``import pliant.mdanalysis``.

From then on ``MDAnalysis.Universe("out.h5md")`` has names, residues and bonds from the file, and
``MDAnalysis.Universe("DIR/ensemble.pliant")`` the frames of all shards of an ensemble.
"""

from pliant.base.extras import needed_by

with needed_by("pliant.mdanalysis"):
    from pliant.trajectory.h5md_parser import H5MDParser as H5MDParser
    from pliant.trajectory.shards.reader import EnsembleReader as EnsembleReader
