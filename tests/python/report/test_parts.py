# SPDX-License-Identifier: MIT
"""Parts of an analysis: found by their types, and left out of the report where they are missing."""

import json
from base64 import b64encode
from dataclasses import replace

import numpy as np
import pytest
from pliant.base.console import Table
from pliant.base.verdict import Verdict
from pliant.measure.domains import LOOSE, Domains, Hinge
from pliant.measure.stages.parts import ReferenceStructure, Units
from pliant.report.build import Report
from pliant.report.section import Fact, Picture
from pliant.report.sections.bars import Residuals
from pliant.report.sections.domains import KNOWN, RigidDomains
from pliant.report.sections.headings import SHAPES
from pliant.report.sections.measured import Measured
from pliant.report.sections.motions import Components
from pliant.report.sections.series import Rmsd
from pliant.report.sections.table import SECTIONS
from pliant.report.sections.torsions import Torsions
from pliant.report.suite import AnalysisReport
from pliant.report.write import write_report

from pliant.base import style


def shown(analysis, sections=SECTIONS):
    """All that a report of these parts has, but for its files."""
    report = Report(analysis, sections)
    tables = [one for row in report.sections for one in row.tables(analysis)]
    columns = [make(analysis) for row in report.sections for make in row.columns.values()]
    pictures = {one.name for one in report.pictures}
    return report.verdicts, report.values, [*report.lines()], tables, columns, pictures


def without(analysis, kind):
    return replace(analysis, parts={k: v for k, v in analysis.parts.items() if k is not kind})


@pytest.mark.parametrize(
    ("kind", "figure"), [(Rmsd, "rmsd"), (Torsions, "torsions"), (Components, "pca")]
)
def test_a_figure_needs_its_part(analysis, kind, figure):
    less = without(analysis, kind)
    assert figure in shown(analysis)[-1] and figure not in shown(less)[-1]
    assert kind in analysis and kind not in less and less.get(kind) is None
    with pytest.raises(KeyError):
        less[kind]


def test_what_is_missing_is_left_out_and_all_else_is_shown(analysis):
    every = shown(analysis)
    for kind in {*analysis.parts} - {ReferenceStructure, Units, Residuals}:
        verdicts, values, *_ = shown(without(analysis, kind))
        assert set(values) <= set(every[1]), kind
        assert set(verdicts) <= set(every[0]), kind


def test_a_section_is_one_row_and_shown_everywhere(analysis, tmp_path, monkeypatch):
    def draw(analysis):
        figure, axes = style.new_figure()
        axes.plot(analysis.frames)
        return figure

    row = Measured(
        name="weather",
        stage="weather",
        heading=SHAPES,
        verdict=lambda analysis: Verdict("mixed", "It rains.", ""),
        values=lambda analysis: {"drops": 3},
        lines=lambda analysis: [("weather", "3 drops")],
        facts=lambda analysis: [Fact("3", "", "drops of rain")],
        tables=lambda analysis: [Table("Drops", ("drop", "size"), [("first", "large")])],
        columns={"drops": lambda analysis: {"drop": [1, 2, 3]}},
        per_frame=lambda analysis: {"wet": analysis.frames},
        pictures=[Picture("rain", draw, "How much it rains.")],
        methods={"Rain": "By a bucket."},
    )
    monkeypatch.setattr("pliant.report.sections.table.SECTIONS", (row, *SECTIONS))
    monkeypatch.setattr("pliant.report.write.SECTIONS", (row, *SECTIONS[:3]))
    report = AnalysisReport(analysis, write_report(analysis, tmp_path, 50))
    assert ("weather", "3 drops") in report.facts() and "It rains." in report.verdict.sentence
    assert report.as_json()["drops"] == 3
    assert (tmp_path / "drops.csv").read_text().splitlines() == ["drop", "1", "2", "3"]
    assert ",wet" in (tmp_path / "frames.csv").read_text().splitlines()[0]
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    picture = b64encode((tmp_path / "rain.png").read_bytes()).decode()
    said = ("It rains.", "drops of rain", "Drops", "How much it rains.", "By a bucket.", picture)
    assert [text for text in said if text not in page] == []


def test_domains_are_listed_with_how_often_they_are_found(analysis):
    count = len(analysis[Units].labels)
    text = "Domains that move as rigid bodies"

    def made(domain, found, counts, hinges=(), undecided=()):
        domains = Domains(domain, 0.5, np.array(found), counts, list(hinges), np.zeros(count),
                          list(undecided))  # fmt: skip
        part = RigidDomains(domains, np.arange(count), domain, np.zeros(count))
        whole = analysis.having(part)
        verdicts, values, _, tables, *_ = shown(whole)
        rows = [one.rows for one in tables if one.title == text]
        return rows, verdicts["domains"], values

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
    assert KNOWN in verdict.details
    assert values["domain_table"][1]["share"] == 0.94 and values["hinges"][0]["share"] == 0.8
    json.dumps(values["hinges"])
    none = np.full(count, LOOSE)
    (rows,), verdict, values = made(none, [], {1: 0.6, 2: 0.4}, (), [(np.array([0, 1]), 0.4)])
    assert [row[0] for row in rows] == ["undecided", "how many"] and rows[0][2] == "40 %"
    assert verdict.kind == "open" and verdict.sentence == "No reproducible domains were found."
    assert "1 in 60 %, 2 in 40 %" in verdict.details and values["domains"] == 0
