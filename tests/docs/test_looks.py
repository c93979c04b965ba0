# SPDX-License-Identifier: MIT
"""The site in a browser: on a desk and on a phone, from the disk and from a server."""

import json

import pytest
from browser import Page, chromium

pytestmark = [
    pytest.mark.long,
    pytest.mark.skipif(chromium() is None, reason="no Chromium is installed"),
]
WIDTHS = (1400, 420)
PATIENCE = 600  #: seconds; what takes longer hangs, also on a machine that does much else
OF_THE_PAGE = ("file:", "data:", "blob:", "about:")
LOADED = "document.readyState === 'complete'"
#: what sticks out of the page to the right, but for what scrolls by itself
STICKING_OUT = """[...document.querySelectorAll(".md-main *")].filter(one => {
  if (one.closest("pre, .md-typeset__scrollwrap, .output, .md-sidebar, math")) return false
  const box = one.getBoundingClientRect()
  return box.width > 0 && box.right > innerWidth + 1
}).slice(0, 3).map(one => one.outerHTML.slice(0, 120))"""
SEARCH = """(words => {
  const field = document.querySelector(".md-search__input")
  const open = document.querySelector("#__search")
  if (!open.checked) open.click()
  field.focus()
  field.value = words
  field.dispatchEvent(new Event("input", {bubbles: true}))
  field.dispatchEvent(new KeyboardEvent("keyup", {bubbles: true}))
})"""
FOUND = """[...document.querySelectorAll(".md-search-result__link")].map(one => one.href)"""


@pytest.fixture(scope="module")
def browser(tmp_path_factory):
    with Page(tmp_path_factory.mktemp("profile")) as page:
        yield page


def look_at(browser, address, width, scheme="light"):
    """Opens a page as wide as that; clears what earlier ones complained about."""
    browser.errors.clear()
    browser.requests.clear()
    size = {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": False}
    browser.call("Emulation.setDeviceMetricsOverride", size)
    feature = {"name": "prefers-color-scheme", "value": scheme}
    browser.call("Emulation.setEmulatedMedia", {"features": [feature]})
    browser.open(address)
    browser.wait_for(LOADED, PATIENCE)


@pytest.mark.parametrize("width", WIDTHS)
def test_pages_fit_complain_of_nothing_and_ask_no_network(site, browser, width):
    faults = []
    for path in sorted(site.rglob("*.html")):
        look_at(browser, path.as_uri(), width)
        name = path.relative_to(site).as_posix()
        wide = browser.evaluate("document.documentElement.scrollWidth")
        out = browser.evaluate(STICKING_OUT)
        asked = [one for one in browser.requests if not one.startswith(OF_THE_PAGE)]
        if wide > width or out or browser.errors or asked:
            faults.append((name, wide, out, browser.errors[:], asked))
    assert faults == []


def test_a_reader_in_the_dark_gets_dark_pages(site, browser):
    look_at(browser, (site / "index.html").as_uri(), 1400, "dark")
    shade = "getComputedStyle(document.body).backgroundColor.match(/\\d+/g).map(Number)"
    assert max(browser.evaluate(shade)[:3]) < 80
    look_at(browser, (site / "index.html").as_uri(), 1400, "light")
    assert min(browser.evaluate(shade)[:3]) > 200


def search(browser, words):
    """Addresses that a search finds, best first."""
    browser.evaluate(f"{SEARCH}({json.dumps(words)})")
    browser.wait_for(f"{FOUND}.length > 0", PATIENCE)
    return browser.evaluate(FOUND)


@pytest.mark.parametrize(
    ("words", "page"),
    [
        ("SampledEnsemble", "api/ensembles.html"),
        ("resolve_options.hpp", "api/cpp/resolve.html"),
        ("hinge", "protein.html"),
    ],
)
def test_search_finds_on_the_disk(site, browser, words, page):
    look_at(browser, (site / "index.html").as_uri(), 1400)
    assert any(page in address for address in search(browser, words))
    assert browser.errors == []
