# SPDX-License-Identifier: MIT
"""GitHub's workflows and the Dockerfile install what ./dev installs, and hang together."""

import re

import pytest
from sources import ROOT

yaml = pytest.importorskip("yaml", reason="PyYAML is not installed")
WORKFLOWS = sorted((ROOT / ".github" / "workflows").glob("*.yml"))


def packages_of_dev():
    text = (ROOT / "dev").read_text()
    return set(re.search(r"debian_build=\(([^)]+)\)", text)[1].split())


def test_debian_packages_are_those_of_dev():
    of_a_build = packages_of_dev() - {"ccache", "g++", "cmake", "ninja-build"}
    for path in (ROOT / "Dockerfile", ROOT / ".github/workflows/tests.yml"):
        assert of_a_build <= set(path.read_text().split()), path


@pytest.mark.parametrize("path", WORKFLOWS, ids=lambda path: path.stem)
def test_jobs_have_rights_and_limits(path):
    flow = yaml.safe_load(path.read_text())
    assert flow["permissions"] == {"contents": "read"}
    for name, job in flow["jobs"].items():
        assert name == "publish" or job["timeout-minutes"] <= 120
        assert set(job.get("needs", [])) <= set(flow["jobs"])
    commands = re.findall(r"\./dev (\w+)", path.read_text())
    known = re.search(r"^    ([\w |]+)\) \"\$command\"", (ROOT / "dev").read_text(), re.MULTILINE)
    assert set(commands) <= {*known[1].split(" | "), "test"}


def test_what_is_published_is_made_by_every_job():
    flow = yaml.safe_load((ROOT / ".github/workflows/wheels.yml").read_text())
    assert set(flow["jobs"]["publish"]["needs"]) == set(flow["jobs"]) - {"publish"}
    assert flow["jobs"]["publish"]["permissions"] == {"id-token": "write"}
