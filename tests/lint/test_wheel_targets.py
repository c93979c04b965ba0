# SPDX-License-Identifier: MIT
"""The table of systems that wheels are made for, and what Python is told of them."""

import importlib
import re
import subprocess
import sys

import pytest
from sources import ROOT

FOLDER = ROOT / "python" / "wheel"


@pytest.fixture(scope="module")
def wheel():
    """The scripts as modules."""
    sys.path.insert(0, str(FOLDER))
    yield {name: importlib.import_module(name) for name in ("targets", "python_headers")}
    sys.path.remove(str(FOLDER))


def test_every_row_is_whole(wheel):
    rows = wheel["targets"].targets()
    assert len(rows) == len({row.platform for row in rows.values()}) == 5
    for name, row in rows.items():
        assert name == f"{row.system}-{row.processor}"
        assert row.tried in ("python", "qemu", "wine", "no")
        number = re.search(r"[0-9][0-9.]*", row.oldest)[0]
        if row.system == "macos":
            assert row.zig.endswith(f"-macos.{number}")
            assert row.platform == f"macosx_{number.replace('.', '_')}_{row.processor}"
        if row.system == "linux":
            assert row.zig == f"{row.processor}-linux-gnu.{number}"
            assert row.platform == f"manylinux_{number.replace('.', '_')}_{row.processor}"


def test_the_shell_reads_the_same_table(wheel):
    script = """. python/wheel/targets.sh; fields="zig platform oldest tried"
      for name in $(target_names); do
        echo $name $(for field in $fields; do target_field $name $field; done)
      done"""
    said = subprocess.run(["bash", "-c", script], cwd=ROOT, capture_output=True, text=True)
    rows = wheel["targets"].targets().values()
    assert said.stdout.splitlines() == [" ".join(row) for row in rows]
    missing = "set -e; . python/wheel/targets.sh; target_field beos-x86 zig"
    said = subprocess.run(["bash", "-c", missing], cwd=ROOT, capture_output=True, text=True)
    assert (said.returncode, said.stderr) == (1, "targets.txt: no target beos-x86\n")


def test_the_readme_has_every_system(wheel):
    text = (FOLDER / "README.md").read_text(encoding="utf-8")
    for row in wheel["targets"].targets().values():
        assert f"`{row.platform}`" in text


def test_sizes_that_python_is_told(wheel):
    told = wheel["python_headers"].pyconfig
    for system, size_of_long in (("linux", 8), ("macos", 8), ("windows", 4)):
        assert f"#define SIZEOF_LONG {size_of_long}\n" in told(system)
    assert "MS_WINDOWS" not in told("macos")
