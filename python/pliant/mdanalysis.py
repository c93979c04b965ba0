# SPDX-License-Identifier: MIT
"""Lets MDAnalysis open trajectories of Pliant by themselves: ``import pliant.mdanalysis``.

From then on ``MDAnalysis.Universe("out.h5md")`` has names, residues and bonds from the file, and
``MDAnalysis.Universe("DIR/ensemble.pliant")`` the frames of all shards of an ensemble.
"""

from pliant.base.extras import needed_by

with needed_by("pliant.mdanalysis"):
    from pliant.trajectory.frames_reader import FramesReader as FramesReader
    from pliant.trajectory.universe import H5MDParser as H5MDParser
