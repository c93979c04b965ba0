# SPDX-License-Identifier: MIT
"""metadata.yaml, by which Pliant is handed in as a kit for MDAnalysis (MDAKit)."""

from __future__ import annotations

import re

from project import Project

TEXT = """\
# Pliant as a kit for MDAnalysis (MDAKit): the file that the registry of kits asks for. Written by
# ./dev release from pyproject.toml.
project_name: {name}
authors:
  - The Pliant authors
maintainers:
{maintainers}
description: >-
  Molecular flexibility by geometric constraints: ensembles of proteins and conformers of small
  molecules with exact bonds and angles, as H5MD trajectories that MDAnalysis opens alone, and
  analysis classes for them.
keywords:
  - flexibility
  - ensembles
  - conformers
  - constraints
  - rigidity
  - H5MD
license: {license}
project_home: {address}
documentation_home: {address}/blob/HEAD/docs/pages/index.md
documentation_type: UserGuide + API

install:
  - pip install "pliant[analysis]"
src_install:
  - pip install "pliant[analysis] @ git+{address}"
import_name: {name}
python_requires: "{python}"
mdanalysis_requires: "{mdanalysis}"
run_tests:
  - pytest --pyargs pliant
test_dependencies:
  - pip install pytest
development_status: {status}
changelog: {address}/blob/HEAD/CHANGELOG.md
"""


def missing(project: Project) -> list[str]:
    """What pyproject.toml does not say yet and the registry needs."""
    needed = {"repository": project.address(), "maintainers": project.maintainers()}
    return [f"{name} of [tool.pliant]" for name, value in needed.items() if not value]


def metadata(project: Project, address: str, maintainers: list[str]) -> str:
    """The file's text."""
    settings = project.text("pyproject.toml")

    def one(pattern: str) -> str:
        (found,) = re.findall(pattern, settings, re.MULTILINE)
        return str(found)

    return TEXT.format(
        name=one(r'^name = "(.+)"'),
        maintainers="\n".join(f"  - {account}" for account in maintainers),
        license=one(r'^license = "(.+)"'),
        address=address,
        python=one(r'^requires-python = "(.+)"'),
        status=one(r'"Development Status :: \d - (.+)"'),
        mdanalysis=one(r'"MDAnalysis(>=[\d.]+)", "scipy'),
    )
