# SPDX-License-Identifier: MIT
"""Which parts of a molecule move together: correlations, domains that move as rigid, hinges."""

from pliant.measure.domains.correlations import correlations, distance_fluctuations
from pliant.measure.domains.find import LOOSE, RESAMPLES, TOGETHER, Domains, Hinge, find_domains

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
