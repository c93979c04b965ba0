# SPDX-License-Identifier: MIT
"""The molecule as the 3-D view needs it, coloured by rigid cluster and by flexibility."""

from __future__ import annotations

import contextlib
from string import ascii_letters
from typing import Any

import numpy as np

from pliant.report.page.view_limits import DrawnAtoms, as_base64, drawn_atoms, facing_the_reader
from pliant.report.rigidity.rigidity_facts import COLOURS, RigidityFacts

#: of fewer residues a flexibility of residues tells nothing
LEAST_RESIDUES = 4


def rigidity_scene(facts: RigidityFacts) -> dict[str, Any]:
    """One frame, as JSON-ready values for viewer.js."""
    drawn = _drawn_atoms(facts)
    atoms = drawn.chosen
    positions = facing_the_reader(facts.positions[None, atoms])
    step = max(float(np.abs(positions).max(initial=0.0)) / 32767, 1e-6)
    owners = facts.residue_of[atoms]
    units: dict[str, Any] = {"cluster": facts.cluster[atoms].tolist()}
    if len(facts.chains) >= LEAST_RESIDUES:
        units["flexibility"] = np.clip(facts.flexibility[owners], 0.0, 1.0).round(4).tolist()
    place = np.full(len(facts.names), -1)
    place[atoms] = np.arange(len(atoms))
    bonds = place[facts.bonds].reshape(-1, 2)
    return {
        "atoms": {
            "names": [facts.names[k] for k in atoms],
            "elements": [facts.elements[k] for k in atoms],
            "residues": [facts.residue_names[k] for k in owners],
            "numbers": [int(facts.numbers[k].rstrip(ascii_letters)) for k in owners],
            "chains": [facts.chains[k] for k in owners],
            "cartoon": _secondary_structure(facts, owners),
            "unit": list(range(len(atoms))),
        },
        "units": units,
        "palettes": {"cluster": COLOURS[: facts.named]},
        "legends": {
            "cluster": f"{facts.clusters} rigid cluster{'' if facts.clusters == 1 else 's'}, "
            f"{facts.named} with a colour; grey: smaller, or flexible"
        },
        "tops": {"flexibility": max(round(float(facts.flexibility.max(initial=0.0)), 2), 0.01)},
        "bonds": bonds[(bonds >= 0).all(axis=1)].ravel().tolist(),
        "bars": [],
        "frames": [0],
        "axis": {"label": "frame", "values": [0]},
        "step": step,
        "positions": as_base64(np.round(positions / step).astype("<i2")),
        "residuals": "",
        "residual_codes": {"per_decade": 1, "lowest": 0},
        "series": {},
        "notes": list(drawn.notes),
        "trace_only": drawn.trace_only,
    }


def _drawn_atoms(facts: RigidityFacts) -> DrawnAtoms:
    heavy = np.flatnonzero([element not in ("H", "D") for element in facts.elements])
    return drawn_atoms(
        len(facts.names),
        heavy,
        lambda: np.flatnonzero([name in ("CA", "P") for name in facts.names]),
    )


def _secondary_structure(facts: RigidityFacts, owners: np.ndarray) -> str:
    """One letter an atom, h s or c; empty if there is no protein. c only without MDAnalysis."""
    residues, atoms = facts.backbone()
    if len(residues) < LEAST_RESIDUES:
        return ""
    letters = np.full(len(facts.chains), "c")
    with contextlib.suppress(Exception):  # needs MDAnalysis 2.8 and six residues
        from MDAnalysis.analysis.dssp.pydssp_numpy import assign

        found = assign(facts.positions[atoms])
        letters[residues] = np.select([found[:, 1], found[:, 2]], ["h", "s"], "c")
    return "".join(letters[owners])
