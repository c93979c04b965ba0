# SPDX-License-Identifier: MIT
"""Which backbone angles of amino acids are allowed: a table of 10 degrees, and its lookup."""

from __future__ import annotations

import numpy as np

FAVOURED = 2
ALLOWED = 1
OUTLIER = 0

#: Residues with a side chain that is not proline's. Rows: psi, from that written to 10 degrees
#: more; columns: phi from -180 in steps of 10. "#": the cells that hold 90 % of the residues of
#: the 500 structures of S. C. Lovell et al., Proteins 50 (2003) 437 (counted by MDAnalysis,
#: `Rama_ref`), "+": the others of the cells that hold 99.5 %. Cells of glycine, that is phi > 0 but
#: for the left-handed helix, were taken out.
_TABLE = (
    "+######+###++                       ",  # 170
    "+###########+                       ",  # 160
    "+############+                      ",  # 150
    "+############+                      ",  # 140
    "++############                      ",  # 130
    "+++###########+                     ",  # 120
    " +++########+++                     ",  # 110
    " +++######++++                      ",  # 100
    " +++++####+++                       ",  # 90
    " ++++++++#++                        ",  # 80
    " ++++++++#++          +++           ",  # 70
    "  +++++++++          +++++          ",  # 60
    "  ++++++++++         +##++          ",  # 50
    "  +++++++++          +##+++         ",  # 40
    "  ++++++++            +##+++        ",  # 30
    "  +++###+++           +###+++       ",  # 20
    "  +++#####++           +###++       ",  # 10
    " + ++######+            +###+       ",  # 0
    "   ++#######+           ++##+       ",  # -10
    "    ++#######            ++#+       ",  # -20
    "  +++++######+          +++++       ",  # -30
    "  +++++#######+         +++++       ",  # -40
    "    ++++######+                     ",  # -50
    "   +++++++####++                    ",  # -60
    "  + +++++++++++                     ",  # -70
    "  +++++++++++ +                     ",  # -80
    "     + +++                          ",  # -90
    "    ++++                            ",  # -100
    "      +++                           ",  # -110
    "     ++++                           ",  # -120
    "    +++++                           ",  # -130
    "    +++++                           ",  # -140
    " +++++++++                          ",  # -150
    "+++++++++++                         ",  # -160
    "++++++++++++                        ",  # -170
    "+++++++++#++                        ",  # -180
)


def _codes() -> np.ndarray:
    """The table as (36, 36) codes by psi and phi, both rising from -180."""
    values = {"#": FAVOURED, "+": ALLOWED, " ": OUTLIER}
    return np.array([[values[cell] for cell in row] for row in reversed(_TABLE)])


_CODES = _codes()


def judged(phi: np.ndarray, psi: np.ndarray) -> np.ndarray:
    """FAVOURED, ALLOWED or OUTLIER of each pair of angles, degrees; any shape."""
    rows, columns = (
        np.floor((np.asarray(angle) + 180.0) / 10.0).astype(int) % 36 for angle in (psi, phi)
    )
    found: np.ndarray = _CODES[rows, columns]
    return found
