# SPDX-License-Identifier: MIT
"""Runs every stage of an analysis that a trajectory allows."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import TYPE_CHECKING

from MDAnalysis.exceptions import NoDataError

from pliant._core import OptionError
from pliant.measure.pockets.pocket_volumes import pocket_volumes
from pliant.measure.shapes.other_shapes import other_shapes
from pliant.measure.stages import biology, motion
from pliant.measure.stages.opened import opened
from pliant.measure.stages.reference import reference_of
from pliant.measure.stages.runner import Runner
from pliant.measure.stages.units import units_of

if TYPE_CHECKING:
    from pliant.measure.stages.analysis import Analysis, AnalysisOptions
    from pliant.measure.stages.parts import Part


def analyse_trajectory(
    options: AnalysisOptions, on_stage: Callable[[str], None] = lambda name: None
) -> Analysis:
    """Opens the trajectory and runs all stages; calls `on_stage` with the name of each first.

    Raises InputError (one line) when the file cannot be used, OptionError when the choice of atoms
    or frames is wrong or empty.
    """
    on_stage("reading")
    analysis = opened(options)
    analysis = analysis.having(reference_of(analysis)).having(units_of(analysis))
    runner = Runner(analysis)
    for name, stage in STAGES.items():
        on_stage(name)
        try:
            for part in stage(analysis, runner):
                analysis = analysis.having(part)
        except OptionError:  # which is a ValueError, but the user's
            raise
        except (ValueError, NoDataError) as error:
            why = " ".join(str(error).split())
            analysis = replace(analysis, skipped={**analysis.skipped, name: why})
    return analysis


#: in the order of running: what is left out goes by these names. A stage returns its parts, or
#: raises ValueError with the reason why there are none.
STAGES: dict[str, Callable[[Analysis, Runner], Iterable[Part]]] = {
    "bar residuals": motion.bar_residuals,
    "sweeps": motion.sweeps,
    "RMSD": motion.rmsd,
    "RMSF": motion.fluctuations,
    "radius of gyration": motion.radius_of_gyration,
    "torsions": motion.torsions,
    "PCA": motion.principal_components,
    "flexibility": biology.flexibility_of_units,
    "stereochemistry": biology.stereochemistry,
    "contacts": biology.contacts,
    "distances": biology.distances,
    "shapes": other_shapes,
    "pockets": pocket_volumes,
}
