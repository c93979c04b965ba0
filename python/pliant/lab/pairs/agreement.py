# SPDX-License-Identifier: MIT
"""How two assignments of domains agree. Labels from 0 by size, below 0 for none."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

#: a domain is found where intersection over union with a reported one is so large
SAME = 0.5


def agreement(reported: np.ndarray, known: np.ndarray) -> float:
    """Share of the pairs of residues that are in one domain in both, or in two in both; of the
    residues that have a domain in both. NaN where there are none."""
    both = (reported >= 0) & (known >= 0)
    one, other = reported[both], known[both]
    alike = (one[:, None] == one) == (other[:, None] == other)
    pairs = len(one) * (len(one) - 1)
    return (np.count_nonzero(alike) - len(one)) / pairs if pairs else math.nan


def found(reported: np.ndarray, known: np.ndarray) -> np.ndarray:
    """(k,) bool: which of the known domains are among the reported."""
    table = _shared(reported, known)
    if table.size == 0:
        return np.zeros(table.shape[1], dtype=bool)
    sizes = [np.bincount(one[one >= 0], minlength=n) for one, n in
             zip((reported, known), table.shape, strict=True)]  # fmt: skip
    union = sizes[0][:, None] + sizes[1] - table
    return np.asarray((table >= SAME * union).any(axis=0))


def contradicted(assignments: Sequence[np.ndarray]) -> int:
    """Pairs of residues that one reports in the same domain, and another in two, over all pairs of
    assignments (n,). One piece counts as one domain; residues in none contradict nothing."""
    count = 0
    for k, one in enumerate(assignments):
        for other in assignments[:k]:
            both = (one >= 0) & (other >= 0)
            a, b = one[both], other[both]
            count += int(np.count_nonzero((a[:, None] == a) != (b[:, None] == b))) // 2
    return count


def _shared(reported: np.ndarray, known: np.ndarray) -> np.ndarray:
    """(r, k) residues that two domains share."""
    table = np.zeros((reported.max(initial=-1) + 1, known.max(initial=-1) + 1), dtype=np.int64)
    both = (reported >= 0) & (known >= 0)
    np.add.at(table, (reported[both], known[both]), 1)
    return table
