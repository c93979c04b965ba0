# SPDX-License-Identifier: MIT
"""./dev release --quick of these files passes, and each of its checks can fail."""

import hashlib
from pathlib import Path

import changelog
import checks
import product
import pytest
import recipes
import versions
from project import Project
from small_project import SECTION

yaml = pytest.importorskip("yaml", reason="PyYAML is not installed")

ROOT = Path(__file__).parents[3]
THESE = Project(ROOT)
ADDRESS = "https://git.invalid/someone/pliant"

is_clone = pytest.mark.skipif(not THESE.files(), reason="this is no clone: git lists no files")


def put(project, name, old, new):
    """Replaces a text in a file of the project."""
    path = project.root / name
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new))


# One works on these files, so that the tree is not clean, and the next version may have no day.
# What is promised and the lints have tests of their own.
LATER = (checks.tree, checks.version, checks.promises, checks.lints)
OF_EVERY_CHANGE = [c for c in checks.QUICK if c.look not in LATER]


@is_clone
@pytest.mark.parametrize("check", OF_EVERY_CHANGE, ids=lambda check: check.name)
def test_these_files_pass(check):
    result = check.look(THESE)
    assert result.passed, result


def test_these_files_have_one_version():
    assert versions.differences(THESE) == []


def test_what_is_not_released_has_no_day_and_does_not_pass(small):
    put(small, "CHANGELOG.md", "(2027-01-02)", "(not released)")
    put(small, "CITATION.cff", "date-released: 2027-01-02\n", "")
    assert versions.differences(small) == []
    assert "--prepare" in checks.version(small).details[0]
    versions.write(small, "1.2.3", "2027-03-04")
    assert "date-released: 2027-03-04" in small.text("CITATION.cff")
    assert checks.version(small).passed


def test_a_small_project_passes(small):
    looked = [checks.tree, checks.version, checks.changes, checks.promises]
    assert [look(small) for look in looked if not look(small).passed] == []


@pytest.mark.parametrize(
    ("name", "old", "new", "said"),
    [
        ("CITATION.cff", "1.2.3", "1.2.4", "CITATION.cff: version 1.2.4"),
        ("CHANGELOG.md", "## 1.2.3", "## 1.2.2", "CHANGELOG.md: version 1.2.2"),
        ("CITATION.cff", "2027-01-02", "2027-01-03", "CITATION.cff: date 2027-01-03"),
        ("CHANGELOG.md", "(2027-01-02)", "(soon)", "is no date"),
        ("CHANGELOG.md", "(2027-01-02)", "(not released)", "CHANGELOG.md has none"),
        ("CITATION.cff", "date-released", "date", "date is missing"),
    ],
)
def test_a_version_or_day_that_differs_is_found(small, name, old, new, said):
    put(small, name, old, new)
    found = versions.differences(small)
    assert any(said in line for line in found), found
    assert not checks.version(small).passed


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("- A thing.", "- A thing\n  that goes on.", "more than one line"),
        ("- A thing.", "- A thing", "no full stop"),
        ("- A thing.", "- " + "a" * 300 + ".", "characters, at most"),
        ("- A thing.\n", "", "nothing under Added"),
        ("### Added", "### Wonders", "must be of"),
        ("### Added", "### Removed\n\n- A name.\n\n### Added", "in this order"),
    ],
)
def test_a_change_that_is_not_one_line_is_found(old, new, said):
    lines = SECTION.replace(old, new).splitlines()
    assert any(said in line for line in changelog.problems(lines)), changelog.problems(lines)


def test_a_section_ends_where_the_next_begins():
    text = "# C\n## 1.2.0 (a)\n- one.\n## 1.2 (b)\n- two.\n"
    assert changelog.section(text, "1.2.0") == ["- one."]
    assert changelog.section(text, "1.2") == ["- two."]
    assert changelog.section(text, "1") == []
    assert changelog.problems([]) == ["no changes"]


def test_notes_have_no_links_of_the_repository():
    text = changelog.notes(SECTION.splitlines(), "Pliant 1.2.3")
    assert text.startswith("Pliant 1.2.3\n\nWhat it is.\n\n## Added\n\n- A thing.")
    assert "- A fault.\n" in text


def test_a_tree_with_changes_is_found(small):
    (small.root / "new.txt").write_text("")
    assert checks.tree(small).details == ["new.txt: not in the commit"]


def test_a_new_version_is_written_everywhere(small):
    versions.write(small, "1.3.0", "2027-03-04")
    assert versions.differences(small) == []
    assert small.version() == "1.3.0"
    assert "## 1.2.3 (2027-01-02)" in small.text("CHANGELOG.md")
    versions.write(small, "1.3.0", "2027-03-05")
    assert small.text("CHANGELOG.md").count("## 1.3.0 (2027-03-05)") == 1


