# SPDX-License-Identifier: MIT
"""Tests of an installed package: ``pytest --pyargs pliant``. They need no files but their own."""
