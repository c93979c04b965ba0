# SPDX-License-Identifier: MIT
"""Molecules as programs of MD leave them: cut by the faces of their periodic box."""

import numpy as np
from MDAnalysis.lib import distances, mdamath

#: boxes about as large as the peptide
BOXES = {
    "right": [30.0, 30.0, 30.0, 90.0, 90.0, 90.0],
    "dodecahedron": [32.0, 32.0, 32.0, 60.0, 60.0, 90.0],
    "triclinic": [30.0, 33.0, 36.0, 75.0, 80.0, 105.0],
}


def cut_pdb(structure, box, *, with_cell=True):
    """The text of a PDB file whose atoms lie in the box, whose faces cut the molecule."""
    middle = mdamath.triclinic_vectors(box).sum(axis=0) / 2
    moved = structure.positions - structure.positions.mean(axis=0) + 0.9 * middle + middle
    inside = distances.apply_PBC(moved.astype(np.float32), np.array(box, np.float32))
    lines = ["CRYST1{:9.3f}{:9.3f}{:9.3f}{:7.2f}{:7.2f}{:7.2f} P 1".format(*box)] * with_cell
    for k, (x, y, z) in enumerate(inside):
        lines.append(
            f"ATOM  {k + 1:>5} {structure.names[k]:<4} {structure.residue_names[k]:>3} A"
            f"{structure.residue_ids[k]:>4}    {x:8.3f}{y:8.3f}{z:8.3f}  1.00  0.00"
            f"          {structure.symbols[k]:>2}"
        )
    return "\n".join(lines) + "\n"
