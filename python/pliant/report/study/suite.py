# SPDX-License-Identifier: MIT
"""The stages of a study: sample, path, analyse, representatives, check, page."""

from __future__ import annotations

import contextlib
import os
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pliant._core import Error, InputError, OptionError, PathOptions, path_rows
from pliant.adapters.smiles import embedded
from pliant.base.checked import SEED, checked, whole
from pliant.base.extras import MissingPackageError, need
from pliant.base.progress import Stages
from pliant.base.said import noted
from pliant.checks.force_field.minimise import why_not_file
from pliant.jobs.path import walk
from pliant.jobs.process import job_options, molecule_rows, run_job
from pliant.measure.stages.analysis import AnalysisOptions
from pliant.report.check.suite import check as check_frames
from pliant.report.page.additions import Additions
from pliant.report.representatives import representatives
from pliant.report.sections.table import STAGES, analyse_trajectory
from pliant.report.study.answers import answers
from pliant.report.study.sections import additions, sections
from pliant.report.study.studied import Sampled, Study
from pliant.report.suite import DPI, AnalysisReport
from pliant.report.write import check_folder, write_report

if TYPE_CHECKING:
    from pliant.measure.shapes.representatives import Representatives

#: frames that stand for all, for docking or to look at
REPRESENTATIVES = 20


@checked(frames=whole(4), seed=SEED)
def study(
    file: str | os.PathLike[str] | None = None,
    end: str | os.PathLike[str] | None = None,
    output: str | os.PathLike[str] | None = None,
    *,
    smiles: str | None = None,
    frames: int | None = None,
    seed: int = 0,
    check: bool = True,
    overwrite: bool = False,
    quiet: bool = True,
    on_stage: Callable[[str], None] | None = None,
    **options: Any,
) -> Study:
    """Studies a molecule: which parts are flexible, what moves together, what else it looks like.

    Does what ``pliant sample``, ``path``, ``analyse``, ``representatives`` and ``check`` do by
    default, into one folder with one page. Of a molecule without residues, conformers are studied.

    Parameters
    ----------
    file : str or path, optional
        PDB, mmCIF, XYZ or SDF file.
    end : str or path, optional
        Another structure of the same molecule, PDB or mmCIF: a path to it is found as well.
    output : str or path, optional
        Folder for the results. Default: the file's name with ``-study``, in the current folder.
    smiles : str, optional
        Instead of a file: a molecule that RDKit makes, see ``from_smiles``.
    frames : int, optional
        Frames of the ensemble, at least 4. Default: as ``pliant sample``.
    seed : int
        Of the ensemble and the path.
    check : bool
        Whether OpenMM, where it is installed, minimises a few frames of a protein.
    overwrite : bool
        Replace the results of an earlier study.
    quiet : bool
        Show no progress of the check.
    on_stage : callable, optional
        Called with the name of each stage as it begins. Default: a progress bar in notebooks and on
        terminals.
    **options
        How the molecule is read and prepared: the options of ``pliant sample`` under Molecule and
        Model by their names, as ``select="protein"`` and ``keep=["GOL"]``. With `end` those of
        ``path`` alone.

    Raises
    ------
    ImportError
        MDAnalysis, matplotlib or SciPy is not installed; the message says how to install them.
    InputError
        A file cannot be used, or the results are there already; the message says why.
    OptionError
        An option is out of range.
    """
    need("pliant.study", "MDAnalysis", "matplotlib", "scipy", extra="analysis")
    if (file is None) == (smiles is None):
        raise OptionError("FILE, --smiles: expected one of the two")
    asked = _molecule_options(options, end)
    folder = Path(output) if output is not None else Path(f"{_stem(file)}-study")
    _check_output(folder, overwrite)
    guessed: list[str] = []
    if file is None:
        with noted() as guessed:
            file = _embedded(str(smiles), folder, seed)
    task = _Task(file, end, folder, seed, frames, asked, check, quiet, tuple(guessed))
    if on_stage is not None:
        return task.studied(on_stage)
    with Stages("studying", 6 + len(STAGES)) as stages:
        return task.studied(stages)


