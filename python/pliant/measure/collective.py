# SPDX-License-Identifier: MIT
"""What a collective motion moves: how collective it is, and which stretches take part most."""

from __future__ import annotations

import numpy as np

#: a site takes part above the mean when its share is more than so many times that of all alike
ABOVE = 2.0
#: stretches that are no further apart than this are one
GAP = 2


def participation(components: np.ndarray) -> np.ndarray:
    """(K, n) share of each site in each component (K, 3n) of unit length; rows sum to 1."""
    squares = components.reshape(len(components), -1, 3) ** 2
    found: np.ndarray = squares.sum(axis=2)
    return np.asarray(found / found.sum(axis=1, keepdims=True))


def collectivity(components: np.ndarray) -> np.ndarray:
    """(K,) exp(-sum_i p_i ln p_i) / n: 1 where all n sites move alike, 1/n where one moves alone.

    R. Brueschweiler, J. Chem. Phys. 102 (1995) 3396.
    """
    share = participation(components)
    logarithm = np.log(np.where(share > 0, share, 1.0))
    return np.asarray(np.exp(-np.sum(share * logarithm, axis=1)) / share.shape[1])


def moving_stretches(
    share: np.ndarray, chains: np.ndarray, most: int = 3
) -> list[tuple[int, int, float]]:
    """The stretches of sites that take most part: first and last site, and share of the motion.

    share: (n,) of each site, sum 1; chains: (n,). Largest share first.
    """
    taking = np.flatnonzero(share > ABOVE / len(share))
    if len(taking) == 0:
        return []
    apart = (np.diff(taking) > GAP + 1) | (chains[taking[1:]] != chains[taking[:-1]])
    found = [
        (int(part[0]), int(part[-1]), float(share[part[0] : part[-1] + 1].sum()))
        for part in np.split(taking, np.flatnonzero(apart) + 1)
    ]
    return sorted(found, key=lambda stretch: -stretch[2])[:most]
