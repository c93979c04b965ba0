# SPDX-License-Identifier: MIT
"""Jobs in processes of their own: options go in as JSON, a summary or an error comes out."""

from __future__ import annotations

import inspect
import json
import os
import subprocess
from collections.abc import Callable, Iterable, Mapping
from typing import Any

from pliant._core import Error, FileError, InputError, OptionError, job_rows
from pliant.base import console
from pliant.base.refusals import refuse_unknown

_DONE = (0, 3)  #: exit codes of a job that has written all that it could
_REFUSED = (1, 2)
_PIPE = subprocess.PIPE
_ERRORS = {"OptionError": OptionError, "FileError": FileError, "InputError": InputError}

#: Gives a process its input, and returns what it prints.
Talk = Callable[[subprocess.Popen[bytes], bytes], bytes]


class JobEndedError(Error):
    """A job that ended without a summary or an error, as if killed: its task and exit code."""

    def __str__(self) -> str:
        return "pliant {} ended with {}".format(*self.args)


def _talk(process: subprocess.Popen[bytes], text: bytes) -> bytes:
    return process.communicate(text)[0]


def run_job(job: Mapping[str, Any], *flags: str, talk: Talk = _talk, **how: Any) -> dict[str, Any]:
    """Does a job: `task`, `input` and options by their names. Returns its summary.

    Frames go to the file one by one, however large the molecule. A progress bar is drawn where
    stderr is a terminal. `how` is for Popen. Raises OptionError, InputError or FileError with what
    the job says, JobEndedError where it says nothing.
    """
    words = [console.command_path(), job["task"], "--job", "-", "--json", *flags]
    with subprocess.Popen(words, stdin=_PIPE, stdout=_PIPE, **how) as process:
        try:
            out = talk(process, json.dumps(console.plain(job)).encode())
        except BaseException:
            process.kill()
            raise
    if process.returncode in _DONE:
        summary: dict[str, Any] = json.loads(out or b"{}")  # a dry run says nothing
        return summary
    if process.returncode in _REFUSED and out:
        error = json.loads(out)["error"]
        raise _ERRORS[error["kind"]](error["text"])
    raise JobEndedError(job["task"], process.returncode)


def molecule_rows() -> list[dict[str, Any]]:
    """Rows of what a molecule is read and prepared by."""
    return [row for row in job_rows("sample") if row["group"] in ("Molecule", "Model")]


def job_options(
    function: Callable[..., Any], rows: Iterable[Mapping[str, Any]], given: Mapping[str, Any]
) -> dict[str, Any]:
    """Further keywords of a function as a job has them. Raises TypeError for one without a row."""
    types = {row["name"]: row["type"] for row in rows}
    refuse_unknown(function.__name__, [*inspect.signature(function).parameters, *types], given)

    def taken(name: str, value: Any) -> Any:
        if types[name] == "str" and isinstance(value, (int, os.PathLike)):
            return str(value)
        is_names = types[name].endswith("Sequence[str]")
        return console.words(value) if is_names and isinstance(value, str) else value

    return {name: taken(name, value) for name, value in given.items() if value is not None}
