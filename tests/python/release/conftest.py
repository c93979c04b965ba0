# SPDX-License-Identifier: MIT
"""What tests of releases share."""

import sys
from pathlib import Path

import pytest

HERE = Path(__file__).parent
# for all tests beside
sys.path[:0] = [str(HERE), str(HERE.parents[2] / "python" / "release")]

from small_project import small_project  # noqa: E402


@pytest.fixture
def small(tmp_path):
    """A clone in which nothing is wrong."""
    return small_project(tmp_path)
