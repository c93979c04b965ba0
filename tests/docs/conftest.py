# SPDX-License-Identifier: MIT
"""Lets the tests of this folder import what the site is built with."""

import sys
from pathlib import Path

DOCS = Path(__file__).parents[2] / "docs"
sys.path[:0] = [str(DOCS), str(DOCS / "tools")]
