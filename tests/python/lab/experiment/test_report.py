# SPDX-License-Identifier: MIT
"""The report: every figure and claim on one page that needs nothing else; the sweep; questions."""

import base64
import dataclasses
import json
import re
import shutil
import struct
from html.parser import HTMLParser
from types import SimpleNamespace

import pytest
from pliant.lab.experiment import command, sections
from pliant.lab.experiment import report as reports
from pliant.lab.experiment.claims import CLAIMS, evidence_by_yardstick
from pliant.lab.experiment.document import Answer, Figure, Table
from pliant.lab.experiment.drawings import BAR_CHARTS, HISTOGRAMS
from pliant.lab.experiment.report import make_report
from pliant.lab.experiment.settings import Settings
from pliant.lab.experiment.settled import settle
from pliant.lab.experiment.statistics import Evidence
from pliant.lab.experiment.sweep import Point, grid, read_sweep, run_sweep
from pliant.lab.experiment.sweep import points_of as sweep_points_of
from pliant.lab.experiment.table import read

THESIS_FIGURES = ["5.1", "5.3", "5.4", "5.6", "5.7", "5.9", *(f"C.{k}" for k in range(1, 16))]


class Page(HTMLParser):
    """What a page holds: texts, pictures, and whether every element that opens also closes."""

    OPEN_ENDED = frozenset({"meta", "link", "img", "br"})

    def __init__(self, text):
        super().__init__()
        self.stack, self.images, self.links, self.texts = [], [], [], []
        self.feed(text)
        assert self.stack == []

    def handle_starttag(self, tag, attrs):
        if tag not in self.OPEN_ENDED:
            self.stack.append(tag)
        if tag == "img":
            self.images.append(dict(attrs)["src"])
        self.links += [value for name, value in attrs if name in ("href", "src")]

    def handle_endtag(self, tag):
        assert self.stack.pop() == tag

    def handle_data(self, data):
        self.texts.append(data)


@pytest.fixture(scope="module")
def report(experiment_folder, tmp_path_factory):
    folder = tmp_path_factory.mktemp("report") / "study"
    shutil.copytree(experiment_folder, folder)
    return make_report(folder, questions=False, quick=True, replicates=50)


@pytest.fixture(scope="module")
def page(report):
    return Page(report.path.read_text())


@pytest.mark.long
def test_every_figure_of_the_thesis_is_drawn(report):
    numbers = [chart.number for chart in (*BAR_CHARTS, *HISTOGRAMS)]
    assert numbers == THESIS_FIGURES
    for number in numbers:
        head = (report.path.parent / "figures" / f"figure-{number}.png").read_bytes()[:24]
        assert head[:8] == b"\x89PNG\r\n\x1a\n"
        width, height = struct.unpack(">II", head[16:])
        assert width > 1000 and height > 250


def test_histograms_are_numbered_as_the_list_of_figures_has_them():
    named = {chart.number: (chart.technique, chart.family) for chart in HISTOGRAMS}
    assert named["C.1"] == ("bfs_tree", "tree")
    assert named["C.4"] == ("bfs_adapt", "1-cycle")
    assert named["C.10"] == ("random", "1-cycle")
    assert named["C.13"] == ("bfs_reverse", "2-cycle")
    assert named["C.15"] == ("random", "2-cycle")


@pytest.mark.long
def test_the_page_needs_nothing_else(page, report):
    assert all(link.startswith(("data:", "#")) for link in page.links)
    assert len(page.images) == len(THESIS_FIGURES) + len(CLAIMS)
    for source in page.images:
        assert base64.b64decode(source.split(",")[1]).startswith(b"\x89PNG")
    assert not re.search(r"\bNaN\b|\bnan\b", " ".join(page.texts))


@pytest.mark.long
def test_the_page_has_every_claim_with_a_verdict(page, report):
    texts = " ".join(page.texts)
    for claim in CLAIMS:
        assert claim.text in texts
    assert {one.word for one in report.settled} <= {"open", "depends"}  # of a quick sweep
    assert [one.claim.id for one in report.settled] == [claim.id for claim in CLAIMS]
    t1 = report.settled[0]
    assert (t1.word, t1.settings_held) == ("open", t1.settings) and t1.settings > 50
    assert "This report cannot judge T1, " in texts
    assert "has 4 graphs of each of 3 families and 5 forces a graph" in texts


@pytest.mark.long
def test_the_sweep_is_read_back(report):
    points = read_sweep(report.path.parent)
    assert {point.claim for point in points} == {claim.id for claim in CLAIMS}
    again = settle(evidence_by_yardstick(Evidence(read(report.path.parent), replicates=50)), points)
    assert [(one.word, one.on_what) for one in again] == [
        (one.word, one.on_what) for one in report.settled
    ]


def test_the_sweep_has_the_axes_that_were_asked_for():
    cells = grid(Settings())
    assert len(set(cells)) == len(cells)
    assert {cell.tolerance_length for cell in cells} == {10.0**-k for k in range(1, 7)}
    for name, count in (("force", 5), ("box", 4), ("depth", 5), ("consecutive", 2)):
        assert len({getattr(cell, name) for cell in cells}) == count


@pytest.mark.long
def test_two_sweeps_are_the_same(tmp_path, monkeypatch):
    start = dataclasses.replace(Settings(seed=3), classes=("tree",))
    monkeypatch.setattr("pliant.lab.experiment.sweep.TOLERANCES", (1e-1, 1e-3))
    for name in ("one", "two"):
        (tmp_path / name).mkdir()
        run_sweep(start, tmp_path / name, quick=True)
    written = [(tmp_path / name / "sweep.csv").read_bytes() for name in ("one", "two")]
    assert written[0] == written[1]