@pytest.mark.parametrize(
    ("command", "commit", "said"),
    [
        ("test", "this", "./dev test passed with this commit"),
        ("test --all", "this", "./dev test --all passed with this commit"),
        ("test", "0" * 40, "./dev test failed"),
        ("docs", "this", "./dev test failed"),
    ],
)
def test_a_run_counts_for_the_commit_it_was_made_with(small, command, commit, said):
    dev, note = small.root / "dev", small.root / checks.DONE / command.replace(" ", "")
    dev.write_text("#!/bin/sh\nexit 1\n")
    dev.chmod(0o755)
    note.parent.mkdir(parents=True)
    note.write_text((small.commit() if commit == "this" else commit) + "\n")
    assert checks.tests(small).text == said


def made(project):
    """Wheels of all systems but one, and an archive, all of them empty."""
    for folder in (product.WHEELS, product.SOURCES):
        (project.root / folder).mkdir(parents=True)
    platforms = "manylinux_2_28_x86_64", "manylinux_2_28_aarch64", "macosx_11_0_arm64", "win_amd64"
    for python in product.PYTHONS:
        for platform in platforms:
            (project.root / product.WHEELS / f"pliant-1.2.3-{python}-{platform}.whl").touch()
    product.sources(project).write_text("sources")


def test_a_wheel_that_is_missing_is_named(small):
    made(small)
    (small.root / "python/wheel").mkdir(parents=True)
    (small.root / product.TARGETS).write_text(THESE.text(product.TARGETS))
    assert product.missing_wheels(small) == [f"macos-x86_64, {p}" for p in product.PYTHONS]


def test_the_folder_has_sums_notes_and_recipe(small, tmp_path):
    made(small)
    (small.root / product.WHEELS / "pliant-1.2.2-cp312-abi3-win_amd64.whl").touch()  # an old one
    folder = tmp_path / "made"
    names = {path.name for path in product.make(small, folder)}
    assert {"SHA256SUMS", "RELEASE_NOTES.md", "recipe.yaml", "pliant-1.2.3.tar.gz"} <= names
    assert "metadata.yaml" not in names  # without an address it would say nothing
    rows = dict(reversed(r.split("  ")) for r in (folder / "SHA256SUMS").read_text().splitlines())
    assert len(rows) == 13
    assert rows["pliant-1.2.3.tar.gz"] == hashlib.sha256(b"sources").hexdigest()
    assert rows["pliant-1.2.3.tar.gz"] in (folder / "recipe.yaml").read_text()


# --- the registry of MDAKits ---------------------------------------------------------------------


def test_the_registry_gets_every_entry_filled(small):
    urls = f'[project.urls]\nSource = "{ADDRESS}/"\n\n[project.scripts]'
    settings = THESE.text("pyproject.toml").replace("[project.scripts]", urls)
    settings = settings.replace("maintainers = []", 'maintainers = ["one", "two"]')
    (small.root / "pyproject.toml").write_text(settings)
    assert recipes.missing(small) == []
    text = recipes.mdakit(small)
    assert "@" not in text.replace("@ git+", "")
    kit = yaml.safe_load(text)
    assert all(kit.values())
    assert kit["maintainers"] == ["one", "two"]
    assert kit["project_home"] == ADDRESS
    for key in ("documentation_home", "changelog"):
        assert (ROOT / kit[key].removeprefix(f"{ADDRESS}/blob/HEAD/")).is_file()


def test_without_an_address_it_is_said_what_the_registry_misses(small):
    assert recipes.missing(small) == ["Source of [project.urls]", "maintainers of [tool.pliant]"]


# --- conda ---------------------------------------------------------------------------------------


def test_the_recipe_needs_what_pyproject_needs():
    recipe = yaml.safe_load(recipes.conda(THESE, "0" * 64))
    assert recipe["context"]["version"] == THESE.version()
    assert recipe["source"]["sha256"] == "0" * 64
    text = THESE.text("pyproject.toml")
    needed = recipe["requirements"]["run"] + recipe["requirements"]["host"]
    for name in ("numpy", "h5py", "scikit-build-core", "nanobind"):
        (found,) = [one for one in needed if one.split(" ")[0] == name]
        assert f'"{found.replace(" ", "")}"' in text, found
    assert "@" not in recipes.conda(THESE, "0" * 64)


@pytest.mark.long
@pytest.mark.parametrize("platform", ["linux-64", "linux-aarch64", "osx-64", "osx-arm64"])
def test_rattler_build_reads_the_recipe_and_renders_it_for_each_python(platform):
    rattler_build = pytest.importorskip("rattler_build", reason="./dev test --all installs it")
    recipe = rattler_build.Stage0Recipe.from_yaml(recipes.conda(THESE, "0" * 64))
    pythons = ["3.10", "3.11", "3.12", "3.13"]
    compilers = {"c_compiler": ["gcc"], "cxx_compiler": ["gxx"], "c_stdlib": ["sysroot"]}
    variants = rattler_build.VariantConfig({"python": pythons} | compilers)
    target = rattler_build.PlatformConfig(target_platform=platform)
    rendered = recipe.render(variants, rattler_build.RenderConfig(platform=target))
    assert len(rendered) == len(pythons)
