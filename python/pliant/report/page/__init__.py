# SPDX-License-Identifier: MIT
"""The page of a report: its parts, its view of the molecule, its words."""
