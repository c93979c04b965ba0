# SPDX-License-Identifier: MIT
"""Molecules and frames as objects that connect with other packages."""
