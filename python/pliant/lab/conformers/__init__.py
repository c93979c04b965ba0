# SPDX-License-Identifier: MIT
"""Conformers beside those of RDKit and CDPKit, against known ones: ``pliant bench conformers``."""
