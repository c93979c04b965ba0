# SPDX-License-Identifier: MIT
"""Lets the tests of this folder import what the site is built with."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2] / "docs" / "tools"))
