# SPDX-License-Identifier: MIT
"""The page of pliant rigidity: by the command and by Python the same, in a browser."""

import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from browser import Page, chromium
from real_files import ROOT

import pliant

pytest.importorskip("MDAnalysisTests")
import MDAnalysisTests

OPEN = Path(MDAnalysisTests.__file__).parent / "data" / "adk_open.pdb"
COMMAND = Path(sys.executable).parent / "pliant"

needs_browser = pytest.mark.skipif(chromium() is None, reason="no Chromium is installed")


def run(*words, **options):
    return subprocess.run(
        [COMMAND, "rigidity", *map(str, words)], capture_output=True, text=True, **options
    )


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    """Of adenylate kinase, with its dilution."""
    path = tmp_path_factory.mktemp("rigidity") / "adk.html"
    done = run(OPEN, "--dilution", "--page", path)
    assert done.returncode == 0, done.stderr
    return path


def scene_of(text):
    return json.loads(re.search(r'id="scene">(.*?)</script>', text, re.DOTALL)[1])


def test_python_writes_the_page_that_the_command_writes(page, tmp_path):
    with pytest.warns(pliant.PliantWarning, match="no element"):
        found = pliant.rigidity(pliant.read(OPEN))
    found.write_page(tmp_path / "adk.html", dilution=True)
    assert (tmp_path / "adk.html").read_text() == page.read_text()
    with pytest.raises(pliant.FileError, match=r"adk.html: exists; --overwrite replaces it"):
        found.write_page(tmp_path / "adk.html")
    found.write_page(tmp_path / "adk.html", overwrite=True)
    assert "As hydrogen bonds are removed" not in (tmp_path / "adk.html").read_text()


def test_of_a_small_molecule_too(tmp_path):
    path = ROOT / "data" / "molecules" / "aspirin.sdf"
    assert run(path, "--page", tmp_path / "one.html").returncode == 0
    pliant.rigidity(pliant.read(path)).write_page(tmp_path / "two.html")
    text = (tmp_path / "one.html").read_text()
    assert text == (tmp_path / "two.html").read_text()
    assert "C6 H4" in text and "5 internal degrees of freedom" in text


def test_colours_are_those_of_the_clusters(page):
    found = json.loads(run(OPEN, "--json").stdout)
    scene = scene_of(page.read_text())
    coloured = [row["colour"] for row in found["clusters"] if "colour" in row]
    assert scene["palettes"]["cluster"] == coloured
    assert [row["atoms"] >= 20 for row in found["clusters"]].count(True) == len(coloured)
    every = np.array(found["cluster_of_atom"]) - 1
    with pytest.warns(pliant.PliantWarning, match="no element in columns 77-78"):
        symbols = pliant.read(OPEN).symbols
    heavy = [k for k, name in enumerate(symbols) if name != "H"]
    assert scene["units"]["cluster"] == every[heavy].tolist()


# CORE 1-29, 68-117, 161-214; NMP 30-67; LID 118-160 (Schulz, Mueller, Diederichs, J. Mol. Biol. 213
# (1990) 627).
def test_it_names_the_domains_of_adenylate_kinase(page):
    text = page.read_text()
    rows = re.findall(r"</i> \d+</td>.*?>(\d+)</td>.*?<td[^>]*>([-0-9, ]+)</td></tr>", text)
    assert rows[:3] == [
        ("1473", "1-6, 13-40, 61-110, 161-213"),
        ("385", "113-154"),
        ("91", "43-56"),
    ]
    assert "255 internal degrees of freedom" in text
    assert "the largest has 44 % of the atoms" in text


def test_it_asks_no_network(page):
    text = re.sub(r"<script>.*?</script>", "", page.read_text(), flags=re.DOTALL)
    assert re.findall(r'(?:src|href)="(?!data:)[^"]*"', text) == []
    assert "default-src 'none'" in text


@pytest.mark.long
@needs_browser
def test_it_draws_clusters_and_flexibility(page, tmp_path):
    with Page(tmp_path / "profile") as browser:
        browser.open(page.as_uri())
        browser.wait_for("document.documentElement?.dataset.viewer !== undefined")
        assert browser.evaluate("document.documentElement.dataset.viewer") == "drawn"
        picture = "document.querySelector('#view canvas').toDataURL()"
        clusters = browser.evaluate(picture)
        legend = browser.evaluate("document.getElementById('legend').innerText")
        assert "rigid clusters, 5 with a colour; grey" in legend
        browser.evaluate("document.querySelector('#colours [data-key=flexibility]').click()")
        assert browser.evaluate(picture) != clusters
        size = {"width": 420, "height": 844, "deviceScaleFactor": 1, "mobile": False}
        browser.call("Emulation.setDeviceMetricsOverride", size)
        assert browser.evaluate("document.documentElement.scrollWidth") <= 420
        own = [url for url in browser.requests if not url.startswith(("data:", "blob:"))]
        assert own == [page.as_uri()]
        assert browser.errors == []


def test_an_existing_page_is_kept(page):
    before = page.read_text()
    done = run(OPEN, "--page", page)
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr.splitlines()[-1] == (
        f"pliant rigidity: error: {page}: exists; --overwrite replaces it"
    )
    assert page.read_text() == before


def test_without_the_python_package_it_says_so(tmp_path):
    """The command elsewhere than its programs."""
    alone = tmp_path / "pliant"
    shutil.copy(COMMAND, alone)
    words = [alone, "rigidity", OPEN, "--page", tmp_path / "x.html"]
    done = subprocess.run(words, capture_output=True, text=True, env={"PATH": "/nowhere"})
    assert done.returncode == 1
    assert done.stderr == (
        "pliant: error: --page is made by the Python package: install it (pip install pliant), so "
        "that pliant-rigidity-page is on PATH\n"
    )


@pytest.mark.skipif(not Path("/usr/bin/pymol").exists(), reason="no PyMOL is installed")
def test_pymol_runs_the_script(tmp_path):
    """Its own colours of residues, as it says them."""
    assert run(OPEN, "-o", tmp_path / "found").returncode == 0
    command = "iterate clusters and name CA and resi 100+130+50, print('found', resi, color)"
    words = ["/usr/bin/pymol", "-cq", "show.pml", "-d", command]
    done = subprocess.run(
        words, cwd=tmp_path / "found", capture_output=True, text=True, env={"PATH": "/usr/bin:/bin"}
    )
    assert done.returncode == 0
    assert "Error" not in done.stdout + done.stderr
    colours = re.findall(r"^found (\d+) (\d+)$", done.stdout, re.MULTILINE)
    assert [residue for residue, _ in colours] == ["50", "100", "130"]
    assert len({colour for _, colour in colours}) == 3
    assert 'scene stored as "F2"' in done.stdout
