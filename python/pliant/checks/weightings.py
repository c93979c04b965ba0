# SPDX-License-Identifier: MIT
"""Weightings that are tried where the quickest technique is looked for."""

WEIGHTINGS = (0.5, 0.75, 1.0)  #: those of the thesis, section 3.1