def _embedded(smiles: str, folder: Path, seed: int) -> Path:
    """Writes the molecule into the folder."""
    from rdkit.Chem import MolToMolFile

    molecule = embedded(smiles, seed % 2**31)
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / "molecule.sdf"
    MolToMolFile(molecule, str(file))
    return file


def _stem(file: str | os.PathLike[str] | None) -> str:
    """ "4e43" of "4e43.pdb.gz"."""
    if file is None:
        return "smiles"
    return Path(file).name.removesuffix(".gz").removesuffix(".bz2").rpartition(".")[0] or "molecule"


def _check_output(folder: Path, overwrite: bool) -> None:
    check_folder(folder)
    ensemble = folder / "ensemble.h5md"
    if ensemble.exists() and not overwrite:
        raise InputError(f"{ensemble}: exists; --overwrite replaces it")


def _molecule_options(given: dict[str, Any], end: object) -> dict[str, Any]:
    """Raises OptionError for one that a path does not take, where there is to be one."""
    options = job_options(study, molecule_rows(), given)
    alone = [name for name in options if name not in {row["name"] for row in path_rows()}]
    if end is not None and alone:
        raise OptionError(f"{alone[0]}: does not go with END: pliant path does not take it")
    return options


@dataclass(frozen=True)
class _Task:
    """The stages, in their order."""

    file: str | os.PathLike[str]
    end: str | os.PathLike[str] | None
    folder: Path
    seed: int
    frames: int | None
    asked: dict[str, Any]  #: of the molecule
    check: bool
    quiet: bool
    guessed: tuple[str, ...] = ()  #: of a SMILES

    def studied(self, on_stage: Callable[[str], None]) -> Study:
        on_stage("sampling")
        self.folder.mkdir(parents=True, exist_ok=True)
        try:
            ensemble = self._sampled()
        except Error:
            with contextlib.suppress(OSError):  # it holds an earlier study
                self.folder.rmdir()
            raise
        ensemble.facts["warnings"] = [*self.guessed, *ensemble.facts["warnings"]]
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # `sampled` has said what there was to say
            report = AnalysisReport(
                analyse_trajectory(AnalysisOptions(str(ensemble.ensemble)), on_stage)
            )
            found = Study(os.fspath(self.file), self.folder, ensemble, report)
            self._path(found, on_stage)
            on_stage("representatives")
            found.representatives = self._representatives(found)
            self._check(found, on_stage)
            report.more = Additions(sections=[*sections(found)])
            found.answers = answers(found)
            report.more = additions(found)
            on_stage("figures and page")
            report.outputs = write_report(report.analysis, self.folder, DPI, report.more)
        return found

    def _sampled(self) -> Sampled:
        """Samples into folder/ensemble.h5md, replacing what is there."""
        ensemble = self.folder / "ensemble.h5md"
        files = {"input": os.fspath(self.file), "output": str(ensemble), "overwrite": True}
        drawn = {"seed": self.seed, "frames": self.frames, **self.asked}
        return Sampled(run_job({"task": "sample", **files, **drawn}), ensemble)

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

    def _representatives(self, found: Study) -> Representatives | None:
        output, count = self.folder / "representatives.pdb", len(found.report.analysis.frames)
        try:
            chosen = representatives(
                found.sampled.ensemble, min(REPRESENTATIVES, count), output, overwrite=True
            )
        except OptionError:
            return None
        found.outputs["representatives"] = output
        return chosen

    def _check(self, found: Study, on_stage: Callable[[str], None]) -> None:
        path = str(found.sampled.ensemble)
        found.why_no_check = why_not_file(path) if self.check else "--no-check"
        if found.why_no_check:
            return
        on_stage("MD starts")
        try:
            need("the check of MD starts", "openmm")
            found.check = check_frames(path, quiet=self.quiet)
        except (MissingPackageError, Error) as error:
            found.why_no_check = str(error)
