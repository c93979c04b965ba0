# SPDX-License-Identifier: MIT
"""The molecule as the 3-D view needs it, coloured by rigid cluster and by flexibility."""

from __future__ import annotations

from string import ascii_letters
from typing import Any

import numpy as np

from pliant._core import Structure
from pliant.report.page.drawn import DrawnAtoms, drawn_atoms, drawn_molecule, drawn_positions
from pliant.report.rigidity.rigidity_facts import COLOURS, RigidityFacts

#: of fewer residues a flexibility of residues tells nothing
LEAST_RESIDUES = 4


def rigidity_scene(facts: RigidityFacts) -> dict[str, Any]:
    """One frame, as JSON-ready values for viewer.mjs."""
    drawn = _drawn_atoms(facts)
    atoms = drawn.chosen
    units: dict[str, Any] = {"cluster": facts.cluster[atoms].tolist()}
    if len(facts.chains) >= LEAST_RESIDUES:
        flexibility = facts.flexibility[facts.residue_of[atoms]]
        units["flexibility"] = np.clip(flexibility, 0.0, 1.0).round(4).tolist()
    place = np.full(len(facts.names), -1)
    place[atoms] = np.arange(len(atoms))
    bonds = place[facts.bonds].reshape(-1, 2)
    molecule = drawn_molecule(_structure(facts), atoms)
    molecule["atoms"]["unit"] = list(range(len(atoms)))
    return {
        **molecule,
        **drawn_positions(facts.positions[None, atoms]),
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
        "residuals": "",
        "residual_codes": {"per_decade": 1, "lowest": 0},
        "series": {},
        "notes": list(drawn.notes),
        "trace_only": drawn.trace_only,
    }


def _structure(facts: RigidityFacts) -> Structure:
    owners = facts.residue_of
    numbers = [facts.numbers[k] for k in owners]
    return Structure(
        facts.positions,
        elements=facts.elements,
        names=facts.names,
        residue_names=[facts.residue_names[k] for k in owners],
        residue_ids=[int(number.rstrip(ascii_letters)) for number in numbers],
        insertion_codes=[number.lstrip("-0123456789") for number in numbers],
        chains=[facts.chains[k] for k in owners],
    )


def _drawn_atoms(facts: RigidityFacts) -> DrawnAtoms:
    heavy = np.flatnonzero([element not in ("H", "D") for element in facts.elements])
    return drawn_atoms(
        len(facts.names),
        heavy,
        lambda: np.flatnonzero([name in ("CA", "P") for name in facts.names]),
    )
