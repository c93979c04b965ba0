# SPDX-License-Identifier: MIT
"""pliant study with measured data: adenylate kinase, open, and distances of the closed one."""

import csv
import json
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from browser import Page, chromium
from real_files import MOLECULES

import pliant

pytest.importorskip("MDAnalysisTests")
import MDAnalysisTests
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import to_hex
from pliant.report.page import html
from pliant.report.page.map_surface import MapSurface
from pliant.report.study.agreement import agreement_section
from pliant.report.study.agreement_pictures import fitted_picture, residues_picture
from pliant.report.study.command import main

from pliant.base import style

DATA = Path(MDAnalysisTests.__file__).parent / "data"
OPEN, CLOSED = DATA / "adk_open.pdb", DATA / "adk_closed.pdb"
PAIRS = ((30, 126), (55, 170), (40, 150))
FEW = 160  #: frames, of which 60 are far from the start

pytestmark = [
    pytest.mark.usefixtures("no_drawing"),
    pytest.mark.filterwarnings("ignore::pliant.PliantWarning"),
]


def apart(structure, one, other):
    """Of the alpha carbons of two residues."""
    chosen = np.flatnonzero((structure.names == "CA") & (structure.elements == 6))
    at = dict(zip(structure.residue_ids[chosen].tolist(), structure.positions[chosen], strict=True))
    return float(np.linalg.norm(at[one] - at[other]))


@pytest.fixture(scope="module")
def table(tmp_path_factory):
    """Three distances."""
    path, closed = tmp_path_factory.mktemp("data") / "measured.csv", pliant.read(CLOSED)
    rows = [(one, other, apart(closed, one, other), 1) for one, other in PAIRS]
    with open(path, "w", encoding="utf-8", newline="") as file:
        csv.writer(file).writerows([("site1", "site2", "distance", "error"), *rows])
    return path


@pytest.fixture(scope="module")
def studied(table, tmp_path_factory):
    folder = tmp_path_factory.mktemp("study") / "out"
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("pliant.jobs.fit.molecule.sample", None)  # the study's frames are the starts
        patch.setattr("pliant.report.study.stages.FRAMES", FEW)
        return pliant.study(OPEN, output=folder, distances=table, frames=FEW, check=False)


def test_the_fitted_structure_is_written_and_has_the_distances(studied):
    fitted = pliant.read(studied.folder / "fitted.pdb")
    for (one, other), found in zip(PAIRS, studied.fit.found.data, strict=True):
        assert apart(fitted, one, other) == pytest.approx(found.found, abs=0.01)
        assert abs(found.violation) <= 1
    assert studied.outputs["fitted"] == studied.folder / "fitted.pdb"
    assert "fitted.pdb" in studied.answers["files"]
    assert "load fitted.pdb, fitted" in (studied.folder / "show.pml").read_text()


def test_the_answer_says_whether_they_agree_and_what_is_determined(studied):
    said = studied.answers["data"]
    assert said.startswith("Data and structure agree: 3 of 3 distances hold within 1 Å.")
    assert re.search(r"Half of the residues are determined to [\d.]+ Å, nine of ten to", said)
    assert list(studied.answers)[1] == "data"
    found = studied.as_json()["fit"]
    assert found["agrees"] and len(found["distances"]) == 3


def test_the_page_has_a_table_and_both_structures(studied):
    page = studied.page.read_text()
    assert page.index("<h3>data</h3>") < page.index("<h2>Does it agree with the data?</h2>")
    for one in studied.fit.found.data:
        assert f"<tr><td>{one.name}</td>" in page
    scene = json.loads(re.search(r'id="scene">(.*?)</script>', page)[1])
    overlay, names = scene["overlay"], scene["atoms"]["names"]
    assert {names[atom] for atom in overlay["lines"]} == {"CA"}
    assert len(overlay["lines"]) == 6 and overlay["colours"] == [style.SKY]
    assert '<a href="fit_residues.csv">' in page


@pytest.mark.parametrize(
    ("of_first", "of_all", "kind", "said"),
    [
        ({}, {"off_left_out": 1.0}, "good", "Data and structure agree: 3 of 3"),
        ({}, {"off_left_out": 99.0}, "mixed", "The data do not predict each other: do not rely"),
        ({"violation": 3.0}, {}, "mixed", "Data and structure do not agree: 2 of 3"),
        ({"contradicts": True}, {}, "mixed", "1 of 3 distances cannot hold with the others: 30"),
    ],
)
def test_what_does_not_agree_is_in_the_verdict(studied, of_first, of_all, kind, said):
    first, *others = studied.fit.found.data
    data = [replace(first, **of_first), *others]
    fit = replace(studied.fit, found=replace(studied.fit.found, data=data, **of_all))
    verdict = agreement_section(fit).verdict(studied.report.analysis)
    assert (verdict.kind, verdict.sentence[: len(said)]) == (kind, said)


