# SPDX-License-Identifier: MIT
"""What objects show of themselves in notebooks and when they are printed."""

import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest
from pliant.base.display import as_html, as_text
from pliant.report.compare.comparison_report import ComparisonReport
from real_files import CAFFEINE

import pliant

PEPTIDE = CAFFEINE.with_name("peptide_20.pdb")


@pytest.fixture(scope="module")
def caffeine():
    return pliant.read(CAFFEINE)


@pytest.fixture(scope="module")
def peptide():
    structure = pliant.read(PEPTIDE)
    structure.perceive_bonds()
    return structure


def rows(shown):
    """The table as HTML parsers see it: what -> value."""
    table = ElementTree.fromstring(shown._repr_html_())
    cells = [["".join(cell.itertext()) for cell in row] for row in table.iter("tr")]
    return dict(cells)


def check(shown, expected):
    found, text = rows(shown), str(shown)
    assert {what: found[what] for what in expected} == expected
    assert all(value in text for value in expected.values())
    assert text.splitlines()[0] == f"pliant.{type(shown).__name__}"


def test_structure(caffeine):
    atoms = "24: H 10, C 8, N 4, O 2"
    check(caffeine, {"file": str(CAFFEINE), "atoms": atoms, "bonds": "25, known from: file 25"})


def test_framework(caffeine):
    framework = caffeine.framework(bars="bonds", pin="element C")
    facts = framework.graph_facts()
    expected = {"joints": "24, 8 pinned", "bars": "25", "independent cycles": str(facts.cycles)}
    check(framework, expected)
    check(facts, {"cycles": "2", "largest block": "10"})


def test_summaries_of_resolves_and_runs(caffeine):
    framework, positions = caffeine.framework(), caffeine.positions.copy()
    positions[3] += 0.3
    broken = pliant.measure_bars(framework, positions)
    check(broken, {"within the tolerance": "no"})
    assert f"off by {broken.max_relative:.2g} of its length" in rows(broken)["worst bar"]
    summary = pliant.resolve(framework, positions)
    check(summary, {"ended as": "converged", "sweeps": str(summary.sweeps)})
    ran = pliant.run(caffeine, steps=7)
    check(ran, {"steps": "7, 8 frames shown or recorded", "not converged": "0"})


def test_steps_that_did_not_converge_are_reported(caffeine):
    ran = pliant.run(caffeine, steps=3, technique="random", max_sweeps=1)
    assert ran.unconverged_steps > 0
    text = f"{ran.unconverged_steps}, the first is step {ran.first_unconverged_step}"
    check(ran, {"not converged": text})


def test_model_ensemble_and_rigidity(peptide):
    model = pliant.build_model(peptide)
    check(model, {"model": "protein", "bars": str(model.framework.bar_count)})
    ensemble = pliant.sample(model, frames=5)
    check(ensemble, {"frames": f"5, of {len(model.positions)} atoms"})
    assert f"{np.mean(ensemble.rmsf):.2f} Å" in rows(ensemble)["RMSF"]
    rigidity = pliant.rigidity(peptide)
    check(rigidity, {"internal degrees of freedom": str(rigidity.degrees_of_freedom)})


def test_reports(peptide, tmp_path):
    trajectory = tmp_path / "helix.h5md"
    pliant.sample(peptide, frames=12, output=trajectory)
    report = pliant.analyse(trajectory)
    check(report, {"file": str(trajectory), "frames": "12, of 327 atoms"})
    chosen = pliant.representatives(trajectory, 2)
    check(chosen, {"frames": ", ".join(map(str, chosen.frames))})
    path = pliant.path(peptide, peptide)
    check(path, {"distance from the end": "0.00 Å at first, 0.00 Å reached"})


def test_text_is_escaped():
    html = as_html("a<b", [("x", "<script>")])
    assert "<script>" not in html
    assert "&lt;script&gt;" in html
    assert as_text("t", [("long name", "1"), ("x", "2")]) == "t\n  long name  1\n  x          2"


def test_comparisons_show_what_was_compared():
    report = ComparisonReport("ours.h5md", ["a.pdb", "b.pdb"], None, None)
    assert report.facts() == [("ours", "ours.h5md"), ("theirs", "a.pdb"), ("theirs", "b.pdb")]
    assert "ours.h5md" in report._repr_html_()
