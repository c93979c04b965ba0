# SPDX-License-Identifier: MIT
"""Files by which others take a version in: the recipe of conda-forge, and the entry of MDAKits."""

from __future__ import annotations

import re
from pathlib import Path

from project import Project

HERE = Path(__file__).parent


def missing(project: Project) -> list[str]:
    """What pyproject.toml does not say yet and the registry of MDAKits needs."""
    needed = {
        "Source of [project.urls]": project.address(),
        "maintainers of [tool.pliant]": project.maintainers(),
    }
    return [name for name, value in needed.items() if not value]


def conda(project: Project, digest: str) -> str:
    """The recipe for the archive of this version, whose SHA-256 is given."""
    home = f"  homepage: {project.address()}\n" if project.address() else ""
    text = _filled("conda_recipe.yaml", project).replace("  @HOME@\n", home)
    return text.replace("@SHA256@", digest)


def mdakit(project: Project) -> str:
    """What the registry asks for; nothing must be missing."""
    settings = project.text("pyproject.toml")
    text = _filled("mdakit.yaml", project).replace("@ADDRESS@", project.address())
    for name, pattern in {
        "LICENSE": r'^license = "(.+)"',
        "PYTHON": r'^requires-python = "(.+)"',
        "MDANALYSIS": r'"MDAnalysis(>=[\d.]+)", "scipy',
        "STATUS": r'"Development Status :: \d - (.+)"',
    }.items():
        (found,) = re.findall(pattern, settings, re.MULTILINE)
        text = text.replace(f"@{name}@", found)
    return text


def _filled(template: str, project: Project) -> str:
    """A file beside this one with the version and its maintainers, one a line."""
    text = (HERE / template).read_text(encoding="utf-8").replace("@VERSION@", project.version())

    def rows(found: re.Match[str]) -> str:
        names = [f"{found[1]}- {one}\n" for one in project.maintainers()]
        return "".join(names) or f"{found[1]}[]\n"

    return re.sub(r"^( *)@MAINTAINERS@\n", rows, text, flags=re.MULTILINE)
