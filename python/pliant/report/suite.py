# SPDX-License-Identifier: MIT
"""The whole analysis of one trajectory, and the report that holds it."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import MDAnalysis  # noqa: F401  (before pliant.measure, which says that it lacks MDAnalysis itself)

from pliant.base.checked import NOT_ZERO, PAIRS_OF_TEXTS, checked, whole
from pliant.base.console import MOST_PROCESSES, printable_name
from pliant.base.display import Displayed, Facts
from pliant.base.new_file import check_folder
from pliant.base.progress import Stages
from pliant.base.verdict import Verdict, verdict_of_all
from pliant.measure.shapes.representatives import medoids
from pliant.measure.stages.analysis import Analysis, AnalysisOptions
from pliant.report.multi_model import write_chosen
from pliant.report.page.additions import NOTHING, Additions
from pliant.report.representatives import REMARK
from pliant.report.sections.table import STAGES, analyse_trajectory
from pliant.report.write import report_of, write_report
from pliant.trajectory.files import file_of
from pliant.trajectory.sources import Molecule
from pliant.trajectory.trajectory import HasFrames

DPI = 150


@dataclass
class AnalysisReport(Displayed):
    """What `analyse` found."""

    analysis: Analysis  #: the results, as arrays
    #: paths of the files, if any were written
    outputs: dict[str, Any] = field(default_factory=dict)
    #: where frames from memory are, as long as they may be read
    folder: tempfile.TemporaryDirectory[str] | None = field(default=None, repr=False)

    #: what a report of these frames has besides, such as whether MD can be started from them
    more: Additions = NOTHING

    @property
    def verdict(self) -> Verdict:
        """What to believe of the whole: made from all `verdicts`."""
        return verdict_of_all(self.verdicts.values())

    @property
    def verdicts(self) -> dict[str, Verdict]:
        """The answer to each question: its name in the JSON -> the answer."""
        return report_of(self.analysis, self.more).verdicts

    def facts(self) -> Facts:
        """The verdict, and what was found in some lines; the rest is in the report and the JSON."""
        analysis, report = self.analysis, report_of(self.analysis, self.more)
        frames = f"{len(analysis.frames)}, of {len(analysis.atoms)} atoms"
        judged = verdict_of_all(report.verdicts.values())
        head = [("verdict", judged.sentence), ("file", printable_name(analysis.options.path))]
        files = {"represent all": "representatives", "report": "report"}
        made = [
            (what, printable_name(self.outputs[name]))
            for what, name in files.items()
            if name in self.outputs
        ]
        return [*head, ("frames", frames), *report.labelled(), *made]

    def as_json(self) -> dict[str, Any]:
        """What it comes down to, as one JSON object."""
        analysis, report = self.analysis, report_of(self.analysis, self.more)
        made = report.verdicts
        judged = verdict_of_all(made.values())
        return {
            "verdict": judged.kind,
            "verdict_text": judged.sentence,
            "input": analysis.options.path,
            "atoms": len(analysis.universe.atoms),
            "atoms_analysed": len(analysis.atoms),
            "superposed_on": analysis.fitted_name,
            "frames": len(analysis.frames),
            "first_frame": int(analysis.frames[0]),
            "last_frame": int(analysis.frames[-1]),
            "frames_are": analysis.kind,
            "judgement": judged.kind,
            "judgement_text": judged.sentence,
            "verdicts": {name: {"kind": v.kind, "text": v.sentence} for name, v in made.items()},
            **report.values,
            "skipped": dict(analysis.skipped),
            "notes": analysis.notes,
            "outputs": self.outputs,
        }


@checked(
    step=NOT_ZERO,
    workers=whole(1, MOST_PROCESSES),
    representatives=whole(1),
    dpi=whole(50, 1200),
    distances=PAIRS_OF_TEXTS,
)
def analyse(
    path: str | os.PathLike[str] | HasFrames | Molecule,
    output: str | os.PathLike[str] | None = None,
    *,
    topology: str | os.PathLike[str] | None = None,
    select: str = "all",
    superpose: str | None = None,
    mass_weighted: bool = False,
    reference: str | os.PathLike[str] | None = None,
    distances: Sequence[tuple[str, str]] = (),
    start: int | None = None,
    stop: int | None = None,
    step: int | None = None,
    workers: int = 1,
    representatives: int | None = None,
    dpi: int = DPI,
    on_stage: Callable[[str], None] | None = None,
) -> AnalysisReport:
    """Analyses a trajectory; writes figures, tables and a report page into a folder.

    Finds how flexible each residue is, with an error; which parts move together; collective
    motions; other shapes in an ensemble of sampler ``reach``; contacts kept and lost; whether
    stereochemistry holds; RMSD, radius of gyration and torsions. Measures every bar of every frame.
    What cannot be computed from a file is left out; `report.analysis.skipped` says why.

    Parameters
    ----------
    path : str or path, SampledEnsemble, RunResult, MolecularPath, Trajectory, Universe, ...
        H5MD file of ``pliant run``, ``sample`` or ``path``, or any trajectory that MDAnalysis
        reads; or what has frames.
    output : str or path, optional
        Folder for figures (PNG), tables (CSV) and report.html; files of an earlier report are
        replaced.
    topology : str or path, optional
        File with atoms and bonds, where `path` holds none.
    select : str
        MDAnalysis selection: which atoms are analysed.
    superpose : str, optional
        Atoms to superpose, also used for the PCA. Default: CA and P atoms if they form chains,
        else all but hydrogens.
    mass_weighted : bool
        Weigh the PCA by mass.
    reference : str or path, optional
        Structure to compare frames with, of the same atoms. Default: the PDB that ``pliant run``
        and ``sample`` write beside their trajectory, else the first frame.
    distances : sequence of (str, str)
        Pairs of MDAnalysis selections whose centres' distance is measured.
    start, stop, step : int, optional
        Which frames, as in a slice.
    workers : int
        Number of processes.
    representatives : int, optional
        Write so many frames that stand for all others as representatives.pdb: see
        ``representatives``.
    dpi : int
        Resolution of the figures, dots per inch.
    on_stage : callable
        Called with the name of each stage as it begins. Default: a progress bar in notebooks and on
        terminals.

    Raises
    ------
    ImportError
        MDAnalysis or matplotlib is not installed; the message says how to install it.
    InputError
        The file cannot be used; the message says why.
    OptionError
        The choice of atoms or frames is wrong or empty.
    """
    if output is not None:
        check_folder(Path(output))
    path, folder = file_of(path, "analyse")
    options = AnalysisOptions(
        os.fspath(path),
        None if topology is None else os.fspath(topology),
        select,
        superpose,
        mass_weighted,
        start,
        stop,
        step,
        workers,
        None if reference is None else os.fspath(reference),
        tuple((str(a), str(b)) for a, b in distances),
    )
    if on_stage is not None:
        return _analysed(options, output, representatives, dpi, on_stage, folder)
    with Stages("analysing", 2 + len(STAGES)) as stages:
        return _analysed(options, output, representatives, dpi, stages, folder)


def _analysed(
    options: AnalysisOptions,
    output: str | os.PathLike[str] | None,
    representatives: int | None,
    dpi: int,
    on_stage: Callable[[str], None],
    folder: tempfile.TemporaryDirectory[str] | None,
) -> AnalysisReport:
    analysis = analyse_trajectory(options, on_stage)
    if output is None:
        return AnalysisReport(analysis, folder=folder)
    more, models = NOTHING, Path(output) / "representatives.pdb"
    if representatives is not None:
        chosen = medoids(analysis, representatives)[1]
        models.parent.mkdir(parents=True, exist_ok=True)
        write_chosen(analysis, chosen, models, REMARK)
        more = Additions(files=[models], models=[models])
    on_stage("figures and page")
    outputs = write_report(analysis, Path(output), dpi, more)
    if more.models:
        outputs["representatives"] = str(models)
    return AnalysisReport(analysis, outputs, folder)
