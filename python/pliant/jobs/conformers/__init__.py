# SPDX-License-Identifier: MIT
"""Ranked conformers of small molecules: ``pliant conformers``, ``pliant.conformers``."""
