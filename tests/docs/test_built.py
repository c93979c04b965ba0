# SPDX-License-Identifier: MIT
"""The site as it is built: no warning, every link leads somewhere, search knows every name."""

import html
import json
import re
from functools import cache
from html.parser import HTMLParser
from urllib.parse import unquote, urlsplit

import headers
import places
import pytest

import pliant

pytestmark = pytest.mark.long
FROM_NETWORK = re.compile(r"<(?:script|img|link|iframe)[^>]*(?:src|href)=\"(?:https?:)?//[^\"]*\"")
NAMES = {name for name in pliant.__all__ if not name.startswith("_")}
#: domains that are nobody's (RFC 2606, RFC 6761)
NOBODY = re.compile(r"(^|\.)(example|test|invalid|localhost|example\.(com|org|net))$")


class Links(HTMLParser):
    """What a page refers to, and what can be referred to in it."""

    def __init__(self, text):
        super().__init__()
        self.targets, self.anchors = [], set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("href", "src") and value is not None:
                self.targets.append(value)
            elif name in ("id", "name") and value:
                self.anchors.add(value)


@cache
def links(path):
    """Those of a page."""
    return Links(path.read_text(encoding="utf-8"))


def leads_somewhere(site, page, target):
    """Whether a file of the site is there, and in it what is behind #."""
    parts = urlsplit(target)
    path = (page.parent / unquote(parts.path)).resolve() if parts.path else page
    if not path.is_file() or not path.is_relative_to(site):
        return False
    anchor = unquote(parts.fragment)
    return not anchor or path.suffix != ".html" or anchor in links(path).anchors


def test_every_link_leads_somewhere(site):
    pages = sorted(site.rglob("*.html"))
    assert len(pages) >= 60
    broken = [
        f"{page.relative_to(site)}: {target}"
        for page in pages
        for target in dict.fromkeys(links(page).targets)
        if not urlsplit(target).scheme and not leads_somewhere(site, page, target)
    ]
    assert broken == []


def test_nothing_is_loaded_from_the_network(site):
    found = {page.name: FROM_NETWORK.findall(page.read_text()) for page in site.rglob("*.html")}
    assert {name: there for name, there in found.items() if there} == {}


def test_addresses_of_others_are_whole_and_no_placeholders(site):
    found = {
        target
        for page in site.rglob("*.html")
        for target in links(page).targets
        if urlsplit(target).scheme not in ("", "data")
    }
    (places.ROOT / "build" / "addresses.txt").write_text("\n".join(sorted(found)) + "\n")
    for target in found:
        parts = urlsplit(target)
        assert parts.scheme in ("https", "http", "mailto"), target
        assert parts.scheme == "mailto" or re.fullmatch(r"[\w.-]+\.[a-z]{2,}", parts.netloc), target
        assert not NOBODY.search(parts.netloc), target
        assert not re.search(r"[\s<>\"{}]", target), target


def titles(site):
    """{title of a section: where it is}, as search finds it."""
    index = json.loads((site / "search" / "search_index.json").read_text(encoding="utf-8"))
    found = {}
    for row in index["docs"]:
        plain = html.unescape(re.sub(r"<[^>]+>", "", row["title"]))
        found.setdefault(plain.strip().removesuffix("¶"), []).append(row["location"])
    return found


def test_search_finds_every_public_name_of_python(site):
    """As the heading of a section of the reference."""
    there = {
        re.sub(r"\W.*", "", title)
        for title, at in titles(site).items()
        if any(place.startswith("api/") for place in at)
    }
    assert sorted(NAMES - there) == []


def test_search_finds_every_public_header(site):
    there = titles(site)
    for folder, name in headers.INCLUDED.findall(headers.CONTENTS.read_text()):
        title = name.split("/")[-1]
        assert any(at.startswith(f"api/cpp/{folder}.html") for at in there.get(title, [])), title


def test_search_from_the_disk_has_the_same_index(site):
    index = (site / "search" / "search_index.json").read_text(encoding="utf-8")
    assert (site / "search" / "search_index.js").read_text(encoding="utf-8") == (
        f"var __index = {index}"
    )


def test_version_is_at_the_foot_of_every_page(site):
    version = re.search(r"^version: (.+)$", (places.ROOT / "CITATION.cff").read_text(), re.M)[1]
    for page in site.rglob("*.html"):
        assert f"Pliant {version} · MIT licence" in page.read_text(encoding="utf-8"), page
