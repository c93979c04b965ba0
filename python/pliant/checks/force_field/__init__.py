# SPDX-License-Identifier: MIT
"""Frames of an ensemble, minimised by OpenMM: whether they can be used to start MD."""
