# SPDX-License-Identifier: MIT
"""Trajectories: their files, their frames, and the objects of other packages that hold frames."""
