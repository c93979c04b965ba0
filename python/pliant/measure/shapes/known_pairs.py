# SPDX-License-Identifier: MIT
"""How far apart known pairs of structures are whose networks are as soft: a hint how far to go."""

from __future__ import annotations

import numpy as np

#: softness of a structure (`pliant._core.softness`), and how far another known one of that protein
#: is (RMSD of alpha carbons, Angstrom): both directions of 29 pairs that BioEmu's benchmark has
#: because they differ (S. Lewis et al., Science 389 (2025) eadv9817). Made by
#: data/make_known_pairs.py: of 53 directions, each against those of other proteins, 57 % lie
#: between the quartiles. Among 17 measures of softness this one was chosen on the same pairs.
KNOWN = np.array([
    (0.1088, 3.99),  # P08709
    (0.1090, 1.52),  # P00766
    (0.1146, 1.90),  # P61586
    (0.1153, 1.90),  # P61586
    (0.1192, 2.44),  # P84080
    (0.1203, 3.99),  # P08709
    (0.1300, 2.87),  # P08037
    (0.1588, 5.07),  # P02911
    (0.1687, 7.13),  # P69441
    (0.1784, 6.92),  # P69441
    (0.1847, 9.90),  # P37487
    (0.1855, 3.42),  # P71447
    (0.1860, 2.86),  # P44542
    (0.1970, 3.06),  # Q29495
    (0.2063, 1.06),  # P56817
    (0.2152, 4.06),  # P0205
    (0.2207, 5.34),  # P0AEQ3
    (0.2214, 6.53),  # P23847
    (0.2293, 3.08),  # P0AEX9
    (0.2298, 2.64),  # Q02763
    (0.2407, 1.06),  # P56817
    (0.2540, 2.87),  # P08037
    (0.3007, 2.86),  # P44542
    (0.3038, 3.08),  # P0AEX9
    (0.3118, 3.49),  # P24182
    (0.3154, 2.64),  # Q02763
    (0.3290, 1.11),  # Q8WSF8
    (0.3325, 1.52),  # P00766
    (0.3502, 1.11),  # Q8WSF8
    (0.3559, 4.14),  # P0A7F3
    (0.3572, 5.07),  # P02911
    (0.3888, 4.06),  # P0205
    (0.3999, 3.98),  # Q16658
    (0.4068, 5.34),  # P0AEQ3
    (0.4080, 4.14),  # P0A7F3
    (0.4126, 16.51),  # A0A0H3AFX3
    (0.4413, 3.98),  # Q16658
    (0.4822, 6.53),  # P23847
    (0.5386, 7.13),  # P69441
    (0.5406, 6.92),  # P69441
    (0.5539, 3.06),  # Q29495
    (0.5566, 14.73),  # P0DP23
    (0.5676, 3.42),  # P71447
    (0.5696, 2.44),  # P84080
    (0.5982, 8.25),  # Q83VS8
    (0.6575, 14.32),  # P0DP23
    (0.6903, 7.82),  # B0F0C5
    (0.7004, 3.49),  # P24182
    (0.7160, 9.90),  # P37487
    (0.8829, 7.82),  # B0F0C5
    (0.9065, 16.51),  # A0A0H3AFX3
    (0.9689, 8.25),  # Q83VS8
    (1.1058, 11.89),  # P12823
    (1.2094, 11.89),  # P12823
    (1.3278, 10.32),  # P28366
    (1.6612, 14.32),  # P0DP23
    (1.6612, 14.73),  # P0DP23
    (4.8610, 10.32),  # P28366
])  # fmt: skip  # a table: a row a line
#: so many pairs that are nearest in softness are taken
LIKE = 16


def quartiles_of_like(soft: float, known: np.ndarray = KNOWN) -> np.ndarray | None:
    """(3,) quartiles of the distances of the LIKE pairs nearest in softness, Angstrom.

    known: (k, 2) softness and distance. None where as many are not found on both sides: beyond the
    ends of the table nothing is known.
    """
    order = np.argsort(known[:, 0], kind="stable")
    place = int(np.searchsorted(known[order, 0], soft))
    if place < 2 or place > len(known) - 2:
        return None
    first = min(max(place - LIKE // 2, 0), len(known) - LIKE)
    return np.asarray(np.percentile(known[order[first : first + LIKE], 1], [25, 50, 75]))
