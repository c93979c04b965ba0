# SPDX-License-Identifier: MIT
"""A study from its options: what they may be, its ensemble, and the stages after it."""

from __future__ import annotations

import contextlib
import importlib
import os
import subprocess
import threading
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from pliant._core import DensityMap, Error, InputError, OptionError, PathOptions, path_rows
from pliant.adapters.smiles import embedded
from pliant.base.checked import SEED, checked, whole
from pliant.base.extras import need
from pliant.base.force_field_options import ONE_OF_CHARGES
from pliant.base.new_file import check_folder
from pliant.base.progress import Stages
from pliant.base.said import noted
from pliant.jobs.fit.task import FitTask
from pliant.jobs.process import job_options, molecule_rows, run_job
from pliant.report.study.studied import Sampled, Study

#: how many there are: the bar of a call has room for so many
STAGES = 21


@checked(frames=whole(4), seed=SEED, charges=ONE_OF_CHARGES)
def study(
    file: str | os.PathLike[str] | None = None,
    end: str | os.PathLike[str] | None = None,
    output: str | os.PathLike[str] | None = None,
    *,
    distances: str | os.PathLike[str] | Sequence[Mapping[str, Any]] | None = None,
    map: str | os.PathLike[str] | DensityMap | None = None,
    resolution: float | None = None,
    half: str | os.PathLike[str] | DensityMap | None = None,
    place: bool = False,
    smiles: str | None = None,
    frames: int | None = None,
    seed: int = 0,
    check: bool = True,
    charges: str = "am1-bcc",
    ligands: Mapping[str, str] | None = None,
    platform: str = "auto",
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
    distances, map, resolution, half, place
        Data as ``fit`` takes them: the page says whether the molecule agrees with them, and the
        fitted structure is written.
    smiles : str, optional
        Instead of a file: a molecule that RDKit makes, see ``from_smiles``.
    frames : int, optional
        Frames of the ensemble, at least 4. Default: as ``pliant sample``.
    seed : int
        Of the ensemble and the path.
    check : bool
        Whether OpenMM, where it is installed, minimises a few frames of a protein.
    charges, ligands, platform
        Of that check, as `check` takes them.
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
    with noted() as guessed:
        data = {"density": map, "resolution": resolution, "half": half, "place": place}
        fit = _fit_task(file, {"distances": distances, **data}, seed, asked)
        if file is None:
            file = _embedded(str(smiles), folder, seed)
    sample = {"input": os.fspath(file), "seed": seed, "frames": frames, **asked}
    task: dict[str, Any] = {"file": file, "end": end, "folder": folder, "seed": seed}
    task |= {"asked": asked, "fit": fit, "check": check, "quiet": quiet}
    task["force_field"] = {"charges": charges, "ligands": ligands, "platform": platform}
    if on_stage is not None:
        return _studied(sample, guessed, task, on_stage)
    with Stages("studying", STAGES) as stages:
        return _studied(sample, guessed, task, stages)


def _studied(
    sample: dict[str, Any],
    guessed: list[str],
    task: dict[str, Any],
    on_stage: Callable[[str], None],
) -> Study:
    on_stage("sampling")
    ensemble = _sampled(task["folder"], sample)
    ensemble.facts["warnings"] = [*dict.fromkeys([*guessed, *ensemble.facts["warnings"]])]
    found: Study = _imported().StudyTask(**task).studied(ensemble, on_stage)
    return found


def _sampled(folder: Path, sample: dict[str, Any]) -> Sampled:
    """Samples into folder/ensemble.h5md, replacing what is there."""
    ensemble = folder / "ensemble.h5md"
    job = {"task": "sample", "output": str(ensemble), "overwrite": True, **sample}
    folder.mkdir(parents=True, exist_ok=True)
    try:
        return Sampled(run_job(job, talk=_talk), ensemble)
    except Error:
        with contextlib.suppress(OSError):  # it holds an earlier study
            folder.rmdir()
        raise


def _talk(process: subprocess.Popen[bytes], text: bytes) -> bytes:
    """What the process prints. Meanwhile what comes after it is imported."""
    beside = threading.Thread(target=_try_to_import)
    beside.start()
    try:
        return process.communicate(text)[0]
    finally:
        beside.join()


def _try_to_import() -> None:
    with contextlib.suppress(Exception):  # who uses it says what is wrong
        _imported()


def _imported() -> Any:
    """The stages after sampling, whose packages take a second and more to import."""
    return importlib.import_module("pliant.report.study.stages")


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
    if end is not None:
        _refuse_other_than_of_path(options, "END: pliant path")
    return options


def _refuse_other_than_of_path(options: dict[str, Any], what: str) -> None:
    alone = [name for name in options if name not in {row["name"] for row in path_rows()}]
    if alone:
        raise OptionError(f"{alone[0]}: does not go with {what} does not take it")


def _fit_task(
    file: str | os.PathLike[str] | None, data: dict[str, Any], seed: int, asked: dict[str, Any]
) -> FitTask | None:
    """Reads data and molecule, so that what is wrong is said at once; None without data."""
    if all(value in (None, False) for value in data.values()):
        return None
    if file is None:
        raise OptionError("distances, map: need FILE, a protein or nucleic acid")
    _refuse_other_than_of_path(asked, "data: pliant fit")
    return FitTask.of(file, seed=seed, options=PathOptions(**asked), **data)