def test_distances_that_do_not_hold_are_red(studied):
    first, *others = studied.fit.found.data
    data = [replace(first, violation=3.0), *others]
    fit = replace(studied.fit, found=replace(studied.fit.found, data=data))
    drawn = fitted_picture(fit).axes[0].collections
    lines = next(one for one in drawn if isinstance(one, LineCollection))
    colours = [to_hex(colour).upper() for colour in lines.get_colors()]
    assert colours == [style.VERMILION, style.SKY, style.SKY]
    rows = next(iter(agreement_section(fit).tables(studied.report.analysis))).rows
    assert rows[0][-1] == "off by +3.0"
    assert '<tr class="off"><td>' in html.table(("",), rows[:1])
    assert '<tr class="off"><td>' not in html.table(("",), rows[1:])


def pictures(*keys):
    """Of the view, after presses of buttons: at once, so that all are as fine."""
    return f"""{[*keys]}.map((key) => {{
      document.querySelector(`#shown [data-key=${{key}}]`).click();
      return document.querySelector('#view canvas').toDataURL();
    }})"""


@pytest.mark.skipif(chromium() is None, reason="no Chromium is installed")
def test_the_view_shows_the_fitted_structure_over_the_start(studied, tmp_path):
    pressed = "document.querySelector('#shown [aria-pressed=true]').dataset.key"
    with Page(tmp_path / "profile") as browser:
        browser.open(studied.page.as_uri())
        browser.wait_for("document.documentElement?.dataset.viewer === 'drawn'")
        before, laid, after = browser.evaluate(pictures("frames", "overlay", "frames"))
        assert laid != before == after
        browser.evaluate("document.querySelector('#shown [data-key=overlay]').click()")
        browser.evaluate("document.querySelector('#slider').oninput()")
        assert browser.evaluate(pressed) == "frames"
        assert browser.errors == []


def volume_in(surface):
    one, two, three = np.moveaxis(surface.vertices[surface.triangles], 1, 0)
    return np.einsum("ij,ij->", one, np.cross(two, three)) / 6


@pytest.mark.parametrize("resolution", [3.0, 8.0, 15.0])
def test_the_surface_of_a_map_holds_the_molecule_and_is_small(resolution):
    closed = pliant.read(CLOSED)
    density = pliant.DensityMap.from_structure(closed, resolution)
    shown = MapSurface.around(density, resolution, closed)
    assert volume_in(shown) == pytest.approx(1.21 * closed.masses.sum(), rel=0.1)
    assert len(json.dumps(shown.drawn(np.zeros(3)))) < 300_000


def test_the_surface_of_noise_and_of_half_a_map_is_small_too():
    closed, draws = pliant.read(CLOSED), np.random.default_rng(1)
    density = pliant.DensityMap.from_structure(closed, 4.0)
    noise = draws.normal(size=density.shape) * 20 + density.values
    noisy = pliant.DensityMap(noise, density.spacing, density.origin)
    half = pliant.DensityMap(noise[:20], density.spacing, density.origin)
    for one in (noisy, half):
        shown = MapSurface.around(one, 4.0, closed)
        assert 100 < len(shown.vertices) <= 10_000
        assert shown.vertices.min() > density.origin.min() - 1e-6


@pytest.fixture(scope="module")
def in_a_map(studied):
    """The fit as if it were of a map, too."""
    fitted = pliant.read(studied.folder / "fitted.pdb")
    density = pliant.DensityMap.from_structure(fitted, 8.0)
    return replace(studied.fit, surface=MapSurface.around(density, 8.0, fitted))


def test_in_a_map_the_structures_are_where_they_are(in_a_map):
    overlay = in_a_map.overlay()
    assert np.array_equal(overlay.positions[0], in_a_map.found.positions[0])
    drawn = overlay.drawn(np.arange(0, len(in_a_map.start), 7))
    middle = overlay.positions[0, ::7].mean(axis=0)
    assert drawn["surface"] == in_a_map.surface.drawn(middle)


