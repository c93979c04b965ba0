# SPDX-License-Identifier: MIT
"""Least-squares superposition (Kabsch fit), which needs no MDAnalysis and so lives above."""

from pliant._superposition import Superposition

__all__ = ["Superposition"]
