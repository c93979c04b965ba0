# SPDX-License-Identifier: MIT
"""What a release consists of, in one folder: wheels, sources, sums, notes, recipes."""

from __future__ import annotations

import hashlib
import shutil
from pathlib import Path

import changelog
import recipes
from project import Project

WHEELS = Path("build") / "wheels"
SOURCES = Path("build") / "sdist"
TARGETS = "python/wheel/targets.txt"  # the systems that a release serves
PYTHONS = ("cp310-cp310", "cp311-cp311", "cp312-abi3")


def wheels(project: Project) -> list[Path]:
    """The wheels of this version that are made."""
    return sorted((project.root / WHEELS).glob(f"pliant-{project.version()}-*.whl"))


def sources(project: Project) -> Path:
    """The archive of the sources of this version, whether it is made or not."""
    return project.root / SOURCES / f"pliant-{project.version()}.tar.gz"


def missing_wheels(project: Project) -> list[str]:
    """Which wheel of which system is not made."""
    lines = project.text(TARGETS).splitlines()
    platforms = {row[0]: row[2] for line in lines if (row := line.split()) and row[0] != "#"}
    names = [path.name for path in wheels(project)]
    return [
        f"{system}, {python}"
        for system, platform in platforms.items()
        for python in PYTHONS
        if not any(name.endswith(f"-{python}-{platform}.whl") for name in names)
    ]


def make(project: Project, folder: Path) -> list[Path]:
    """Fills a folder that is made anew; what it has, the files with sums first."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    packages = [path for path in (*wheels(project), sources(project)) if path.is_file()]
    made = [Path(shutil.copy2(path, folder)) for path in packages]
    sums = "".join(f"{digest(path)}  {path.name}\n" for path in made)
    texts = {"SHA256SUMS": sums, "RELEASE_NOTES.md": notes(project)}
    if sources(project).is_file():
        texts["recipe.yaml"] = recipes.conda(project, digest(sources(project)))
    if not recipes.missing(project):
        texts["metadata.yaml"] = recipes.mdakit(project)
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="utf-8")
    return [*made, *(folder / name for name in texts)]


def digest(path: Path) -> str:
    """SHA-256 of a file, as hexadecimal."""
    return hashlib.sha256(path.read_bytes()).hexdigest()


def notes(project: Project) -> str:
    """The section of the changelog as the text of the tag."""
    version = project.version()
    lines = changelog.section(project.text("CHANGELOG.md"), version)
    return changelog.notes(lines, f"Pliant {version}")
