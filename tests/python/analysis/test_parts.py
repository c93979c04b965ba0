# SPDX-License-Identifier: MIT
"""Parts of an analysis: found by their types, and left out of the report where they are missing."""

import json
import os
from dataclasses import replace

import numpy as np
import pytest
from pliant.measure.domains import LOOSE, Domains, Hinge
from pliant.measure.stages.analysis import AnalysisOptions
from pliant.measure.stages.parts import Components, RigidDomains, Rmsd, Torsions, Units
from pliant.measure.stages.stages import analyse_trajectory
from pliant.report.figures.figure_table import figures_of
from pliant.report.page.page_tables import tables
from pliant.report.summary import summary
from pliant.report.verdicts import verdicts


@pytest.fixture
def analysis(tmp_path, peptide, wander, write_run):
    trajectory = wander(peptide, peptide.rotatable, 12, degrees=25.0)
    run = write_run(tmp_path / "run.h5md", peptide, trajectory)
    return analyse_trajectory(AnalysisOptions(os.fspath(run)))


@pytest.mark.parametrize(
    ("kind", "figure"), [(Rmsd, "rmsd"), (Torsions, "torsions"), (Components, "pca")]
)
def test_a_figure_needs_its_part(analysis, kind, figure):
    without = replace(analysis, parts={k: v for k, v in analysis.parts.items() if k is not kind})
    names = {row.name for row in figures_of(analysis)}
    assert figure in names and figure not in {row.name for row in figures_of(without)}
    assert kind in analysis and kind not in without and without.get(kind) is None
    with pytest.raises(KeyError):
        without[kind]


def test_domains_are_listed_with_how_often_they_are_found(analysis):
    count = len(analysis[Units].labels)
    text = "Domains that move as rigid bodies"

    def made(domain, found, counts, hinges=(), undecided=()):
        domains = Domains(domain, 0.5, np.array(found), counts, list(hinges), np.zeros(count),
                          list(undecided))  # fmt: skip
        part = RigidDomains(domains, np.arange(count), domain, np.zeros(count))
        whole = analysis.having(part)
        rows = [one.rows for one in tables(whole) if one.caption == text]
        answers = verdicts(whole)
        return rows, answers["domains"], summary(whole, {}, answers)

    rows, verdict, values = made(np.zeros(count, dtype=int), [1.0], {1: 1.0})
    assert rows == [] and verdict.sentence.startswith("One piece") and values["domains"] == 1
    two = np.where(np.arange(count) < 2, 1, 0)
    hinge = Hinge(1, 2, 1, 0.8)
    (rows,), verdict, values = made(two, [1.0, 0.94], {2: 0.94, 3: 0.06}, [hinge])
    assert [row[0] for row in rows] == ["1", "2", "hinge", "how many"]
    assert [row[2] for row in rows] == ["100 %", "94 %", "80 %", ""]
    assert rows[3][1] == "2 in 94 %, 3 in 6 % of the resamples"
    assert (
        verdict.sentence == "2 domains, each found in at least 94 % of 50 resamples of the frames."
    )
    assert values["domain_table"][1]["share"] == 0.94 and values["hinges"][0]["share"] == 0.8
    json.dumps(values["hinges"])
    none = np.full(count, LOOSE)
    (rows,), verdict, values = made(none, [], {1: 0.6, 2: 0.4}, (), [(np.array([0, 1]), 0.4)])
    assert [row[0] for row in rows] == ["undecided", "how many"] and rows[0][2] == "40 %"
    assert verdict.kind == "open" and verdict.sentence == "No reproducible domains were found."
    assert "1 in 60 %, 2 in 40 %" in verdict.details and values["domains"] == 0
