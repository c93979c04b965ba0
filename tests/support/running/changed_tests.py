# SPDX-License-Identifier: MIT
"""The tests that are near to a change, as far as the time goes: changed_tests.py [COMMIT].

Says on standard error what it chose. Prints a regular expression for the names of C++ tests, then a
file of pytest a line. It chooses by names, includes, imports and folders, not by what really runs:
./dev test decides.
"""

import re
import subprocess
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path, PurePosixPath

from recorded_seconds import estimates

ROOT = Path(__file__).resolve().parents[3]

#: CPU seconds for the tests: with building, 90 s on two cores
BUDGET = 60.0

#: how near a test is to a change
ITSELF, NAMED, USES, FOLDER, AREA, AFAR = range(6)

#: they look at every file, and always run
ALWAYS = "tests/lint"

#: folders of tests that are named otherwise than what they test
AREAS = {"analyse": "analysis", "adapters": "molecule", "imd": "run"}

_CPP_TEST = re.compile(
    r"^(?:TYPED_)?(?:RC_GTEST_(?:FIXTURE_)?PROP|TEST(?:_[FP])?)\((\w+),", re.MULTILINE
)


def is_test(path: PurePosixPath) -> bool:
    """Whether a file has tests of gtest or pytest."""
    return path.parts[0] == "tests" and bool(re.fullmatch(r"test_\w+\.py|\w+_test\.cpp", path.name))


def subject(path: PurePosixPath) -> str:
    """What a file is about, by its name: test_sample.py, cmd_sample.cpp and sample.hpp agree."""
    return re.sub(r"^(test_|cmd_|bind_|_)|_test$", "", path.stem)


def wing(path: PurePosixPath) -> tuple[str, ...]:
    """The folders below tests/KIND, src/pliant, python/pliant and python/bind."""
    folders = path.parts[2:-1]
    return tuple(AREAS.get(folder, folder) for folder in folders)


def mention(path: PurePosixPath) -> str:
    """A regular expression for what is in the text of a file that uses this one."""
    if path.suffix in (".cpp", ".hpp"):
        place = path.relative_to(path.parts[0]).with_suffix(".hpp")
        return f'#include "{re.escape(str(place))}"'
    if path.suffix == ".py":
        module = path.parent if path.name == "__init__.py" else path.with_suffix("")
        names = module.parts[1:] if path.parts[0] == "python" else [module.name]
        package = r"\.".join(names[:-1]) or "-"
        whole = r"\.".join(names)
        return rf"(from|import) {whole}\b|from {package} import .*\b{names[-1]}\b"
    return rf"\b{re.escape(path.name)}\b"


def mention_of_folder(path: PurePosixPath) -> str:
    """Likewise, for a file that uses others of the folder."""
    folders = path.parts[1:3]
    if path.parts[0] == "src":
        return f'#include "{"/".join(folders)}/'
    if path.parts[0] == "python" and path.suffix == ".py" and len(path.parts) > 3:
        return rf"(from|import) {'.'.join(map(re.escape, folders))}\b"
    return "(?!)"


def area_of_tests(path: PurePosixPath) -> str:
    """The folder of tests for what has none of its name."""
    if path.parts[0] == "apps":
        return "tests/python/play" if "play" in path.parts else "tests/cli"
    if path.parts[0] == "docs" or path.suffix == ".md":
        return "tests/docs"
    return path.parent.as_posix() if path.parts[0] == "tests" else "-"


def is_code(path: PurePosixPath) -> bool:
    return path.parts[:2] in {("src", "pliant"), ("python", "pliant"), ("python", "bind")}


def rules(test: PurePosixPath, text: str, changed: PurePosixPath) -> Iterator[tuple[int, object]]:
    """How near a test is to a changed file, and whether it is, nearest first."""
    code = is_code(changed) and wing(changed)
    yield ITSELF, test == changed
    if is_test(changed):
        return
    named = is_code(changed) or changed.parts[0] == "apps"
    yield NAMED, named and subject(test) == subject(changed)
    yield USES, re.search(mention(changed), text)
    yield FOLDER, code and wing(test) == code
    yield AREA, code and wing(test)[:1] == code[:1]
    yield AREA, f"{test}".startswith(f"{area_of_tests(changed)}/")
    yield AFAR, re.search(mention_of_folder(changed), text)


def nearness(test: PurePosixPath, text: str, changed: PurePosixPath) -> int | None:
    """How near a test is to a changed file; None if nothing connects them."""
    return next((rank for rank, holds in rules(test, text, changed) if holds), None)


def candidates(
    tests: dict[PurePosixPath, str], changed: Iterable[PurePosixPath]
) -> dict[PurePosixPath, int]:
    """The tests that are near any of the changed files, with how near."""
    found = {}
    for path in changed:
        for test, text in tests.items():
            rank = nearness(test, text, path)
            if rank is not None:
                found[test] = min(rank, found.get(test, rank))
    return found


def choose(
    near: dict[PurePosixPath, int], seconds: dict[PurePosixPath, float], budget: float = BUDGET
) -> list[PurePosixPath]:
    """The nearest that fit into the seconds, cheap ones first; those that changed always."""
    chosen, spent = [], 0.0
    for test in sorted(near, key=lambda test: (near[test], seconds[test], test)):
        if near[test] == ITSELF or spent + seconds[test] <= budget:
            chosen.append(test)
            spent += seconds[test]
    return chosen


def suites(text: str) -> set[str]:
    """Of the tests in a C++ file."""
    return set(_CPP_TEST.findall(text))


def lines_of(*command: str) -> list[str]:
    return subprocess.run(
        command, cwd=ROOT, text=True, capture_output=True, check=True
    ).stdout.splitlines()


def changed_files(commit: str | None) -> list[PurePosixPath]:
    """Since the last commit, or since a branch parted from another one; files that are new, too."""
    base = lines_of("git", "merge-base", "HEAD", commit)[0] if commit else "HEAD"
    new = lines_of("git", "ls-files", "--others", "--exclude-standard")
    return [PurePosixPath(name) for name in {*lines_of("git", "diff", "--name-only", base), *new}]


def all_tests() -> dict[PurePosixPath, str]:
    """The text of every file of tests, but for those that always run."""
    names = lines_of("git", "ls-files", "--cached", "--others", "--exclude-standard", "tests")
    paths = [PurePosixPath(name) for name in names]
    return {
        path: (ROOT / path).read_text()
        for path in paths
        if is_test(path) and (ROOT / path).exists() and not f"{path}".startswith(f"{ALWAYS}/")
    }


def main(commit: str | None = None) -> int:
    """Says and prints what is chosen."""
    tests, changed = all_tests(), changed_files(commit)
    near = candidates(tests, changed)
    seconds = estimates(tests)
    chosen = choose(near, seconds)
    spent = sum(seconds[test] for test in chosen)
    say = [f"{len(changed)} files changed since {commit or 'the last commit'}: {ALWAYS} and"]
    say += [f"  {test}" for test in chosen] or ["  no other test is near them"]
    left = f"{len(near) - len(chosen)} files of tests that are further away or too long"
    say += [f"about {spent:.0f} CPU seconds; {left}, and all others, are left to ./dev test"]
    print(*say, sep="\n", file=sys.stderr)
    names = set().union(*(suites(tests[test]) for test in chosen if test.suffix == ".cpp"))
    print(f"(^|/)({'|'.join(sorted(names))})\\." if names else "^$")
    print(ALWAYS, *(test for test in chosen if test.suffix == ".py"), sep="\n")
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
