# SPDX-License-Identifier: MIT
"""A run of a command counts while what it reads is the same."""

from pathlib import Path

import checks
import pytest
from small_project import commit

ROOT = Path(__file__).parents[3]


def note(project, name, text):
    """Writes what ./dev writes once a command has passed."""
    folder = project.root / checks.DONE
    folder.mkdir(parents=True)
    (folder / name).write_text(text)


def test_a_run_counts_for_the_commit_it_was_made_with(small):
    note(small, "test--all", small.commit() + "\n")
    assert checks.done(small, "test", "test--all") == "test--all"
    assert checks.tests(small).passed
    commit(small.root)
    assert checks.done(small, "test", "test--all") == "test--all"  # nothing has changed
    (small.root / "docs" / "page.md").write_text("another word")
    commit(small.root)
    assert checks.done(small, "test", "test--all") == ""


def test_a_run_counts_while_what_it_reads_is_the_same(small):
    first = small.commit()
    note(small, "wheel--all", first + "\n")
    (small.root / "docs" / "page.md").write_text("another word")
    commit(small.root)
    said = checks._made_by(small, "wheel--all")
    assert said.passed
    assert said.text == f"./dev wheel --all passed with {first[:12]}, and what it reads is the same"
    (small.root / "CHANGELOG.md").write_text("")
    commit(small.root)
    assert checks.done(small, "wheel--all") == ""


@pytest.mark.parametrize("noted", ["", "no commit\n", "0" * 40 + "\n"])
def test_a_note_that_names_no_commit_counts_for_nothing(small, noted):
    note(small, "test", noted)
    assert checks.done(small, "test") == ""


def test_what_a_command_does_not_read_is_there():
    for name in (name for names in checks.UNREAD.values() for name in names):
        assert (ROOT / name).exists(), name
