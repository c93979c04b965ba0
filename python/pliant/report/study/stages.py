# SPDX-License-Identifier: MIT
"""What a study does once its ensemble is there: path, analyse, representatives, check, page."""

from __future__ import annotations

import os
import time
import warnings
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from pliant._core import Error, PathOptions
from pliant.base.extras import MissingPackageError, late, need
from pliant.base.said import noted
from pliant.jobs.fit.molecule import FRAMES
from pliant.jobs.fit.task import FitTask
from pliant.jobs.path import walk
from pliant.measure.shapes.representatives import Representatives, medoids
from pliant.measure.stages.analysis import AnalysisOptions
from pliant.report.multi_model import write_chosen
from pliant.report.page.additions import Additions
from pliant.report.representatives import REMARK
from pliant.report.save import drawing_of
from pliant.report.sections.table import analyse_trajectory
from pliant.report.study.answers import answers
from pliant.report.study.data_fit import DataFit
from pliant.report.study.sections import additions, early_sections, sections
from pliant.report.study.studied import Sampled, Study
from pliant.report.suite import DPI, AnalysisReport
from pliant.report.write import finish_report, report_of

# They take a tenth of a second to import, for a check that may not be asked for.
minimise, checks = map(late, ("pliant.checks.force_field.minimise", "pliant.report.check.suite"))

#: frames that stand for all, for docking or to look at
REPRESENTATIVES = 20


@dataclass(frozen=True)
class StudyTask:
    """The stages after sampling, in their order."""

    file: str | os.PathLike[str]
    end: str | os.PathLike[str] | None
    folder: Path
    seed: int
    asked: dict[str, Any]  #: of the molecule
    fit: FitTask | None  #: to measured data
    check: bool
    force_field: dict[str, Any]  #: how the check gives parameters to ligands, and where it computes
    quiet: bool

    def studied(self, ensemble: Sampled, on_stage: Callable[[str], None]) -> Study:
        """All of them."""
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # sampling has said what there was to say
            report = AnalysisReport(
                analyse_trajectory(AnalysisOptions(str(ensemble.ensemble)), on_stage)
            )
            found = Study(os.fspath(self.file), self.folder, ensemble, report)
            self._fit(found, on_stage)
            begun = Additions(sections=[*early_sections(found)])
            with drawing_of(report_of(report.analysis, begun), self.folder, DPI) as drawing:
                self._answer(found, on_stage)
                on_stage("figures and page")
                more = report.more
                report.outputs = finish_report(report.analysis, self.folder, drawing, more)
        return found

    def _answer(self, found: Study, on_stage: Callable[[str], None]) -> None:
        """What the report has besides that of an analysis."""
        self._path(found, on_stage)
        on_stage("representatives")
        found.representatives = self._representatives(found)
        self._check(found, on_stage)
        found.report.more = Additions(sections=[*sections(found)])
        found.answered = answers(found)
        found.report.more = additions(found)

    def _fit(self, found: Study, on_stage: Callable[[str], None]) -> None:
        """To data, from the frames that are there: as `pliant fit` makes them, if they are."""
        if self.fit is None:
            return
        on_stage("fit to the data")
        facts, begun = found.sampled.facts, time.perf_counter()
        are_usual = facts["sampler"] == "reach" and facts["frames"] >= FRAMES
        with noted() as said:
            self.fit.molecule.sampled(found.sampled.ensemble if are_usual else FRAMES)
            found.fit = DataFit.of(self.fit)
        facts["warnings"] += said
        found.fit.found.seconds = time.perf_counter() - begun
        output = self.folder / "fitted.pdb"
        found.fit.found.save(output, overwrite=True)
        found.outputs["fitted"] = output

    def _path(self, found: Study, on_stage: Callable[[str], None]) -> None:
        if self.end is None:
            return
        on_stage("path")
        output = self.folder / "path.h5md"
        options = PathOptions(seed=self.seed, **self.asked)
        ends = options.start_of(self.file), options.end_of(self.end)
        found.path = walk.find(*ends, options, output, overwrite=True)
        found.end = Path(self.end).name
        found.outputs["path"] = output

    def _representatives(self, found: Study) -> Representatives:
        output = self.folder / "representatives.pdb"
        analysis = replace(found.report.analysis, parts={})  # nor what was noted of them
        chosen, places = medoids(analysis, min(REPRESENTATIVES, len(analysis.frames)))
        write_chosen(analysis, places, output, REMARK)
        found.outputs["representatives"] = output
        return replace(chosen, output=str(output))

    def _check(self, found: Study, on_stage: Callable[[str], None]) -> None:
        path = str(found.sampled.ensemble)
        found.why_no_check = minimise.why_not_file(path) if self.check else "--no-check"
        if found.why_no_check:
            return
        on_stage("MD starts")
        try:
            need("the check of MD starts", "openmm")
            found.check = checks.check(path, quiet=self.quiet, **self.force_field)
        except (MissingPackageError, Error) as error:
            found.why_no_check = str(error)
