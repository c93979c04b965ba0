# SPDX-License-Identifier: MIT
"""README is one page; pages list the commands, extras and names that are there."""

import re

from sources import CPP, ROOT, files

LONGEST_README = 120  # lines
HELP = ROOT / "tests" / "cli" / "help"
PAGE = ROOT / "docs" / "pages" / "commands.md"
CALLED_BY_OTHERS = {"rigidity-page"}  # scripts that a command of the table calls
NOT_FOR_USERS = {
    "test-all",
    "plot",
    "docs",
    "test",
}  # extras that others take in, or that ./dev installs


def groups_of_help():
    """{heading: its commands} of pliant --help."""
    text = (HELP / "pliant.help.txt").read_text()
    parts = re.findall(r"^([A-Z][\w ?]*)\n((?:  .*\n)+)", text, re.MULTILINE)
    return {title: re.findall(r"^  ([a-z]+)  ", rows, re.MULTILINE) for title, rows in parts}


def groups_of_page():
    """{heading: commands of its table} of the page of commands, each command once."""
    found = {}
    for part in PAGE.read_text().split("\n## ")[1:]:
        title, _, text = part.partition("\n")
        rows = re.findall(r"^\| `pliant ([a-z]+)", text, re.MULTILINE)
        if rows:
            found[title] = list(dict.fromkeys(rows))
    return found


def known_commands():
    """All of pliant --help."""
    return [name for names in groups_of_help().values() for name in names]


def laboratory():
    """All of pliant lab --help."""
    rows = (HELP / "pliant-lab.help.txt").read_text().split("subcommands:\n")[1].split("\n\n")[0]
    return re.findall(r"^  ([a-z]+)  ", rows, re.MULTILINE)


def table_of(name):
    """A table of pyproject.toml: its keys."""
    text = (ROOT / "pyproject.toml").read_text().split(f"\n[{name}]\n")[1].split("\n[")[0]
    return set(re.findall(r"^([\w-]+) = ", text, re.MULTILINE))


def test_readme_is_one_page():
    assert len((ROOT / "README.md").read_text().splitlines()) <= LONGEST_README


def test_help_and_page_list_the_same_commands_in_the_same_groups():
    assert len(groups_of_help()) >= 5
    assert list(groups_of_page().items()) == list(groups_of_help().items())


def test_every_program_is_a_command_and_every_command_a_program():
    declared = re.findall(r"int command_(\w+)\(", (ROOT / "apps" / "command.hpp").read_text())
    scripts = {re.sub("^pliant-(lab-)?", "", name) for name in table_of("project.scripts")}
    known = [*known_commands(), *laboratory()]
    assert sorted(known) == sorted({*declared, *scripts} - CALLED_BY_OTHERS)


def test_every_command_has_a_help_text():
    texts = {path.name for path in HELP.glob("*.help.txt")}
    names = [*known_commands(), *(f"lab-{name}" for name in laboratory())]
    assert {f"pliant-{name}.help.txt" for name in names} <= texts


def test_readme_names_commands_that_are_there():
    named = set(re.findall(r"`pliant ([a-z]+)\b", (ROOT / "README.md").read_text()))
    assert len(named) >= 8
    assert named <= set(known_commands())


def test_extras_of_the_page_are_those_of_the_package():
    page = (ROOT / "docs" / "pages" / "install.md").read_text()
    extras = re.findall(r'^\| `"pliant\[(\w+)\]"` ', page, re.MULTILINE)
    assert sorted(extras) == sorted(table_of("project.optional-dependencies") - NOT_FOR_USERS)


def test_names_of_the_glossary_are_in_the_code():
    page = (ROOT / "docs" / "pages" / "glossary.md").read_text()
    names = set(re.findall(r"`([A-Z]\w+[a-z])`", page))
    code = "\n".join(path.read_text() for path in files(*CPP, ".py", folders=("src", "python")))
    there = set(re.findall(r"\b(?:class|struct) (\w+)", code))
    there |= set(re.findall(r"\benum class (\w+)", code))
    assert len(names) >= 10
    assert sorted(names - there) == []
