# SPDX-License-Identifier: MIT
"""The table of sections of the report of one file, and the analysis that measures them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace

from MDAnalysis.exceptions import NoDataError

from pliant._core import OptionError
from pliant.base.beside import Beside
from pliant.measure.stages.analysis import Analysis, AnalysisOptions
from pliant.measure.stages.opened import opened
from pliant.measure.stages.parts import Part
from pliant.measure.stages.reference import reference_of
from pliant.measure.stages.units import units_of
from pliant.report.section import Columns
from pliant.report.sections.bars import BARS
from pliant.report.sections.contacts import CONTACTS, HELD_CONTACTS
from pliant.report.sections.domains import CORRELATIONS, DOMAINS
from pliant.report.sections.exports import MODES_FILE
from pliant.report.sections.flexible import AMPLITUDE, FLEXIBILITY
from pliant.report.sections.frames import DRAWS, KIND, frame_numbers
from pliant.report.sections.ligands import LIGAND_CONTACTS
from pliant.report.sections.measured import Measured
from pliant.report.sections.motions import COMPONENTS
from pliant.report.sections.other_shapes import OTHER_SHAPES
from pliant.report.sections.pockets import POCKET_VOLUMES
from pliant.report.sections.rmsf import RMSF
from pliant.report.sections.series import DISTANCES, GYRATION, RMSD
from pliant.report.sections.stereochemistry import STEREOCHEMISTRY
from pliant.report.sections.sweeps import SWEEPS
from pliant.report.sections.torsions import RAMACHANDRAN, TORSIONS

Stage = tuple[str, Callable[[Analysis], Iterable[Part]]]


def _per_frame(analysis: Analysis) -> Columns:
    """What sections measured of each frame."""
    shown = (row for row in SECTIONS if row.applies(analysis))
    columns = (row.per_frame(analysis).items() for row in shown)
    return frame_numbers(analysis) | {name: values for some in columns for name, values in some}


#: in the order in which they are measured, and shown under their headings
SECTIONS = (
    Measured(columns={"frames": _per_frame}),
    KIND,
    RMSF,
    COMPONENTS,
    FLEXIBILITY,
    AMPLITUDE,
    CORRELATIONS,
    DOMAINS,
    OTHER_SHAPES,
    POCKET_VOLUMES,
    LIGAND_CONTACTS,
    DISTANCES,
    RMSD,
    GYRATION,
    TORSIONS,
    RAMACHANDRAN,
    CONTACTS,
    HELD_CONTACTS,
    STEREOCHEMISTRY,
    BARS,
    SWEEPS,
    DRAWS,
    MODES_FILE,
)

STAGES = tuple((row.stage, row.measure) for row in SECTIONS if row.measure)
#: from this one on they need nothing of those before
FIRST_BESIDE = next(k for k, (name, _) in enumerate(STAGES) if name == DISTANCES.stage)


def analyse_trajectory(
    options: AnalysisOptions, on_stage: Callable[[str], None] = lambda name: None
) -> Analysis:
    """Opens the trajectory and measures all of it; calls `on_stage` with the name of each stage.

    Raises InputError (one line) when the file cannot be used, OptionError when the choice of atoms
    or frames is wrong or empty.
    """
    on_stage("reading")
    analysis = opened(options)
    analysis = analysis.having(reference_of(analysis)).having(units_of(analysis))
    if analysis.held is None:  # both processes would read from one place in a file
        return _measured(analysis, STAGES, on_stage)
    universe, rest = analysis.universe, STAGES[FIRST_BESIDE:]
    shared = (universe, universe.trajectory, analysis.source, analysis.held)
    with Beside(lambda: _found(analysis, rest), shared) as beside:
        first = _measured(analysis, STAGES[:FIRST_BESIDE], on_stage)
        if found := beside.result():
            for name, _ in rest:
                on_stage(name)
            parts, skipped = found
            return replace(
                first, parts={**first.parts, **parts}, skipped={**first.skipped, **skipped}
            )
    return _measured(first, rest, on_stage)


def _found(
    analysis: Analysis, stages: Sequence[Stage]
) -> tuple[Mapping[type[Part], Part], Mapping[str, str]]:
    """Parts and what is skipped, in a process of its own."""
    analysis.source.close()  # it is opened again there
    found = _measured(analysis, stages)
    return found.parts, found.skipped


def _measured(
    analysis: Analysis, stages: Sequence[Stage], on_stage: Callable[[str], None] = lambda name: None
) -> Analysis:
    """The analysis with what some stages found, or why they found nothing."""
    for name, measure in stages:
        on_stage(name)
        try:
            for part in measure(analysis):
                analysis = analysis.having(part)
        except OptionError:  # which is a ValueError, but the user's
            raise
        except (ValueError, NoDataError) as error:
            why = " ".join(str(error).split())
            analysis = replace(analysis, skipped={**analysis.skipped, name: why})
    return analysis
