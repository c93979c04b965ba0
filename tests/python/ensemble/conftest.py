# SPDX-License-Identifier: MIT
"""An ensemble that is whole."""

import pytest
from ensembles import PEPTIDE, made


@pytest.fixture(scope="session")
def ensemble(tmp_path_factory):
    """A folder with 24 walkers in 6 shards. Not to be changed."""
    folder = tmp_path_factory.mktemp("ensemble") / "many"
    made(PEPTIDE, "-o", folder, "--walkers", 24, "--shard-size", 4, "--steps", 40, "--every", 10)
    return folder
