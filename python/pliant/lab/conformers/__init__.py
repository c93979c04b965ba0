# SPDX-License-Identifier: MIT
"""Conformers beside RDKit's and CDPKit's, against known ones: ``pliant lab bench conformers``."""
