# SPDX-License-Identifier: MIT
"""Every analysis gives the same in this process and in two."""

import MDAnalysis
import numpy as np
import pliant.mdanalysis  # noqa: F401
import pytest
from MDAnalysis.analysis.base import AnalysisBase
from pliant.measure.frames import HAS_BACKENDS

from pliant import measure as analysis

pytestmark = pytest.mark.filterwarnings("ignore::UserWarning")


@pytest.fixture
def universe(tmp_path, pentane, wander, write_run):
    trajectory = wander(pentane, [(1, 2), (2, 3)], 21)
    return MDAnalysis.Universe(write_run(tmp_path / "run.h5md", pentane, trajectory))


MADE = {
    "BarResiduals": lambda u: analysis.BarResiduals(u),
    "RmsdToStart": lambda u: analysis.RmsdToStart(u.atoms, superpose_on=u.atoms[:3]),
    "Rmsf": lambda u: analysis.Rmsf(u.atoms, superpose_on=u.atoms[:4]),
    "RadiusOfGyration": lambda u: analysis.RadiusOfGyration(u.atoms, weights=None),
    "TorsionDistributions": lambda u: analysis.TorsionDistributions(
        u.atoms, bonds=[(0, 1), (1, 2), (2, 3), (3, 4)]
    ),
    "PrincipalComponents": lambda u: analysis.PrincipalComponents(u.atoms),
}


def test_every_analysis_is_tried_here():
    classes = {
        name
        for name in analysis.__all__
        if isinstance(getattr(analysis, name), type)
        and issubclass(getattr(analysis, name), AnalysisBase)
    }
    assert classes == set(MADE)


@pytest.mark.long
@pytest.mark.skipif(not HAS_BACKENDS, reason="MDAnalysis has one process before 2.8")
@pytest.mark.parametrize("name", MADE)
def test_two_processes_give_what_one_gives(universe, name):
    one = MADE[name](universe).run(step=2)
    two = MADE[name](universe).run(step=2, backend="multiprocessing", n_workers=2)
    assert set(one.results) == set(two.results)
    for key, expected in one.results.items():
        np.testing.assert_allclose(two.results[key], expected, rtol=1e-7, atol=1e-9, err_msg=key)
    np.testing.assert_array_equal(one.frames, two.frames)
    np.testing.assert_array_equal(one.times, two.times)


def test_a_second_run_starts_afresh(universe):
    again = MADE["BarResiduals"](universe)
    again.run(stop=3)
    assert len(again.run(stop=5).results.max_relative) == 5
