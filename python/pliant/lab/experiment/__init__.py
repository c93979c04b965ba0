# SPDX-License-Identifier: MIT
"""``pliant experiment``: techniques on random graphs, and what the thesis claims of them."""
