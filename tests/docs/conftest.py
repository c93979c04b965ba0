# SPDX-License-Identifier: MIT
"""Lets the tests of this folder import what the site is built with, and builds it."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

DOCS = Path(__file__).parents[2] / "docs"
SITE = DOCS.parent / "build" / "site"
sys.path[:0] = [str(DOCS), str(DOCS / "tools")]


@pytest.fixture(scope="session")
def site():
    """The site, built without a warning; with PLIANT_SITE_AS_IS the one that is there."""
    if "PLIANT_SITE_AS_IS" in os.environ:
        return SITE
    pytest.importorskip("mkdocs", reason="./dev docs installs what builds the site")
    command = ["mkdocs", "build", "--strict", "--config-file", "docs/mkdocs.yml"]
    done = subprocess.run(
        [sys.executable, "-m", *command],
        cwd=DOCS.parent,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert "WARNING" not in done.stderr.replace("WARNING=1", "")
    return SITE
