# SPDX-License-Identifier: MIT
"""The recipe of a conda package, in the form of conda-forge: built of the published sources."""

from __future__ import annotations

from pathlib import Path

from project import Project

TEMPLATE = Path(__file__).with_name("conda_recipe.yaml")


def recipe(project: Project, digest: str) -> str:
    """The recipe for the archive of this version, whose SHA-256 is given."""
    text = TEMPLATE.read_text(encoding="utf-8")
    for name, value in {"VERSION": project.version(), "SHA256": digest}.items():
        text = text.replace(f"@{name}@", value)
    home = f"  homepage: {project.address()}\n" if project.address() else ""
    accounts = "".join(f"    - {one}\n" for one in project.maintainers()) or "    []\n"
    return text.replace("  @HOME@\n", home).replace("    @MAINTAINERS@\n", accounts)
