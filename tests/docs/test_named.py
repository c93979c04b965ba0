# SPDX-License-Identifier: MIT
"""Commands and options that pages name are there; figures of the comparison are those measured."""

import re

import help_texts
import pytest
import transcripts

ROOT = transcripts.ROOT
SPAN = re.compile(r"`([^`\n]+)`")
COMMAND = re.compile(r"(?:^|[\s/(])pliant ([a-z]+)((?:\s+[a-z-]+)?)(.*)")
OPTION = re.compile(r"(?<![\w-])--[a-z][a-z0-9-]*")
#: commands that hand options they do not know to others
HANDS_ON = {
    "ensemble": ("run", "sample"),
    "sample": ("conformers",),
    "study": ("sample", "analyse"),
}
#: of all commands
GENERAL = {"--help", "--help-all", "--version", "--completion", "--json", "--verbose", "--quiet"}


def texts_of(command):
    """All help texts of a command and of what it is made of."""
    paths = help_texts.TEXTS.glob(f"pliant-{command}*.help.txt")
    return "".join(
        path.read_text() for path in paths if re.match(rf"pliant-{command}(-|\.)", path.name)
    )


def options_of(command):
    """Options that a command takes."""
    names = (command, *HANDS_ON.get(command, ()))
    return GENERAL.union(*(OPTION.findall(texts_of(name)) for name in names))


COMMANDS = {
    path.name.removeprefix("pliant-").split(".")[0].split("-")[0]
    for path in help_texts.TEXTS.glob("pliant-*.help.txt")
}


def named(text):
    """Commands of pliant that a page names, in code or between backquotes: (name, the rest)."""
    blocks = [one for one in transcripts.blocks(text) if one.kind in ("console", "sh")]
    lines = [line for one in blocks for line in re.sub(r"\\\n", " ", one.code).splitlines()]
    for line in [*lines, *SPAN.findall(text)]:
        for part in re.split(r"[|;&]+ ", line.split("  #")[0]):
            if found := COMMAND.search(" " + part.removeprefix("$ ").strip()):
                yield found[1], found[2] + found[3]


@pytest.mark.parametrize("page", transcripts.pages(), ids=lambda page: page.stem)
def test_commands_and_options_are_there(page):
    for command, rest in named(page.read_text()):
        assert command in COMMANDS, f"pliant {command}{rest}"
        unknown = set(OPTION.findall(rest)) - options_of(command)
        assert not unknown, f"pliant {command}{rest}"


def test_what_is_no_command_is_found():
    assert "sample" in COMMANDS
    assert "--amplitude" in options_of("sample")
    assert "--no-such" not in options_of("sample")
    assert list(named("`pliant sample x --no-such`")) == [("sample", " x --no-such")]


def test_figures_of_the_comparison_stand_where_they_were_measured():
    page = transcripts.PAGES / "comparison.md"
    part = page.read_text().split("\n## Measured\n")[1].split("\n## ")[0]
    linked = {name.split("#")[0] for name in re.findall(r"\]\(([^)]+)\)", part)}
    sources = "".join((page.parent / name).resolve().read_text() for name in linked)
    rows = [line for line in part.splitlines() if line.startswith("| ")]
    figures = {
        word
        for row in rows
        for cell in row.split("|")[2:]
        for word in re.findall(r"\d[\d.]*(?:e-\d+)?", cell)
    }
    assert len(figures) >= 35
    assert sorted(word for word in figures if word not in sources) == []
