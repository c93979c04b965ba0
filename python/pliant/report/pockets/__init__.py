# SPDX-License-Identifier: MIT
"""How much room the pockets of a molecule have in each frame."""
