# SPDX-License-Identifier: MIT
"""The headings of the page of an analysis, in the order in which they are read."""

DATA = "Does it agree with the data?"
FLEXIBLE = "What is flexible"
TOGETHER = "What moves together"
COLLECTIVE = "Collective motions"
OTHER = "What else it could look like"
POCKETS = "Pockets"
LIGANDS = "Ligands"
CHEMISTRY = "Contacts and stereochemistry"
ON_THE_WAY = "How it gets there"
SHAPES = "Shape"
STARTS = "Starting molecular dynamics"
EXACT = "Exactness and effort"

#: those whose figures and tables are as wide as the page
WIDE = (OTHER, POCKETS, LIGANDS)
HEADINGS = (
    *(DATA, FLEXIBLE, TOGETHER, COLLECTIVE, OTHER, POCKETS, LIGANDS, ON_THE_WAY, CHEMISTRY),
    *(STARTS, SHAPES, EXACT),
)
