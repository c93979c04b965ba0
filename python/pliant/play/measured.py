# SPDX-License-Identifier: MIT
"""Measured data for the page, which shows how well they hold while a person pulls."""

from __future__ import annotations

import math
import warnings
from pathlib import Path
from typing import Any

import numpy as np

from pliant._core import OptionError, PliantWarning, Structure, nodes_to_fit, read
from pliant.base import console
from pliant.jobs.fit.data import Sites, read_distances
from pliant.jobs.fit.fitted import HOLDS
from pliant.jobs.fit.in_map import read_map
from pliant.report.page.drawn import as_base64
from pliant.report.page.map_surface import MapSurface


def measured_for_page(
    given: Path, table: str | None, density: str | None, resolution: float | None
) -> dict[str, Any]:
    """What the page is told of distances and a map, of those that are given.

    Raises InputError, OptionError and OSError as `pliant.fit` does.
    """
    if density is None and resolution is not None:
        raise OptionError("resolution: of a map, and none is given")
    found: dict[str, Any] = {}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", PliantWarning)  # the page says it
        structure = read(given)
    if table is not None:
        found["distances"] = _distances(structure, table)
    if density is not None:
        found["map"] = _map(structure, density, resolution)
    return found


def _map(structure: Structure, density: str, resolution: float | None) -> dict[str, Any]:
    """The surface about the molecule where it is, and the points of a grid that are inside."""
    data = read_map(density, resolution, None)
    data.refuse_outside(structure.positions[nodes_to_fit(structure)[0]])
    shown, about = MapSurface.around(data.density, data.resolution, structure), np.zeros(3)
    assert shown.coarse is not None
    return {
        **shown.drawn(about),
        "inside": as_base64((shown.coarse.values >= shown.level).astype(np.uint8)),
        "shape": shown.coarse.shape,
        "origin": shown.coarse.origin.tolist(),
        "spacing": float(shown.coarse.spacing[0]),
    }


def _distances(structure: Structure, table: str) -> dict[str, Any]:
    """Rows of two atoms by their names and an interval, Angstrom. Distances of labels and atoms are
    left out, and a note says so: the page has alpha carbons alone."""
    atoms, _ = nodes_to_fit(structure)
    data = read_distances(table, Sites(structure, atoms))
    direct = [not datum.local.any() and datum.atoms is None for datum in data]
    if left := direct.count(False):
        console.note(f"{left} of {len(data)} distances are of labels or atoms: not shown")
    rows = [
        {
            "names": [structure.label(int(atoms[node])) for node in datum.pair],
            "low": datum.low,
            "high": datum.high if math.isfinite(datum.high) else None,
        }
        for datum, is_shown in zip(data, direct, strict=True)
        if is_shown
    ]
    return {"rows": rows, "holds": HOLDS}
