# SPDX-License-Identifier: MIT
"""The report page in a real browser: it draws, plays and colours, and asks no network."""

import base64
import json
import re
import shutil
from pathlib import Path

import numpy as np
import pytest
from browser import Page, chromium
from firefox import BINARY, Firefox
from pliant.report.command import main
from pliant.report.page.bundle import viewer_script

from pliant.base import style

needs_browser = pytest.mark.skipif(chromium() is None, reason="no Chromium is installed")

#: share of the 3-D view's pixels that are not white, as the browser has them
INK = """(async () => {
  const canvas = document.querySelector("#view canvas");
  const image = new Image();
  image.src = canvas.toDataURL("image/png");
  await image.decode();
  const copy = document.createElement("canvas");
  [copy.width, copy.height] = [canvas.width, canvas.height];
  const context = copy.getContext("2d");
  context.drawImage(image, 0, 0);
  const data = context.getImageData(0, 0, copy.width, copy.height).data;
  const pixels = { ink: 0, orange: 0 };
  for (let k = 0; k < data.length; k += 4) {
    const [red, green, blue, alpha] = data.subarray(k, k + 4);
    if (alpha > 0 && red + green + blue < 720) pixels.ink += 1;
    if (red > 120 && green < 0.62 * red && blue < 0.25 * red) pixels.orange += 1;
  }
  return { ink: 4 * pixels.ink / data.length, orange: 4 * pixels.orange / data.length };
})()"""

DRAWN = "document.documentElement?.dataset.viewer !== undefined"
#: how many tables show less than they hold
TABLES_CUT = (
    "[...document.querySelectorAll('.table')].filter((t) => t.scrollWidth > t.clientWidth).length"
)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("page")


@pytest.fixture
def report(folder, peptide, wander, write_run, rendered):
    """A report of 30 frames, of which frame 12 has bars far beyond tolerance."""
    path = folder / "out" / "report.html"
    if not path.exists():
        trajectory = wander(peptide, peptide.rotatable, 30, degrees=12.0)
        trajectory[12, 6] += [0.0, 0.0, 0.2]
        run = write_run(folder / "run.h5md", peptide, trajectory, converged=np.arange(30) != 12)
        assert main([str(run), "-o", str(folder / "out"), "--quiet", "--dpi", "100"]) == 0
    return path


@pytest.fixture(scope="module")
def opened(folder):
    """Opens a page in one browser for all tests of this module."""
    with Page(folder / "profile") as browser:

        def open_page(path):
            browser.errors.clear()
            browser.requests.clear()
            browser.open(path.as_uri())
            browser.wait_for(DRAWN)
            return browser

        yield open_page


def press(browser, group, key):
    browser.evaluate(f"document.querySelector('#{group} [data-key=\"{key}\"]').click()")


def frame(browser):
    return int(browser.evaluate("document.documentElement.dataset.frame"))