def test_the_map_is_drawn_behind_the_fitted_structure(in_a_map, studied):
    of_map = [
        isinstance(one, PolyCollection) for one in fitted_picture(in_a_map).axes[0].collections
    ]
    assert sum(of_map) == 1
    assert "1.21 Å³ a dalton" in agreement_section(in_a_map).pictures[0].caption
    assert "dalton" not in agreement_section(studied.fit).pictures[0].caption


@pytest.mark.skipif(chromium() is None, reason="no Chromium is installed")
@pytest.mark.parametrize("theme", ["light", "dark"])
def test_the_view_shows_the_map_and_hides_it(in_a_map, studied, theme, tmp_path):
    page = studied.page.read_text()
    text = re.search(r'id="scene">(.*?)</script>', page)[1]
    scene = json.loads(text)
    about = in_a_map.found.positions[0].mean(axis=0)
    scene["overlay"]["surface"] = in_a_map.surface.drawn(about)
    (tmp_path / "map.html").write_text(page.replace(text, json.dumps(scene)))
    with Page(tmp_path / "profile") as browser:
        features = [{"name": "prefers-color-scheme", "value": theme}]
        browser.call("Emulation.setEmulatedMedia", {"features": features})
        browser.open((tmp_path / "map.html").as_uri())
        browser.wait_for("document.documentElement?.dataset.viewer === 'drawn'")
        seen = browser.evaluate(pictures("overlay", "map", "overlay", "frames"))
        assert seen[0] == seen[2]
        assert len(set(seen)) == 3
        assert browser.errors == []


def test_the_spread_is_drawn_by_residue(studied):
    drawn = residues_picture(studied.fit).axes[0].lines[0].get_ydata()
    assert np.allclose(drawn, studied.fit.found.spread)


@pytest.mark.parametrize(
    ("words", "code", "message"),
    [
        (["--resolution", "8"], 2, "resolution, half, place: of a map, and none is given"),
        (["--map", "none.mrc"], 2, "resolution: a map needs it, in Angstrom; a header does not"),
        (["--map", "none.mrc", "--resolution", "0"], 2, "resolution = 0: must be from 0.5 to 200"),
        (["--distances", "none.csv"], 1, "none.csv: No such file or directory"),
        (["--distances", "bad.csv"], 1, "bad.csv:2: site2 '1126': expected one residue of a"),
        (
            ["--distances", "bad.csv", "--free-torsions"],
            2,
            "free_torsions: does not go with data: pliant fit does not take it",
        ),
    ],
)
def test_wrong_data_are_refused_before_anything_is_sampled(
    words, code, message, tmp_path, capsys, monkeypatch
):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("pliant.report.study.suite.run_job", None)  # sampling would fail
    Path("bad.csv").write_text("site1,site2,high\n30,1126,20\n", encoding="utf-8")
    assert main([str(OPEN), *words, "-o", "out"]) == code
    said = capsys.readouterr().err.splitlines()
    assert len(said) == 1
    assert said[0].startswith(f"pliant study: error: {message}")
    assert not Path("out").exists()


def test_data_are_of_a_protein_or_nucleic_acid(table, tmp_path):
    with pytest.raises(pliant.InputError, match="expected a protein or nucleic acid"):
        pliant.study(MOLECULES / "aspirin.sdf", output=tmp_path / "out", distances=table)
    with pytest.raises(pliant.OptionError, match="need FILE"):
        pliant.study(smiles="CCO", output=tmp_path / "out", distances=table)


@pytest.mark.long
def test_a_map_closes_it_and_is_shown_by_residue(tmp_path):
    density = pliant.DensityMap.from_structure(pliant.read(CLOSED), 8.0)
    folder = tmp_path / "out"
    found = pliant.study(
        OPEN,
        output=folder,
        map=density,
        half=density,
        resolution=8.0,
        place=True,
        frames=20,
        check=False,
    )
    assert found.fit.surface is not None
    assert "<td>other half</td>" in found.page.read_text()
    assert "both in the map" in found.page.read_text()
    assert found.answers["data"].startswith("Structure and map agree: correlation 0.9")
    assert "residues without density" in found.page.read_text()
    above, below = residues_picture(found.fit).axes
    assert np.allclose(above.lines[0].get_ydata(), found.fit.found.density.by_residue)
    assert np.allclose(above.lines[1].get_ydata(), found.fit.found.density.by_residue_at_start)
    assert np.allclose(below.lines[0].get_ydata(), found.fit.found.spread)
    with open(folder / "fit_residues.csv", encoding="utf-8") as file:
        assert next(csv.reader(file))[2:] == ["correlation_start", "correlation_fitted"]
