# SPDX-License-Identifier: MIT
"""Runs that are followed while they go, and pulled on: IMD, the protocol of VMD.

``pliant.play.imd.Client`` follows ``pliant run --imd``, GROMACS, LAMMPS and NAMD alike;
``pliant watch`` is a terminal for it.
"""

from pliant.play.imd.client import Client, ImdFrame

__all__ = ["Client", "ImdFrame"]
