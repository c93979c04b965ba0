# SPDX-License-Identifier: MIT
"""Makes of a table of sections what is printed, and the values of --json."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Any, Generic

from pliant.base.console import Table
from pliant.base.verdict import Verdict
from pliant.report.section import Fact, Found, Line, Picture, Section, Values

WIDTH = 16  #: letters of a label on the terminal


class Report(Generic[Found]):
    """What was found, as a table of sections shows it."""

    def __init__(self, found: Found, sections: Iterable[Section[Found]]) -> None:
        self.found, self.table = found, tuple(sections)
        self.sections = [row for row in self.table if row.applies(found)]

    @property
    def verdicts(self) -> dict[str, Verdict]:
        """The answers by the names of their sections, in the order of the table."""
        answers = {row.name: row.verdict(self.found) for row in self.table}
        return {name: answer for name, answer in answers.items() if answer is not None}

    @property
    def values(self) -> Values:
        """What was found, JSON-ready."""
        all_of_them: dict[str, Any] = {}
        for row in self.sections:
            values = row.values(self.found)
            if twice := all_of_them.keys() & values.keys():
                raise ValueError(f"two sections have a value {min(twice)!r}")
            all_of_them.update(values)
        return all_of_them

    def lines(self) -> Iterator[Line]:
        """For the terminal: see `print_lines`."""
        for row in self.sections:
            yield from row.lines(self.found)

    def labelled(self) -> list[tuple[str, str]]:
        """Those of the lines that have a label."""
        return [line for line in self.lines() if isinstance(line, tuple)]

    def facts(self, headings: Sequence[str]) -> list[Fact]:
        """In the order of the headings that they stand under."""
        under = ((row for row in self.sections if row.heading == one) for one in headings)
        return [fact for rows in under for row in rows for fact in row.facts(self.found)]

    @property
    def methods(self) -> dict[str, str]:
        """How all was measured that can be, found or not."""
        return {what: text for row in self.table for what, text in row.methods.items()}

    @property
    def pictures(self) -> list[Picture[Found]]:
        """Those that can be drawn."""
        every = (picture for row in self.sections for picture in row.pictures)
        return [picture for picture in every if picture.suits(self.found)]


def print_lines(lines: Iterable[Line], width: int = WIDTH) -> None:
    """Prints lines as they are, (label, text) in two columns, and tables."""
    for line in lines:
        if isinstance(line, Table):
            line.print()
        else:
            print(line if isinstance(line, str) else f"{line[0]:<{width}}{line[1]}")
