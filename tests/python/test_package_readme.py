# SPDX-License-Identifier: MIT
"""What a package index shows: no link or picture of README.md is relative in the metadata."""

import email
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
LINK = re.compile(r"\]\(([^)\s]+)\)")

METADATA_STEP = """
import sys
from scikit_build_core.build import prepare_metadata_for_build_wheel as prepare
print(prepare(sys.argv[1]))
"""


def repository():
    lines = (ROOT / "pyproject.toml").read_text().splitlines()
    (line,) = [line for line in lines if line.startswith("repository = ")]
    return line.split('"')[1]


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


def test_metadata_holds_no_relative_link(metadata):
    text = metadata.get_payload(decode=True).decode()
    links = LINK.findall(text)
    ours = [link for link in links if link.startswith(repository() + "/")]
    assert len(ours) >= 10
    assert [link for link in links if not link.startswith("https://")] == []


def test_pictures_are_files_and_pages_are_shown(metadata):
    text = metadata.get_payload(decode=True).decode()
    start = f"{repository()}/raw/v{metadata['Version']}/"
    pictures = re.findall(r"!\[[^\]]*\]\(([^)]+)\)", text)
    assert pictures
    for picture in pictures:
        assert picture.startswith(start)
        assert (ROOT / picture.removeprefix(start)).is_file()
    assert f"({repository()}/blob/v{metadata['Version']}/docs/pages/index.md)" in text


def test_the_rest_is_as_in_the_repository(metadata):
    text = metadata.get_payload(decode=True).decode()
    start = f"{repository()}/"
    plain = re.sub(re.escape(start) + r"(raw|blob)/v[\d.]+/", "", text)
    assert plain.strip() == (ROOT / "README.md").read_text().strip()
    assert metadata["Description-Content-Type"] == "text/markdown"
