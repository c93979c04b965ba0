# SPDX-License-Identifier: MIT
"""What the site is made of: links, formulas, headers, commands."""

import re

import headers
import help_texts
import places
import pytest

import pliant


def names_in_the_navigation():
    lines = (places.ROOT / "docs" / "mkdocs.yml").read_text().split("\nnav:\n")[1].splitlines()
    return [found[1] for line in lines if (found := re.match(r" +- ([\w/]+\.md)$", line))]


def test_every_page_is_in_the_navigation_once():
    there = [path.relative_to(places.PAGES).as_posix() for path in places.PAGES.rglob("*.md")]
    there += [name for _, name in places.included() if name.endswith(".md")]
    there += [places.site_name(path) for path in places.notebooks()]
    there += [name for name, _ in headers.pages()] + ["help.md"]
    assert sorted(names_in_the_navigation()) == sorted(there)


@pytest.mark.parametrize(
    ("page", "link", "expected"),
    [
        ("protein.md", "[a](../../src/pliant/sample/README.md#b)", "[a](inside/sampling.md#b)"),
        (
            "protein.md",
            "![a](../pictures/ubiquitin_flexibility.png)",
            "![a](pictures/ubiquitin_flexibility.png)",
        ),
        ("api/cpp/index.md", "[a](../../cpp.md)", "[a](../../cpp.md)"),
        ("inside/methods.md", "[a](../sample/README.md)", "[a](sampling.md)"),
        ("inside/methods.md", "[a](../../../LICENSE)", "a"),
        ("notebooks/race.md", "[a](../pages/python.md)", "[a](../python.md)"),
        ("protein.md", "[a](https://example.org/x.md)", "[a](https://example.org/x.md)"),
        ("protein.md", "[a](no_such_page.md)", "[a](no_such_page.md)"),
    ],
)
def test_links_lead_to_where_the_site_has_it(page, link, expected):
    assert places.with_links_of_the_site(link, page) == expected
    fenced = f"```\n{link}\n```"
    assert places.with_links_of_the_site(fenced, page) == fenced


def test_formulas_become_mathml():
    formulas = pytest.importorskip("formulas", reason="latex2mathml is not installed")
    html = formulas.with_mathml(r'<p><span class="arithmatex">\(x &lt; 1\)</span></p>')
    assert re.search(r"<p><math.*<mi>x</mi>.*&#x0003C;.*<mn>1</mn>.*</math></p>", html)


def test_every_public_header_has_its_comment_and_its_names():
    text = "\n".join(text for _, text in headers.pages())
    contents = headers.INCLUDED.findall(headers.CONTENTS.read_text())
    assert contents
    for folder, name in contents:
        assert f"`pliant/{folder}/{name}`: " in text
    assert "### `Framework`\n" in text
    assert "explicit Framework(FrameworkParts parts);" in text
    assert " private:" not in text
    assert "merge_duplicate_bars" not in text


def test_every_command_has_a_section():
    page = help_texts.page()
    assert len(re.findall("^## pliant", page, re.MULTILINE)) == len(
        list(help_texts.TEXTS.glob("*.help.txt"))
    )
    assert "\n## pliant lab bench work-precision\n" in page


def test_every_public_name_of_python_is_in_the_reference():
    text = "\n".join(path.read_text() for path in (places.PAGES / "api").glob("*.md"))
    listed = set(re.findall(r"^::: pliant\.(?:\w+\.)*(\w+)$", text, re.MULTILINE))
    names = {name for name in pliant.__all__ if not name.startswith("_")}
    assert len(names) >= 40
    assert sorted(names - listed) == []
    below = {name for one in names for name in getattr(getattr(pliant, one), "__all__", ())}
    shown = {"HasFrames", "RunSummary", "SampleSummary"}  # what results are
    assert sorted(listed - names) == sorted((below | shown) - names)
