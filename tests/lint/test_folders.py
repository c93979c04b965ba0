# SPDX-License-Identifier: MIT
"""No folder holds so many files that one cannot find one's way in it."""

from collections import Counter
from collections.abc import Iterable
from pathlib import PurePosixPath

from sources import FOLDERS, refuse, tracked

MOST_FILES = 30

# Files that are looked up by name, one for each case or page.
DATA = ("tests/corpus/", "tests/cli/help/")


def full_folders(names: Iterable[str]) -> list[str]:
    """One text for each folder of too many files."""
    count = Counter(PurePosixPath(name).parent.as_posix() for name in names)
    return [
        f"{folder}: {files} files, at most {MOST_FILES}: part it into wings"
        for folder, files in sorted(count.items())
        if files > MOST_FILES and not f"{folder}/".startswith(DATA)
    ]


def test_no_folder_is_too_full():
    refuse(full_folders(tracked(*FOLDERS)))


def test_a_folder_that_is_too_full_is_found():
    names = [f"src/a/{k}.cpp" for k in range(MOST_FILES)]
    assert full_folders(names) == []
    assert full_folders([*names, "src/a/b/c.cpp"]) == []
    assert full_folders([*names, "src/a/one_more.hpp"]) == [
        "src/a: 31 files, at most 30: part it into wings"
    ]