def points_of(holding, graphs=20, pushes=25):
    """A sweep in which `holding` of two statements of T1 hold everywhere."""
    return [
        Point(
            tolerance, 50.0, 4, 3, 8, 10.0, False, 30.0, "T1", "sweeps", 2, holding, graphs, pushes
        )
        for tolerance in (1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6)
    ]


def test_a_claim_of_no_settings_must_hold_in_nearly_all_of_them(experiment_folder):
    all_evidence = evidence_by_yardstick(Evidence(read(experiment_folder), replicates=20))
    assert settle(all_evidence, points_of(2))[0].word == "holds"
    not_there = settle(all_evidence, points_of(1))[0]
    assert not_there.word == "depends"
    assert not_there.on_what.startswith("holds here, and in 0 of 6 settings of the sweep")


@pytest.mark.parametrize("size", [(4, 5), (19, 25), (20, 24), (0, 0)])
@pytest.mark.parametrize("holding", [1, 2])
def test_a_small_sweep_says_nothing_that_a_full_one_denies(experiment_folder, size, holding):
    all_evidence = evidence_by_yardstick(Evidence(read(experiment_folder), replicates=20))
    full = settle(all_evidence, points_of(1)) + settle(all_evidence, points_of(2))
    small = settle(all_evidence, points_of(holding, *size))
    assert small[0].word == "open"
    assert small[0].on_what.startswith("holds here; whether elsewhere too, ")
    for one in small[1:]:  # no sweep of these
        assert one.word in {other.word for other in full if other.claim is one.claim}


def test_what_a_report_cannot_judge_is_reported_with_the_numbers_of_its_sweep(experiment_folder):
    table = read(experiment_folder)
    all_evidence = evidence_by_yardstick(Evidence(table, replicates=20))
    for graphs, pushes in ((4, 5), (7, 11)):
        points = points_of(2, graphs, pushes)
        text = sections.cannot_judge(settle(all_evidence, points), points, quick=True)
        size = f"has {graphs} graphs of each of 3 families and {pushes} forces a graph"
        assert "cannot judge T1:" in text and size in text and "not to be cited" in text
        assert f"The sweep of 6 settings {size}" in sections.method(table, points)
    points = points_of(2, 0, 0)
    text = sections.cannot_judge(settle(all_evidence, points), points, quick=False)
    assert "does not say how many graphs and forces it has" in text
    points = points_of(2)
    assert sections.cannot_judge(settle(all_evidence, points), points, quick=False) == ""


def test_the_page_tells_the_replicates_that_were_drawn(experiment_folder):
    text = sections.method(read(experiment_folder), [], replicates=37)
    assert "Intervals are 95 % of 37 bootstrap replicates" in text


def test_points_of_the_sweep_count_their_graphs_and_pushes(experiment_folder):
    table = read(experiment_folder)  # 3 graphs of each class, 8 forces on each; one class of trees
    assert {(p.graphs, p.pushes) for p in sweep_points_of(table, 12.0)} == {(3, 8)}


def test_questions_have_a_page_each_in_their_order(experiment_folder, tmp_path, monkeypatch):
    shutil.copytree(experiment_folder, tmp_path / "study")
    asked = []

    def answer_of(name):
        def answer(out, seed, quick):
            asked.append((out.name, seed, quick))
            if name == "broken":
                raise RuntimeError("no data")
            picture = next((tmp_path / "study" / "figures").glob("*.png"))
            return Answer(
                f"What about {name}?",
                "It is so.",
                ["Because <it> is."],
                [Table("counts", ["what", "n"], [["cycles", 3], ["share", 0.25]])],
                [Figure(picture, "seen")],
            )

        return SimpleNamespace(
            answer=answer, TITLE=f"About {name}", __name__=f"pliant.lab.experiment.questions.{name}"
        )

    made = tuple(map(answer_of, ("short", "broken", "longest")))
    monkeypatch.setattr(reports, "QUESTIONS", made)
    monkeypatch.setattr("pliant.lab.experiment.drawings.HISTOGRAMS", HISTOGRAMS[:1])
    monkeypatch.setattr("pliant.lab.experiment.drawings.BAR_CHARTS", BAR_CHARTS[:1])
    made_report = make_report(tmp_path / "study", sweep=False, replicates=10)
    assert asked == [("short", 7, False), ("broken", 7, False), ("longest", 7, False)]
    text = made_report.path.read_text()
    assert text.index("What about short?") < text.index("What about longest?")
    assert "Because &lt;it&gt; is." in text
    assert "not answered: RuntimeError: no data" in text
    assert made_report.failed_questions == ["broken"]


def test_the_command_prints_the_claims(experiment_folder, tmp_path, capsys, monkeypatch):
    monkeypatch.setattr("pliant.lab.experiment.drawings.HISTOGRAMS", ())
    monkeypatch.setattr("pliant.lab.experiment.drawings.BAR_CHARTS", ())
    shutil.copytree(experiment_folder, tmp_path / "study")
    words = ["report", str(tmp_path / "study"), "--no-sweep", "--no-questions"]
    assert command.main(words) == 0
    out = capsys.readouterr().out
    assert all(re.search(rf"^ +{claim.id} +(holds|fails|depends)", out, re.M) for claim in CLAIMS)
    assert command.main([*words, "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert [row["id"] for row in found["claims"]] == [claim.id for claim in CLAIMS]


def test_a_folder_without_a_table(tmp_path, capsys):
    assert command.main(["report", str(tmp_path)]) == 1
    assert "run pliant lab experiment -o" in capsys.readouterr().err
