# SPDX-License-Identifier: MIT
"""Two ensembles, or two paths, in numbers: which atoms are the same, and how alike they move."""
