# SPDX-License-Identifier: MIT
"""The page on methods, src/pliant/resolve/README.md, speaks of every technique there is."""

import re
from pathlib import Path

import pytest

import pliant

PAGE = (Path(__file__).parents[3] / "src" / "pliant" / "resolve" / "README.md").read_text()
NAMES = [row.name for row in pliant.techniques()]
ORDERINGS = [row.name for row in pliant.orderings()]
HEADINGS = ("technique | exact in one pass for", "technique | first sweep")


def sections():
    """Headings of second rank with what stands below them."""
    parts = re.split(r"^## (.*)$", PAGE, flags=re.MULTILINE)
    return dict(zip(parts[1::2], parts[2::2], strict=True))


def first_cells(text, heading):
    """What the first cells of the table with this heading name as code, row by row."""
    rows = text[text.index(f"| {heading}") :].split("\n\n")[0].splitlines()[2:]
    cells = [row.split("|")[1] for row in rows]
    return [name for cell in cells for name in re.findall(r"`(\w+)`", cell)]


def section_of(name):
    """The heading of the section that explains a technique."""
    named = [heading for heading in sections() if f"`{name}`" in heading]
    return named or (["Orderings"] if name in ORDERINGS else [])


def test_the_first_table_has_the_techniques_in_their_order():
    assert first_cells(PAGE, HEADINGS[0]) == NAMES


def test_the_table_of_orderings_has_all_of_them():
    assert first_cells(sections()["Orderings"], HEADINGS[1]) == ORDERINGS


@pytest.mark.parametrize("name", NAMES)
def test_every_technique_has_one_section(name):
    assert len(section_of(name)) == 1


@pytest.mark.parametrize("heading", sorted({section_of(n)[0] for n in NAMES if section_of(n)}))
def test_sections_say_what_all_must(heading):
    text = sections()[heading]
    assert re.search(r"`\w+(?:/\w+)+\.hpp`", text), "no header"
    if heading == "`auto`":
        return
    for part in ("**Cost.**", "**Exact", "here it cannot", "**Code.**"):
        assert part in text, part


def test_sections_are_of_techniques_that_are():
    named = {name for heading in sections() for name in re.findall(r"`(\w+)`", heading)}
    assert named <= set(NAMES)


def test_what_auto_may_take_is_in_its_table():
    taken = {"blocks", "newton", "anderson", "units", "froda"}
    rows = [row for row in sections()["`auto`"].splitlines() if row.startswith("| ")][1:]
    assert {re.findall(r"`(\w+)`", row.split("|")[2])[0] for row in rows} == taken
    summary = next(row.summary for row in pliant.techniques() if row.name == "auto")
    assert all(name in summary for name in taken)


def test_references_are_cited_and_citations_listed():
    cited = set(re.findall(r"\[([A-Z][a-z]+ \d{4})\](?![(:])", PAGE))
    listed = re.findall(r"^- \*\*([A-Z][a-z]+ \d{4})\*\*: ", sections()["References"], re.MULTILINE)
    assert listed == sorted(set(listed))
    assert cited == set(listed)
