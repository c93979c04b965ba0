# SPDX-License-Identifier: MIT
"""How rigidity is counted, and how its page is to be read."""

from pliant._core import contact_kinds

BARS = ", ".join(f"{kind.singular} {kind.bars}" for kind in contact_kinds())

READING = (
    "Believe what holds together over a range of cut-offs. A cluster is not necessarily stiff, and "
    "a degree of freedom is not an amplitude."
)

METHODS = (
    (
        "Count",
        "Each atom is a body with six freedoms. A bond that can rotate removes five (a hinge), "
        f"one that does not six, a contact its own number ({BARS}), unless they "
        "depend on those before: internal degrees of freedom = 6 atoms - independent constraints - "
        "6 parts (D. J. Jacobs, M. F. Thorpe, Phys. Rev. Lett. 75 (1995) 4051; D. J. Jacobs, A. J. "
        "Rader, L. A. Kuhn, M. F. Thorpe, Proteins 44 (2001) 150).",
    ),
    (
        "Which constraints are independent",
        "The (6,6) pebble game: each body has six pebbles, an independent constraint takes one, "
        "and it is independent if seven can be gathered at its ends (A. Lee, I. Streinu, Discrete "
        "Math. 308 (2008) 1425). For constraints in general directions that is the rank of the "
        "rigidity matrix (T.-S. Tay, J. Combin. Theory B 36 (1984) 95; W. Whiteley, SIAM J. "
        "Discrete Math. 1 (1988) 237); that hinges at one atom meet there changes nothing, the "
        "molecular conjecture (N. Katoh, S. Tanigawa, Discrete Comput. Geom. 45 (2011) 647).",
    ),
    (
        "Flexibility",
        "Of a bond between clusters: the freedoms of its block over those that the bonds of the "
        "block would have each alone. Of a bond in a cluster: - redundant constraints / "
        "constraints. Of a residue: the mean of N-CA and CA-C.",
    ),
    (
        "Dilution",
        "Hydrogen bonds are removed one by one, weakest first (B. M. Hespenheide, A. J. Rader, M. "
        "F. Thorpe, L. A. Kuhn, J. Mol. Graph. Model. 21 (2002) 195).",
    ),
    (
        "Not claimed",
        "The count ignores positions: flat rings and axes that meet by symmetry may move where it "
        "says rigid. Contacts are there or not; everything depends on which of them count.",
    ),
)
