# SPDX-License-Identifier: MIT
"""What a package index shows: no link of README.md is relative, and none leads nowhere."""

import email
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]
LINK = re.compile(r"\]\(([^)\s]+)\)")

METADATA_STEP = """
import sys
from scikit_build_core.build import prepare_metadata_for_build_wheel as prepare
print(prepare(sys.argv[1]))
"""


@pytest.fixture(scope="module")
def metadata(tmp_path_factory):
    pytest.importorskip("scikit_build_core", reason="./dev build installs it")
    folder = tmp_path_factory.mktemp("metadata")
    done = subprocess.run(
        [sys.executable, "-c", METADATA_STEP, folder],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    (path,) = folder.glob("*.dist-info/METADATA")
    return email.message_from_bytes(path.read_bytes())


def text_of(metadata):
    return metadata.get_payload(decode=True).decode()


def test_nothing_is_a_link_and_files_are_named(metadata):
    text = text_of(metadata)
    assert [target for target in LINK.findall(text) if not target.startswith("https")] == []
    assert "![" not in text
    assert "Install (`docs/pages/install.md`)" in text
    named = re.findall(r"\(`([^`]+)`\)", text)
    assert len(named) >= 10
    assert [name for name in named if not (ROOT / name).exists()] == []
    assert "import pliant\n" in text  # code is as it was
    assert metadata["Description-Content-Type"] == "text/markdown"
    assert metadata["License-Expression"] == "MIT"
