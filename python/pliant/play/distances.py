# SPDX-License-Identifier: MIT
"""Measured distances for the page, which shows which of them hold while a person pulls."""

from __future__ import annotations

import math
import warnings
from pathlib import Path
from typing import Any

import numpy as np

from pliant._core import PliantWarning, nodes_to_fit, read
from pliant.base import console
from pliant.jobs.fit.data import Sites, read_distances
from pliant.jobs.fit.fitted import HOLDS
from pliant.jobs.fit.nodes import distances


def distances_for_page(given: Path, table: str) -> dict[str, Any]:
    """What the page is told: rows of two atoms by their names and an interval, Angstrom.

    Distances of labels are left out, and a note says so: the page has alpha carbons alone. Raises
    InputError and OSError as `pliant.fit` does.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", PliantWarning)  # the page says it
        structure = read(given)
    atoms, _ = nodes_to_fit(structure)
    data, nodes = read_distances(table, Sites(structure, atoms)), structure.positions[atoms]
    one, other = nodes[np.array([datum.pair for datum in data]).T]
    direct = np.isclose(distances(nodes, data), np.linalg.norm(one - other, axis=1))
    if not direct.all():
        console.note(f"{np.sum(~direct)} of {len(data)} distances are of labels: not shown")
    rows = [
        {
            "names": [structure.label(int(atoms[node])) for node in datum.pair],
            "low": datum.low,
            "high": datum.high if math.isfinite(datum.high) else None,
        }
        for datum, is_shown in zip(data, direct, strict=True)
        if is_shown
    ]
    return {"distances": {"rows": rows, "holds": HOLDS}}
