# SPDX-License-Identifier: MIT
"""How fast, how accurate, how stable: ``pliant lab bench``, with OpenMM's CCMA in one process."""
