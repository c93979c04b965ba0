# SPDX-License-Identifier: MIT
"""Two ensembles, or two paths, side by side: ``pliant compare``, ``pliant.compare``."""
