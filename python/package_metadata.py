# SPDX-License-Identifier: MIT
"""What a package index shows of README.md, and the addresses beside it.

Called by the build (``[tool.scikit-build.metadata]`` in pyproject.toml) when an sdist or a wheel
gets its metadata. ``[tool.pliant]`` there holds the address of the repository, and nothing else
does. In the repository links are relative, so that they work on disk; on an index they begin with
the address. While there is no address, a link is its text and the file that it names, and pictures
are left out.
"""

import re
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).resolve().parents[1]

LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^)\s]+)\)")
PICTURE = re.compile(r"^!\[[^\]]*\]\([^)\s]+\)\n+", re.MULTILINE)
CODE = re.compile(r"(^```.*?^```$)", re.MULTILINE | re.DOTALL)
ELSEWHERE = re.compile(r"[a-z]+:|#")
WITHOUT_LINKS = """
The files that this text names are in the source archive (sdist), which has its pictures, too.
"""


def project_settings(root: Path = ROOT) -> dict[str, Any]:
    """``[tool.pliant]`` of pyproject.toml."""
    with (root / "pyproject.toml").open("rb") as file:
        return dict(tomllib.load(file)["tool"]["pliant"])


def repository(root: Path = ROOT) -> str:
    """Where the repository can be read, without a slash at the end; empty if nowhere yet."""
    return str(project_settings(root)["repository"]).rstrip("/")


def with_absolute_links(markdown: str, address: str, version: str) -> str:
    """The text with links into the repository as it is at the tag of this version."""

    def absolute(found: re.Match[str]) -> str:
        picture, text, target = found.groups()
        if ELSEWHERE.match(target):
            return found[0]
        kind = "raw" if picture else "blob"
        return f"{picture}[{text}]({address}/{kind}/v{version}/{target})"

    return _outside_code(markdown, lambda part: LINK.sub(absolute, part))


def without_links(markdown: str) -> str:
    """The text with the files that links lead to in parentheses, and without pictures."""

    def plain(found: re.Match[str]) -> str:
        _, text, target = found.groups()
        file = target.partition("#")[0]
        if ELSEWHERE.match(target) or text == file:
            return found[0] if text != file else text
        return f"{text} (`{file}`)"

    text = _outside_code(markdown, lambda part: LINK.sub(plain, PICTURE.sub("", part)))
    return text + WITHOUT_LINKS


def _outside_code(markdown: str, change: Any) -> str:
    parts = CODE.split(markdown)  # text and code in turn
    return "".join(part if k % 2 else change(part) for k, part in enumerate(parts))


def readme(address: str, version: str) -> str:
    """README.md for a package index."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    return with_absolute_links(text, address, version) if address else without_links(text)


def urls(address: str) -> dict[str, str]:
    """The Project-URLs of the metadata; none if there is no address."""
    pages = {
        "Source": "",
        "Documentation": "/blob/HEAD/docs/pages/index.md",
        "Changelog": "/blob/HEAD/CHANGELOG.md",
        "Issues": "/issues",
    }
    return {name: address + path for name, path in pages.items()} if address else {}


def dynamic_metadata(
    field: str, settings: Mapping[str, str], project: Mapping[str, Any]
) -> dict[str, str]:
    """One field of the metadata; what scikit-build-core calls."""
    del settings
    if field == "urls":
        return urls(repository())
    if field != "readme":
        raise ValueError(f"{field}: only the readme and the addresses are made here")
    return {"content-type": "text/markdown", "text": readme(repository(), str(project["version"]))}