@needs_browser
class TestViewer:
    def test_it_draws_without_errors_and_without_network(self, report, opened, tmp_path):
        browser = opened(report)
        assert browser.evaluate("document.documentElement.dataset.viewer") == "drawn"
        assert browser.evaluate("document.querySelectorAll('#view canvas').length") == 1
        assert browser.evaluate(INK)["ink"] > 0.01
        browser.screenshot(tmp_path / "report.png", whole=True)
        assert (tmp_path / "report.png").stat().st_size > 50_000
        foreign = [url for url in browser.requests if not url.startswith(("data:", "blob:"))]
        assert foreign == [report.as_uri()]
        assert browser.errors == []

    @pytest.mark.long
    def test_every_figure_is_shown(self, report, opened):
        browser = opened(report)
        broken = "[...document.images].filter((i) => !i.complete || i.naturalWidth === 0).length"
        assert browser.evaluate("document.images.length") == 10
        assert browser.evaluate(broken) == 0
        assert browser.evaluate("[...document.images].every((image) => image.alt.length > 20)")

    @pytest.mark.long
    def test_the_slider_goes_to_a_frame(self, report, opened):
        browser = opened(report)
        before = browser.evaluate("document.querySelector('#view canvas').toDataURL()")
        browser.evaluate(
            "(() => { const s = document.getElementById('slider'); s.value = 20;"
            "s.dispatchEvent(new Event('input')); })()"
        )
        assert frame(browser) == 20
        assert (
            browser.evaluate("document.getElementById('place').textContent")
            == "frame 20 · step 200"
        )
        assert browser.evaluate("document.querySelector('#view canvas').toDataURL()") != before

    @pytest.mark.long
    def test_it_plays_and_pauses(self, report, opened):
        browser = opened(report)
        browser.evaluate("document.getElementById('play').click()")
        browser.wait_for("Number(document.documentElement.dataset.frame) > 2")
        browser.evaluate("document.getElementById('play').click()")
        assert browser.evaluate("document.documentElement.dataset.playing") == "false"
        stopped = frame(browser)
        browser.evaluate("new Promise((resolve) => setTimeout(resolve, 400))")
        assert frame(browser) == stopped

    @pytest.mark.long
    def test_a_click_on_the_chart_goes_there(self, report, opened):
        browser = opened(report)
        browser.evaluate("document.getElementById('chart').scrollIntoView()")
        box = browser.evaluate(
            "(() => { const b = document.getElementById('chart').getBoundingClientRect();"
            "return [b.left, b.top, b.width, b.height]; })()"
        )
        left, top, width, height = box
        x = left + 58 + (width - 68) * 10 / 29  # the margins of timeline.mjs
        for kind in ("mousePressed", "mouseReleased"):
            place = {"x": x, "y": top + height / 2, "button": "left", "clickCount": 1}
            browser.call("Input.dispatchMouseEvent", {"type": kind, **place})
        assert frame(browser) == 10

    @pytest.mark.long
    def test_broken_bars_are_orange_in_their_frame_only(self, report, opened):
        browser = opened(report)
        press(browser, "colours", "residual")
        assert browser.evaluate("document.getElementById('legend').hidden") is False
        shares = {}
        for number in (11, 12):
            browser.evaluate(
                f"(() => {{ const s = document.getElementById('slider'); s.value = {number};"
                "s.dispatchEvent(new Event('input')); })()"
            )
            shares[number] = browser.evaluate(INK)["orange"]
        assert shares[11] == 0
        assert shares[12] > 0.0005

    @pytest.mark.long
    @pytest.mark.parametrize(("style", "colour"), [("cartoon", "mobility"), ("balls", "element")])
    def test_styles_draw(self, report, opened, style, colour):
        self.draws(opened(report), style, colour)

    @pytest.mark.long
    @pytest.mark.parametrize("style", ["cartoon", "balls", "sticks", "spheres", "lines"])
    @pytest.mark.parametrize("colour", ["element", "mobility"])
    def test_every_style_draws(self, report, opened, style, colour):
        self.draws(opened(report), style, colour)

    def draws(self, browser, style, colour):
        press(browser, "colours", colour)
        press(browser, "styles", style)
        assert browser.evaluate(INK)["ink"] > 0.0005
        assert browser.errors == []

    @pytest.mark.long
    def test_it_fits_a_small_screen(self, report, opened):
        browser = opened(report)
        size = {"width": 390, "height": 844, "deviceScaleFactor": 1, "mobile": False}
        browser.call("Emulation.setDeviceMetricsOverride", size)
        try:
            assert browser.evaluate("document.documentElement.scrollWidth") <= 390
            assert browser.evaluate(TABLES_CUT) == 0
        finally:
            wide = {"width": 1320, "height": 1000, "deviceScaleFactor": 1, "mobile": False}
            browser.call("Emulation.setDeviceMetricsOverride", wide)

    def test_a_small_picture_is_a_copy_in_its_colours(self, report, opened, tmp_path):
        small = '<canvas data-colour="mobility" width="136" height="76"></canvas>'
        path = tmp_path / "small.html"
        text = report.read_text(encoding="utf-8").replace("<main>", f"<main>{small}")
        path.write_text(text, encoding="utf-8")
        browser = opened(path)
        pixels = (
            "document.querySelector('[data-colour]').getContext('2d').getImageData(0, 0, 136, 76)"
        )
        assert browser.evaluate(f"new Set({pixels}.data).size") > 20
        assert browser.evaluate(INK)["ink"] > 0.01

    def test_without_webgl_it_says_so(self, report, opened, tmp_path):
        text = report.read_text(encoding="utf-8")
        crippled = "<script>HTMLCanvasElement.prototype.getContext = () => null;</script>"
        path = tmp_path / "no-webgl.html"
        path.write_text(text.replace("<main>", crippled + "<main>"), encoding="utf-8")
        browser = opened(path)
        assert browser.evaluate("document.documentElement.dataset.viewer") == "failed"
        message = browser.evaluate("document.getElementById('message').textContent")
        assert message == (
            "The 3-D view could not be drawn. This browser gives no WebGL 2, by which the picture "
            "is drawn. The rest of the page is whole."
        )


@pytest.mark.long
@pytest.mark.skipif(not (BINARY and shutil.which("Xvfb")), reason="no firefox-esr or xvfb")
def test_firefox_draws_it_too(report, tmp_path):
    pytest.importorskip("websockets")
    (tmp_path / "profile").mkdir()
    with Firefox(tmp_path / "profile") as firefox:
        firefox.open(report.as_uri())
        assert firefox.tell(DRAWN)
        assert firefox.tell("document.documentElement.dataset.viewer") == "drawn"
        assert firefox.tell(INK)["ink"] > 0.01


def scene_of(path):
    found = re.search(r'id="scene">(.*?)</script>', path.read_text(encoding="utf-8"), re.DOTALL)
    return json.loads(found[1])


