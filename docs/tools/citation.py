# SPDX-License-Identifier: MIT
"""How to cite Pliant, as CITATION.cff has it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import yaml

FILE = Path(__file__).resolve().parents[2] / "CITATION.cff"
PLACE = "<!-- the citation -->"  #: in a page: where it goes


def facts() -> dict[str, Any]:
    """What the file says."""
    found: dict[str, Any] = yaml.safe_load(FILE.read_text(encoding="utf-8"))
    return found


def version() -> str:
    """Of this Pliant."""
    return str(facts()["version"])


def with_citation(markdown: str) -> str:
    """A page with the citation in its place, as text and for BibTeX."""
    return markdown.replace(PLACE, _shown(facts())) if PLACE in markdown else markdown


def _shown(cited: dict[str, Any]) -> str:
    authors = " and ".join(_name(author) for author in cited["authors"])
    year = str(cited.get("date-released", ""))[:4]
    address = str(cited.get("repository-code", cited.get("url", "")))
    dated = f"{authors} ({year})" if year else authors
    text = f"{dated}. *{cited['title']}*, version {cited['version']}. {address}".rstrip()
    fields = {
        "author": "{" + authors + "}",
        "title": "{" + cited["title"] + "}",
        "version": str(cited["version"]),
        "year": year,
        "url": address,
    }
    rows = [f"  {name:7} = {{{value}}}," for name, value in fields.items() if value]
    entry = "\n".join([f"@software{{pliant_{cited['version']},", *rows, "}"])
    return f"> {text}\n\n```bibtex\n{entry}\n```"


def _name(author: dict[str, str]) -> str:
    """Of a person or of a group."""
    return author.get("name") or f"{author['family-names']}, {author['given-names']}"
