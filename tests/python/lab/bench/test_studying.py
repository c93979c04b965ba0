# SPDX-License-Identifier: MIT
"""What a study takes: rows of its stages; answers that do not repeat are named."""

import json

import pytest
from pliant.lab.bench import studying as bench
from pliant.lab.bench.command import main

CAFFEINE = "data/molecules/caffeine.sdf"


@pytest.fixture
def clock(monkeypatch):
    """A clock that goes on by a second, and half a second of processors, at each look."""
    looks = iter(range(1000))

    def now():
        look = next(looks)
        return float(look), look / 2

    monkeypatch.setattr(bench.Clock, "_now", staticmethod(now))


def test_a_stage_lasts_until_the_next_and_the_least_counts(clock):
    rows = {}
    first, second = bench.Clock(rows), bench.Clock(rows)
    first("sampling")
    second("sampling")
    second("PCA")
    first.stop()
    second.stop()
    second.stop()
    assert [(row.what, row.seconds, row.cpu_seconds) for row in rows.values()] == [
        ("sampling", 1.0, 0.5),
        ("PCA", 2.0, 1.0),
    ]


def test_other_answers_are_a_fault():
    found = bench.Studying("some.pdb", 4, 2)
    found.compare({"together": "2 domains", "flexible": "1 A", "page": "one"})
    found.compare({"together": "3 domains", "flexible": "1 A", "page": "other"})
    assert found.faults == ["together: not the same answer each time"]


def test_by_the_command(capsys):
    words = ["study", CAFFEINE, "--frames", "8"]
    assert main([*words, "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    stages = [row["what"] for row in found["rows"]]
    assert stages[:2] == ["the command", "sampling"]
    assert stages[-1] == "figures and page"
    assert all(row["cpu_seconds"] >= 0 for row in found["rows"])
    assert found["answers"]["molecule"].startswith("24 atoms")
