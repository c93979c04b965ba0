# SPDX-License-Identifier: MIT
"""The sections of the report page, in the order in which they are read."""

FLEXIBLE = "What is flexible"
TOGETHER = "What moves together"
COLLECTIVE = "Collective motions"
CHEMISTRY = "Contacts and stereochemistry"
SHAPES = "Shape"
EXACT = "Exactness and effort"

SECTIONS = (FLEXIBLE, TOGETHER, COLLECTIVE, CHEMISTRY, SHAPES, EXACT)