def test_the_page_refers_to_nothing_outside_itself(report):
    text = report.read_text(encoding="utf-8")
    own = re.sub(r"<script>.*?</script>", "", text, flags=re.DOTALL)
    assert (
        re.findall(r'(?:src|href)="(?!data:|[a-z_]+\.(?:csv|png|pdb|nmd|pml|cxc)")[^"]*"', own)
        == []
    )
    assert "default-src 'none'" in text
    assert not re.search(r"<script[^>]*\ssrc=", text)


def test_positions_in_the_page_are_those_of_the_file(report, peptide):
    """Distances within a frame survive thinning, superposition and rounding."""
    import base64

    import h5py

    scene = scene_of(report)
    with h5py.File(report.parent.parent / "run.h5md") as file:
        stored = file["particles/trajectory/position/value"][()]
    raw = np.frombuffer(base64.b64decode(scene["positions"]), dtype="<i2")
    shown = raw.reshape(30, -1, 3) * scene["step"]
    for frame in (0, 12, 29):
        ours = np.linalg.norm(shown[frame][:, None] - shown[frame][None], axis=2)
        theirs = np.linalg.norm(stored[frame][:, None] - stored[frame][None], axis=2)
        np.testing.assert_allclose(ours, theirs, atol=4 * scene["step"])
    codes = np.frombuffer(base64.b64decode(scene["residuals"]), dtype=np.uint8).reshape(30, -1)
    beyond = codes / scene["residual_codes"]["per_decade"] + scene["residual_codes"]["lowest"] > 0
    assert list(np.flatnonzero(beyond.any(axis=1))) == [12]
    assert scene["series"]["residual"]["marked"] == [12]


def test_large_trajectories_are_thinned_and_the_page_says_so(report):
    from pliant.measure.stages.analysis import AnalysisOptions
    from pliant.report.page.scene import scene
    from pliant.report.sections.table import analyse_trajectory

    analysis = analyse_trajectory(AnalysisOptions(str(report.parent.parent / "run.h5md")))
    small = scene(analysis, max_atoms=10, max_bytes=1000)
    assert len(small["atoms"]["names"]) == 4  # the CA atoms
    assert small["trace_only"] is True
    assert len(small["frames"]) < 30
    assert {small["frames"][0], small["frames"][-1]} == {0, 29}
    assert small["notes"] == [f"{len(small['frames'])} of the 30 frames", "the CA and P atoms only"]


def test_names_cannot_break_out_of_the_page(folder, pentane, write_run):
    pentane.names = ["</s", "<b>", "&C", '"C', "C5"]
    path = write_run(folder / "<i>&.h5md", pentane, [pentane.positions] * 4)
    assert main([str(path), "-o", str(folder / "names"), "--quiet", "--dpi", "60"]) == 0
    text = (folder / "names" / "report.html").read_text(encoding="utf-8")
    assert "<title>&lt;i&gt;&amp;.h5md</title>" in text
    own = re.sub(r"<script.*?</script>", "", text, flags=re.DOTALL)
    assert "<b>&C" not in own
    assert '</s"' not in text


def test_the_script_of_the_view_is_all_that_the_page_needs(report):
    script = viewer_script()
    assert not re.search(r"^(import|export) ", script, re.MULTILINE)
    named = set(re.findall(r"\bfrom_(\w+)", script))
    assert named == set(re.findall(r"^const from_(\w+) = ", script, re.MULTILINE))
    assert {"viewer", "scene", "ribbon_shader", "timeline"} <= named
    assert len(script) < 100_000
    assert report.stat().st_size < 1_000_000


@needs_browser
def test_it_prints_on_four_pages_and_follows_a_dark_screen(report, opened):
    browser = opened(report)
    colour = "getComputedStyle(document.body).backgroundColor"
    light = browser.evaluate(colour)
    feature = {"name": "prefers-color-scheme", "value": "dark"}
    browser.call("Emulation.setEmulatedMedia", {"features": [feature]})
    try:
        assert (light, browser.evaluate(colour)) == ("rgb(245, 246, 247)", "rgb(18, 23, 27)")
        blend = "getComputedStyle(document.querySelector('figure img')).mixBlendMode"
        assert browser.evaluate(blend) == "screen"
        printed = base64.b64decode(browser.call("Page.printToPDF")["data"])
    finally:
        browser.call("Emulation.setEmulatedMedia", {"features": []})
    assert 1 < len(re.findall(rb"/Type\s*/Page\b", printed)) <= 4
    assert printed.count(b"/Subtype /Image") >= 10  # the figures


def test_the_3d_view_and_the_figures_give_domains_the_same_colours():
    view = Path(__file__).parents[3] / "apps/play/page/view/colours.mjs"
    listed = view.read_text().split("CATEGORIES = [")[1].split("]")[0]
    colours = re.findall(r"#[0-9a-f]{6}", listed)
    assert [one.lower() for one in style.DOMAIN_COLOURS[: len(colours)]] == colours
