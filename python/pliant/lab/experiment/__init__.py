# SPDX-License-Identifier: MIT
"""``pliant lab experiment``: techniques on random graphs, and what the thesis claims of them."""
