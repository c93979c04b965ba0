# SPDX-License-Identifier: MIT
"""Parts of an analysis: found by their types, and left out of the report where they are missing."""

import os
from dataclasses import replace

import numpy as np
import pytest
from pliant.analyse.analysis import AnalysisOptions
from pliant.analyse.figures import figures_of
from pliant.analyse.page.page_tables import tables
from pliant.analyse.parts import Components, RigidDomains, Rmsd, Torsions, Units
from pliant.analyse.stages import analyse_trajectory
from pliant.analysis.domains import Domains


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


def test_one_domain_alone_is_not_listed(analysis):
    def captions(domain):
        found = Domains(domain, 0.5, np.zeros((0, 2), dtype=int))
        return [one.caption for one in tables(analysis.having(RigidDomains(found, domain)))]

    one = np.zeros(len(analysis[Units].labels), dtype=int)
    two = np.where(np.arange(len(one)) < 2, 1, 0)
    text = "Domains that move as rigid bodies"
    assert text not in captions(one) and text in captions(two)
