# SPDX-License-Identifier: MIT
"""Other programs at work beside ours: OpenMM's CCMA in this process, and GROMACS."""
