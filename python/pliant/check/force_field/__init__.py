# SPDX-License-Identifier: MIT
"""Frames of an ensemble, minimised by OpenMM: whether molecular dynamics may start from them."""
