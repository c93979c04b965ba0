# SPDX-License-Identifier: MIT
"""Cells of CSV files that no spreadsheet takes for a formula."""

from __future__ import annotations

MARKS = ("=", "+", "-", "@")


def harmless(value: object) -> object:
    """A text that begins with ``= + - @`` gets an apostrophe before it; numbers stay as they are.

    Spreadsheets run such a text as a formula; after an apostrophe it is text.
    """
    if not isinstance(value, str) or not value.startswith(MARKS) or _is_number(value):
        return value
    return "'" + value


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True
