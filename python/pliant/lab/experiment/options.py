# SPDX-License-Identifier: MIT
"""Options that all of pliant lab experiment has."""

from __future__ import annotations

from pliant.base import console


def add_running(parser: console.Parser) -> None:
    """Options that change how it runs, not what comes out."""
    processes = console.whole_number(1, most=console.MOST_PROCESSES)
    parser.add_argument(
        "--workers", metavar="N", type=processes, help="number of processes (default: one per core)"
    )
    parser.add_argument("--quiet", action="store_true", help="show no progress")
    parser.add_argument("--json", action="store_true", help="print the summary as JSON")
