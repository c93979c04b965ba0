# SPDX-License-Identifier: MIT
"""Programs that stand for AmberTools."""

import pytest
from fake_ambertools import install, methane


@pytest.fixture
def tools(monkeypatch, tmp_path):
    """Installs programs as `install` does, alone on the PATH but for those of the system."""
    ambertools = pytest.importorskip("pliant.checks.ligands.ambertools")

    def begin(**scripts):
        folder = install(tmp_path / "amber", methane(), **scripts)
        monkeypatch.setenv("PATH", f"{folder}:/usr/bin:/bin")
        monkeypatch.setattr(ambertools, "BESIDE", str(tmp_path))
        monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
        ambertools.version.cache_clear()
        return folder

    yield begin
    ambertools.version.cache_clear()
