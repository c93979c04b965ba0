# SPDX-License-Identifier: MIT
"""What a package index shows of README.md: its relative links become absolute ones.

Called by the build (``[tool.scikit-build.metadata]`` in pyproject.toml) when an sdist or a wheel
gets its metadata. In the repository links stay relative, so that they work on disk.
"""

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]

LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^)\s]+)\)")
CODE = re.compile(r"(^```.*?^```$)", re.MULTILINE | re.DOTALL)
ELSEWHERE = re.compile(r"[a-z]+:|#")


def with_absolute_links(markdown: str, repository: str, version: str) -> str:
    """The text with links into the repository as it is at the tag of this version."""

    def absolute(found: re.Match[str]) -> str:
        picture, text, target = found.groups()
        if ELSEWHERE.match(target):
            return found[0]
        kind = "raw" if picture else "blob"
        return f"{picture}[{text}]({repository.rstrip('/')}/{kind}/v{version}/{target})"

    parts = CODE.split(markdown)  # text and code in turn
    return "".join(part if k % 2 else LINK.sub(absolute, part) for k, part in enumerate(parts))


def dynamic_metadata(
    field: str, settings: Mapping[str, str], project: Mapping[str, Any]
) -> dict[str, str]:
    """The readme of the metadata; what scikit-build-core calls."""
    if field != "readme":
        raise ValueError(f"{field}: only the readme is made here")
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    text = with_absolute_links(text, settings["repository"], project["version"])
    return {"content-type": "text/markdown", "text": text}
