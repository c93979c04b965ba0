# SPDX-License-Identifier: MIT
"""Pockets: where they are, their volume in each frame, and which of them open."""
