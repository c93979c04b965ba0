# SPDX-License-Identifier: MIT
"""Trajectories checked against OpenMM: their bars, its forces, and minimised frames."""
