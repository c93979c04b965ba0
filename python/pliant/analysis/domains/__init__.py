# SPDX-License-Identifier: MIT
"""Which parts of a molecule move together: correlations, domains that move as rigid, hinges."""

from pliant.analysis.domains.correlations import correlations, distance_fluctuations
from pliant.analysis.domains.find import LOOSE, RESAMPLES, TOGETHER, Domains, Hinge, find_domains

__all__ = [
    "LOOSE",
    "RESAMPLES",
    "TOGETHER",
    "Domains",
    "Hinge",
    "correlations",
    "distance_fluctuations",
    "find_domains",
]
