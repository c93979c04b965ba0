# SPDX-License-Identifier: MIT
"""A clone with what the quick checks of a release read."""

import subprocess

from project import Project

SECTION = "\nWhat it is.\n\n### Added\n\n- A thing.\n\n### Fixed\n\n- A [fault](docs/a.md).\n"


def small_project(tmp_path):
    """A clone with what the quick checks read, and nothing wrong in it."""
    files = {
        ".gitignore": "build/\n",
        "CMakeLists.txt": "project(pliant VERSION 1.2.3 LANGUAGES CXX)\n",
        "CITATION.cff": "version: 1.2.3\ndate-released: 2027-01-02\n",
        "docs/pages/cite.md": "  version = {1.2.3},\n",
        "CHANGELOG.md": f"# Changelog\n\n## 1.2.3 (2027-01-02)\n{SECTION}",
        "pyproject.toml": '[project]\nname = "a"\n\n[tool.pliant]\nmaintainers = []\n',
    }
    for name, text in files.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    in_git(tmp_path, "init", "--quiet")
    commit(tmp_path)
    return Project(tmp_path)


def in_git(folder, *words):
    who = ("-c", "user.name=a", "-c", "user.email=a@b.invalid")
    subprocess.run(["git", *who, *words], cwd=folder, check=True, capture_output=True)


def commit(folder):
    in_git(folder, "add", "--all")
    in_git(folder, "commit", "--quiet", "--allow-empty", "--message", "a")
