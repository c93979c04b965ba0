# SPDX-License-Identifier: MIT
"""Conformers of small molecules beside those of RDKit and CDPKit, against known ones."""
