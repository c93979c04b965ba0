# SPDX-License-Identifier: MIT
"""Shapes among frames: groups that are alike, and the frames that represent them."""
