# SPDX-License-Identifier: MIT
"""Frames that explain a SAXS curve: ``pliant fit START --saxs``."""
