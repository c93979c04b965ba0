# SPDX-License-Identifier: MIT
"""The program pliant-rigidity-page, which ``pliant rigidity --page FILE`` runs."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence

from pliant._core import InputError
from pliant.base.console import EXIT_OK, Parser, run_command
from pliant.base.input_files import json_object
from pliant.report.rigidity.rigidity_facts import facts_of_json
from pliant.report.rigidity.rigidity_page import save_rigidity_page

DESCRIPTION = """\
Writes the page of pliant rigidity --page FILE, which runs this: what was found comes as JSON on
standard input."""


def main(words: Sequence[str] | None = None) -> int:
    """Runs the program; returns its exit code."""
    parser = Parser("rigidity-page", DESCRIPTION)
    parser.add_argument("-o", "--output", metavar="FILE", required=True, help="page to write")
    parser.add_argument("--overwrite", action="store_true", help="replace an existing file")
    options = parser.parse_args(words)
    return run_command("rigidity", lambda: _write(options))


def _write(options: argparse.Namespace) -> int:
    try:
        facts = facts_of_json(json_object(sys.stdin.buffer.read()))
    except (ValueError, KeyError, TypeError):
        raise InputError("standard input: expected what pliant rigidity --page hands on") from None
    save_rigidity_page(facts, options.output, overwrite=options.overwrite)
    return EXIT_OK


if __name__ == "__main__":
    sys.exit(main())
