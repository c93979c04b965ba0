# SPDX-License-Identifier: MIT
"""Frames in formats that other programs read: ``pliant convert``, ``pliant.convert``."""
