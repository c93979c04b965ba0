# SPDX-License-Identifier: MIT
"""Shards of an ensemble, read as one trajectory."""
