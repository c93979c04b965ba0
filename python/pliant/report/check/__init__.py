# SPDX-License-Identifier: MIT
"""Checks against OpenMM, as text, JSON and a picture."""
