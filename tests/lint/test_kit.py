# SPDX-License-Identifier: MIT
"""metadata.yaml, which registers Pliant as a kit for MDAnalysis, agrees with pyproject.toml."""

import re

import pytest
from sources import ROOT

#: what the registry of MDAKits requires, and what it asks for besides
REQUIRED = {
    *("project_name", "authors", "maintainers", "description", "keywords", "license"),
    *("project_home", "documentation_home", "documentation_type"),
}
OPTIONAL = {
    *("install", "src_install", "import_name", "python_requires", "mdanalysis_requires"),
    *("run_tests", "test_dependencies", "project_org", "development_status", "publications"),
    *("community_home", "changelog"),
}
LISTS = {"authors", "maintainers", "keywords", "install", "src_install", "run_tests"}

yaml = pytest.importorskip("yaml", reason="PyYAML is not installed")


@pytest.fixture(scope="module")
def kit():
    return yaml.safe_load((ROOT / "metadata.yaml").read_text())


@pytest.fixture(scope="module")
def project():
    return (ROOT / "pyproject.toml").read_text()


def one(pattern, text):
    (found,) = re.findall(pattern, text, re.MULTILINE)
    return found


def test_every_required_entry_is_there_and_no_unknown_one(kit):
    assert REQUIRED <= set(kit) <= REQUIRED | OPTIONAL
    assert all(kit.values())
    assert {key for key, value in kit.items() if isinstance(value, list)} >= LISTS


def test_it_says_what_the_package_says(kit, project):
    assert kit["project_name"] == kit["import_name"] == one(r'^name = "(.+)"', project)
    assert kit["python_requires"] == one(r'^requires-python = "(.+)"', project)
    assert kit["mdanalysis_requires"] == one(r'"MDAnalysis(>=[\d.]+)", "scipy', project)
    assert kit["license"] == one(r'^license = {text = "(.+)"}', project)


def test_addresses_are_those_of_the_one_setting(kit, project):
    address = one(r'^repository = "(.+)"', project)
    assert kit["project_home"] == address
    named = [str(kit[key]) for key in ("documentation_home", "changelog", "src_install")]
    for text in named:
        assert address in text
        path = text.partition("/blob/HEAD/")[2]
        assert not path or (ROOT / path).is_file()


def test_its_tests_are_in_the_package(kit):
    assert kit["run_tests"] == ["pytest --pyargs pliant"]
    assert list((ROOT / "python/pliant/tests").glob("test_*.py"))
