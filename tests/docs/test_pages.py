# SPDX-License-Identifier: MIT
"""Every block of code of every page is run, compiled or read, and prints what the page says."""

import contextlib
import re
from importlib.util import find_spec

import make_pictures
import pytest
import transcripts
from pliant.checks.ligands import ambertools

from pliant import InputError

ALL = transcripts.pages()
#: what is shown and no code: figures of characters, what is printed, rows of a file
SHOWN = ("", "text", "bibtex")
#: tests/docs/test_compiled.py takes these
COMPILED = ("cpp", "cmake", "yaml")


def name(page):
    """Which page, in names of tests."""
    return page.relative_to(transcripts.ROOT).as_posix()


def found(page, *kinds):
    """Blocks of these kinds of a page, or all."""
    there = transcripts.blocks(page.read_text())
    return [block for block in there if not kinds or block.kind in kinds]


def place(page, block):
    """Where a block is."""
    return f"{name(page)}:{block.line}"


#: a test of its own runs the gallery
WITH_CODE = [page for page in ALL if found(page, *transcripts.RUN) and page.stem != "gallery"]


def test_every_block_is_run_or_says_why_not():
    kinds = (*transcripts.RUN, *COMPILED, *SHOWN)
    for page in ALL:
        blocks = found(page)
        fences = len(re.findall("^ *```", page.read_text(), re.MULTILINE))
        assert fences == sum(2 if one.printed is None else 4 for one in blocks), name(page)
        for block in blocks:
            assert block.kind in kinds, f"{place(page, block)}: nothing runs {block.kind}"
            assert (block.mark == "not run") == bool(block.why), f"{place(page, block)}: why?"


def test_few_blocks_are_not_run():
    run = [block for page in WITH_CODE for block in found(page, *transcripts.RUN)]
    assert len([block for block in run if block.mark == "not run"]) <= len(run) / 4


def check_console(block, folder):
    for command, expected in transcripts.commands(block.code):
        printed = transcripts.run_command(command, folder)
        assert transcripts.matches(printed, expected), f"$ {command}{printed}"


def check_python(block, names):
    printed = transcripts.run_python(block.code, names)
    assert block.printed is None or transcripts.matches(printed, block.printed), printed


def check_script(block, folder):
    status, printed = transcripts.run_script(block.code, folder)
    assert status == 0, printed


def has_ambertools():
    """And ParmEd, which a page on complexes needs, too."""
    with contextlib.suppress(InputError):
        return bool(ambertools.programs()) and bool(find_spec("parmed"))
    return False


@pytest.mark.timeout(3600)
@pytest.mark.parametrize("page", WITH_CODE, ids=name)
def test_code_prints_what_the_page_says(page, tmp_path, monkeypatch):
    transcripts.fill(tmp_path)
    blocks = [block for block in found(page, *transcripts.RUN) if block.runs]
    if blocks and page.stem == "complex" and not has_ambertools():
        pytest.skip("AmberTools or ParmEd is not there")
    asked = any(name in one.code for one in blocks for name in transcripts.UBIQUITIN)
    if asked and not (tmp_path / "1ubi.pdb").exists():
        pytest.skip("ubiquitin is not there: ./dev demo fetches it")
    monkeypatch.chdir(tmp_path)
    names = {}
    for block in blocks:
        if block.kind == "console":
            check_console(block, tmp_path)
        elif block.kind == "sh":
            check_script(block, tmp_path)
        else:
            check_python(block, names)


GALLERY = transcripts.PAGES / "gallery.md"


def test_every_picture_of_the_gallery_is_made_by_what_it_shows():
    made = {name: file for file, name in make_pictures.NAMES.items()}
    code = "".join(block.code for block in transcripts.blocks(GALLERY.read_text()))
    for name in re.findall(r"\]\(\.\./pictures/([^)]+)\)", GALLERY.read_text()):
        assert made.pop(name) in code, name
    assert made == {}


@pytest.mark.long
@pytest.mark.filterwarnings("ignore::pliant.PliantWarning")
def test_the_gallery_makes_its_pictures(tmp_path, monkeypatch):
    if not (transcripts.STRUCTURES / "pdb1ubi.pdb").exists():
        pytest.skip("ubiquitin is not there: ./dev demo fetches it")
    monkeypatch.setenv("MPLBACKEND", "Agg")
    make_pictures.make(tmp_path)
    for file, name in make_pictures.NAMES.items():
        picture = (tmp_path / file).read_bytes()
        assert picture[:8].lstrip().startswith((b"\x89PNG", b"<svg", b"<?xml")), file
        assert 3000 < len(picture) < 400_000, file
        assert 3000 < (transcripts.ROOT / "docs/pictures" / name).stat().st_size < 400_000, name


def test_dots_stand_for_anything():
    assert transcripts.matches("a 1.2 s\nb\n", "a ... s\nb\n")
    assert transcripts.matches("1\n2\n3\n4", "1\n...\n4")
    assert not transcripts.matches("1\n2\n3\n4", "1\n...\n5")
    assert not transcripts.matches("a.c", "a...b")


PAGE = """x
```python
print(1)
```

```text
1
```
<!-- long -->
```console
$ ls \\
  -a
b
```

1. x
   <!-- not run: no home -->
   ```sh
   ./dev test
   ```
"""


def test_blocks_are_found_with_their_marks():
    python, console, script = transcripts.blocks(PAGE)
    assert (python.kind, python.code, python.printed) == ("python", "print(1)\n", "1\n")
    assert (console.mark, console.line) == ("long", 11)
    assert list(transcripts.commands(console.code)) == [("ls \\\n  -a\n", "b\n")]
    assert (script.kind, script.why, script.code) == ("sh", "no home", "./dev test\n")
