# SPDX-License-Identifier: MIT
"""Rotors of conformers do not depend on the Kekule form in which a file draws aromatic rings."""

from __future__ import annotations

import json

import pytest

pytest.importorskip("rdkit")
from drawings import drawings, embedded

IMATINIB = "Cc1ccc(cc1Nc2nccc(n2)c3cccnc3)NC(=O)c4ccc(cc4)CN5CCN(CC5)C"


def rotors_of(block, pliant, folder):
    """Atoms of each bond that the command turns about, counted from 0."""
    path = folder / "drawn.sdf"
    path.write_text(block + "$$$$\n")
    ended = pliant("sample", path, "-o", "out.h5md", "--frames", "2", "--overwrite", "--json")
    assert ended.code == 0, ended.err
    return json.loads(ended.out)["rotors"]


@pytest.mark.parametrize("drawing", range(3))
def test_anilinopyridine_has_two_rotors_in_each_drawing(drawing, pliant, tmp_path):
    block = list(drawings(embedded("c1ccccc1Nc1ccccn1")))[drawing]
    assert len(rotors_of(block, pliant, tmp_path)) == 2


@pytest.mark.long
def test_the_amine_of_imatinib_turns_in_each_drawing(pliant, tmp_path):
    made = embedded(IMATINIB)
    sets = [rotors_of(block, pliant, tmp_path) for block in drawings(made)]
    assert len(sets) > 4
    assert all(one == sets[0] for one in sets)
    assert {"C(7) - N(8)", "N(8) - C(9)"} < set(sets[0])
    assert "N(21) - C(22)" not in sets[0]  # the amide
