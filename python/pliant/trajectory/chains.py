# SPDX-License-Identifier: MIT
"""Chains as MDAnalysis has them: it calls the one segment of a system without chains SYSTEM."""

from __future__ import annotations

#: MDAnalysis' word where a file names no chain and no segment.
NO_CHAIN = "SYSTEM"


def chain_of(segid: object) -> str:
    """Return the chain that a segment's name means; "" for a system without chains."""
    return "" if segid == NO_CHAIN else str(segid)
