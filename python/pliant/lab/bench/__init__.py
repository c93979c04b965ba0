# SPDX-License-Identifier: MIT
"""How fast, how accurate, how stable: ``pliant bench``, with OpenMM's CCMA in the same process."""
