# SPDX-License-Identifier: MIT
"""What the pages of docs/ say that commands and code print is what they print."""

import pytest
import transcripts

ALL = sorted(transcripts.PAGES.rglob("*.md"))
WITH_CODE = [page for page in ALL if list(transcripts.blocks(page.read_text()))]


def check_console(block, folder):
    for command, expected in transcripts.commands(block.code):
        printed = transcripts.run_command(command, folder)
        assert transcripts.matches(printed, expected), f"$ {command}{printed}"


def check_python(block, names):
    printed = transcripts.run_python(block.code, names)
    assert block.printed is None or transcripts.matches(printed, block.printed), printed


@pytest.mark.parametrize("page", WITH_CODE, ids=lambda page: page.stem)
def test_code_prints_what_the_page_says(page, tmp_path, monkeypatch):
    transcripts.fill(tmp_path)
    text = page.read_text()
    if "1ubi.pdb" in text and not (tmp_path / "1ubi.pdb").exists():
        pytest.skip("ubiquitin is not there: ./dev demo fetches it")
    monkeypatch.chdir(tmp_path)
    names = {}
    for block in transcripts.blocks(text):
        if block.runs and block.kind == "console":
            check_console(block, tmp_path)
        elif block.runs:
            check_python(block, names)


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
"""


def test_blocks_are_found_with_their_marks():
    python, console = transcripts.blocks(PAGE)
    assert (python.kind, python.code, python.printed) == ("python", "print(1)\n", "1\n")
    assert (console.mark, console.line) == ("long", 11)
    assert list(transcripts.commands(console.code)) == [("ls \\\n  -a\n", "b\n")]
