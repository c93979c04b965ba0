# SPDX-License-Identifier: MIT
"""Dynamic domains of two known structures, as DynDom finds them.

S. Hayward, H. Berendsen, Proteins 30 (1998) 144: rotation vectors of windows along the backbone are
clustered (k-means); each cluster falls into the parts that hang together in space, and those of
MIN_SITES residues and more are domains; two that touch must move against each other as far as they
deform. Of the numbers of clusters the largest counts for which this holds, until a cluster has no
domain. Ours: best of STARTS beginnings of k-means, residues touch within TOUCH (backbones have no
side chains, which the 4 Angstrom of DynDom are for), and at most MOST_LEFT of the residues may be
of no domain. Nothing here is used by what it judges.
"""

from __future__ import annotations

import numpy as np
from scipy.cluster.vq import kmeans2
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

WINDOW = 5  #: residues
MIN_SITES = 20
LEAST_RATIO = 1.0
MOST_CLUSTERS = 10
STARTS = 20
TOUCH = 6.0  #: Angstrom between backbone atoms
MOST_LEFT = 0.15

NONE = -1  #: the domain of residues that belong to none


def pair_domains(start: np.ndarray, end: np.ndarray, numbers: np.ndarray) -> np.ndarray:
    """(R,) domain of each residue, from 0 by size; NONE where it has none. All 0: one piece.

    start, end: (R, A, 3) backbone atoms of the same residues, Angstrom; numbers: (R,) of the
    residues, with gaps where some are missing.
    """
    centres, turns = _turns_of_windows(start, end, numbers)
    best = np.zeros(len(start), dtype=np.int64)
    for clusters in range(2, MOST_CLUSTERS + 1):
        cluster = np.full(len(start), NONE)
        cluster[centres] = _clusters(turns, clusters)
        parts = [_domains_of(start, np.flatnonzero(cluster == k)) for k in range(clusters)]
        if clusters > 2 and not all(parts):
            break
        domains = sorted((one for part in parts for one in part), key=len, reverse=True)
        left = len(centres) - sum(len(one) for one in domains)
        if len(domains) > 1 and left <= MOST_LEFT * len(centres) and _all_move(start, end, domains):
            best = np.full(len(start), NONE)
            for k, one in enumerate(domains):
                best[one] = k
    return best


def _turns_of_windows(
    start: np.ndarray, end: np.ndarray, numbers: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Middle residues of windows without gaps, and their rotation vectors (w, 3)."""
    half = WINDOW // 2
    middles = np.arange(half, len(numbers) - half)
    whole = numbers[middles + half] - numbers[middles - half] == WINDOW - 1
    middles = middles[whole]
    end = _moved(end, end, start)
    turns = []
    for k in middles:
        part = slice(k - half, k + half + 1)
        rotation, _ = Rotation.align_vectors(_centred(end[part]), _centred(start[part]))
        turns.append(rotation.as_rotvec())
    return middles, np.array(turns)


def _clusters(turns: np.ndarray, count: int) -> np.ndarray:
    found = [kmeans2(turns, count, minit="++", seed=seed) for seed in range(STARTS)]
    spreads = [float(np.sum((turns - centres[label]) ** 2)) for centres, label in found]
    return np.asarray(found[int(np.argmin(spreads))][1])


def _domains_of(start: np.ndarray, members: np.ndarray) -> list[np.ndarray]:
    """Parts of some residues that hang together, if they are large enough."""
    if len(members) < MIN_SITES:
        return []
    points = start[members].reshape(-1, 3)
    atoms = start.shape[1]
    pairs = cKDTree(points).query_pairs(TOUCH, output_type="ndarray") // atoms
    links = coo_matrix((np.ones(len(pairs)), pairs.T), shape=(len(members),) * 2)
    count, part = connected_components(links, directed=False)
    parts = [members[part == k] for k in range(count)]
    return [one for one in parts if len(one) >= MIN_SITES]


def _all_move(start: np.ndarray, end: np.ndarray, domains: list[np.ndarray]) -> bool:
    """Whether each two domains that touch move as far against each other as they deform."""
    trees = [cKDTree(start[one].reshape(-1, 3)) for one in domains]
    return all(
        ratio(start, end, domains[a], domains[b]) >= LEAST_RATIO
        for a in range(len(domains))
        for b in range(a)
        if trees[a].count_neighbors(trees[b], TOUCH)
    )


def ratio(start: np.ndarray, end: np.ndarray, first: np.ndarray, second: np.ndarray) -> float:
    """Displacement of two domains by rigid motion over that by deformation (r.m.s., of both), once
    both together are superposed."""
    both = np.concatenate([first, second])
    moved = _moved(end, end[both], start[both])
    rigid = deformed = 0.0
    for one in (first, second):
        as_body = _moved(start[one], start[one], moved[one])
        rigid += float(np.mean((as_body - start[one]) ** 2))
        deformed += float(np.mean((as_body - moved[one]) ** 2))
    return float(np.sqrt(rigid / max(deformed, 1e-12)))


def _moved(points: np.ndarray, part: np.ndarray, onto: np.ndarray) -> np.ndarray:
    """Points (..., 3), moved as superposes a part of them on the same part elsewhere."""
    rotation, _ = Rotation.align_vectors(_centred(onto), _centred(part))
    middles = part.reshape(-1, 3).mean(axis=0), onto.reshape(-1, 3).mean(axis=0)
    flat = rotation.apply(points.reshape(-1, 3) - middles[0]) + middles[1]
    return np.asarray(flat.reshape(points.shape))


def _centred(points: np.ndarray) -> np.ndarray:
    flat = points.reshape(-1, 3)
    return np.asarray(flat - flat.mean(axis=0))
