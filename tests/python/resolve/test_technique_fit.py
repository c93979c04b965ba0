# SPDX-License-Identifier: MIT
"""Techniques that do not do what is asked say so before they resolve anything."""

from __future__ import annotations

import warnings
from typing import Any

import pytest
from real_files import ROOT

import pliant

STEPS, SWEEPS = 10, 3000

NAMES = [row.name for row in pliant.techniques()]


@pytest.fixture(params=["aspirin.sdf", "adamantane.mol"])
def structure(request: pytest.FixtureRequest) -> Any:
    return pliant.read(ROOT / "data" / "molecules" / request.param)


@pytest.mark.filterwarnings("ignore::pliant.PliantWarning")
@pytest.mark.parametrize("name", NAMES)
def test_a_technique_converges_under_angles_or_was_announced(name: str, structure: Any) -> None:
    framework = structure.framework("angles")
    fit, why = {row[0]: row[1:] for row in pliant.techniques_for(framework)}[name]
    if fit == "refused":
        with pytest.raises(pliant.OptionError) as caught:
            pliant.Motion(framework, structure.positions, technique=name)
        assert str(caught.value) == why
        return
    motion = pliant.Motion(framework, structure.positions, technique=name, max_sweeps=SWEEPS)
    unconverged = sum(not motion.step().converged for _ in range(STEPS))
    if fit == "fits":
        assert unconverged == 0
        assert why == ""
    else:
        assert "use auto, which takes units" in why


def test_the_warning_names_the_reason_and_what_to_take(structure: Any) -> None:
    framework = structure.framework("angles")
    said = (
        "technique = bfs_cycle: goes from bar to bar, which does not converge or is slow where "
        "bars form rigid units (angles); use auto, which takes units"
    )
    assert pliant.techniques_for(framework)[NAMES.index("bfs_cycle")][2] == said
    with pytest.warns(pliant.PliantWarning) as caught:
        pliant.resolve(framework, structure.positions.copy(), technique="bfs_cycle", max_sweeps=1)
    assert [str(one.message) for one in caught] == [said]
    with pytest.warns(pliant.PliantWarning) as caught:
        pliant.Motion(framework, structure.positions, technique="bfs_cycle")
    assert [str(one.message) for one in caught] == [said]


def test_nothing_is_said_of_bonds_alone(structure: Any) -> None:
    framework = structure.framework("bonds")
    assert {row[1] for row in pliant.techniques_for(framework) if "tree" not in row[2]} == {"fits"}
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        pliant.resolve(framework, structure.positions.copy(), technique="bfs_cycle")


@pytest.mark.filterwarnings("ignore::pliant.PliantWarning")
def test_of_a_protein_model_most_are_doubtful_or_refused() -> None:
    files = pytest.importorskip("MDAnalysisTests.datafiles")
    model = pliant.build_model(pliant.read(files.PDB_small), "protein")
    fits = {name: fit for name, fit, _ in pliant.techniques_for(model.framework)}
    for row in pliant.techniques():
        if row.name in ("auto", "froda"):
            assert fits[row.name] == "fits"
        elif row.name in ("blocks", "newton", "shake", "units"):
            assert fits[row.name] == "refused"
        else:
            assert fits[row.name] == ("refused" if row.forests_only else "doubtful"), row.name
