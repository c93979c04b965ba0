# SPDX-License-Identifier: MIT
"""What a package index shows: no link of README.md is relative, and none leads nowhere."""

import email
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]
sys.path.insert(0, str(ROOT / "python" / "release"))

from project import package_metadata  # noqa: E402

ADDRESS = "https://git.invalid/someone/pliant"
LINK = re.compile(r"\]\(([^)\s]+)\)")
README = (ROOT / "README.md").read_text()

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


def test_the_metadata_have_the_address_or_none(metadata):
    address = package_metadata.repository()
    version = metadata["Version"]
    assert text_of(metadata).strip() == package_metadata.readme(address, version).strip()
    assert bool(metadata.get_all("Project-URL")) is bool(address)
    assert [link for link in LINK.findall(text_of(metadata)) if not link.startswith("https")] == []
    assert metadata["Description-Content-Type"] == "text/markdown"
    assert metadata["License-Expression"] == "MIT"


def test_with_an_address_links_and_pictures_lead_to_the_tag():
    text = package_metadata.readme(ADDRESS, "1.2.3")
    pages, files = f"{ADDRESS}/blob/v1.2.3/", f"{ADDRESS}/raw/v1.2.3/"
    targets = [t for t in LINK.findall(text) if t.startswith(ADDRESS)]
    assert len(targets) >= 10
    for target in targets:
        path = target.removeprefix(pages).removeprefix(files).partition("#")[0]
        assert (ROOT / path).exists(), target
    pictures = re.findall(r"!\[[^\]]*\]\(([^)]+)\)", text)
    assert pictures
    assert all(picture.startswith(files) for picture in pictures)
    assert f"({pages}docs/pages/index.md)" in text
    assert re.sub(re.escape(ADDRESS) + r"/(raw|blob)/v[\d.]+/", "", text) == README


def test_without_an_address_nothing_is_a_link_and_files_are_named():
    text = package_metadata.readme("", "1.2.3")
    assert LINK.findall(text) == []
    assert "![" not in text
    assert "Install (`docs/pages/install.md`)" in text
    named = re.findall(r"\(`([^`]+)`\)", text)
    assert len(named) >= 10
    assert [name for name in named if not (ROOT / name).exists()] == []
    assert "import pliant\n" in text  # code is as it was


def test_addresses_are_made_of_the_one_setting():
    assert package_metadata.urls("") == {}
    named = package_metadata.urls(ADDRESS)
    assert named["Source"] == ADDRESS
    assert all(url.startswith(ADDRESS) for url in named.values())
    for url in named.values():
        path = url.partition("/blob/HEAD/")[2]
        assert not path or (ROOT / path).is_file()


def test_a_slash_at_the_end_of_the_address_does_not_matter(tmp_path):
    (tmp_path / "pyproject.toml").write_text(f'[tool.pliant]\nrepository = "{ADDRESS}/"\n')
    assert package_metadata.repository(tmp_path) == ADDRESS
