# SPDX-License-Identifier: MIT
"""Structures fitted to measured distances: ``pliant fit``, ``pliant.fit``; and which distances to
measure: ``pliant design``, ``pliant.design``.
"""
