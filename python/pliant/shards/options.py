# SPDX-License-Identifier: MIT
"""The options of ``pliant run`` and ``pliant sample`` that an ensemble passes on to its shards."""

from __future__ import annotations

import argparse
import json
import os
from collections.abc import Collection
from typing import Any, NoReturn

from pliant._core import OptionError, job_rows
from pliant.base import console

#: Options by their names, as a job has them.
Options = dict[str, Any]

#: What the ensemble decides for each shard, or what no ensemble can do, with what to do instead.
_REFUSED = {
    "threads": "--workers says how many processes share the shards",
    "topology": "each shard holds its topology",
    "overwrite": "give another folder, or remove this one",
    "continue": "the same command again goes on",
    "record_forces": "use it with pliant run itself",
    "imd": "use it with pliant run itself",
    "dry_run": "try the options with that command itself",
}


class _Refusal(argparse.Action):
    def __call__(self, *_: object) -> NoReturn:
        raise OptionError(f"{self.option_strings[0]}: is not passed on to pliant {self.const}")


def add_options(
    parser: argparse.ArgumentParser, task: str, own: Collection[str]
) -> list[dict[str, Any]]:
    """Adds the options of a task but those that are the ensemble's `own`; returns their rows."""
    for name, why in _REFUSED.items():
        parser.add_argument(flag_of(name), action=_Refusal, nargs="*", const=f"{task}: {why}")
    rows = [row for row in job_rows(task) if row["name"] not in {*own, *_REFUSED}]
    console.add_rows(parser, rows)
    return rows


def files_among(task: str, options: Options) -> list[str]:
    """The options whose values are files: shards read them by absolute paths, and bytes count."""
    rows = [row for row in job_rows(task) if row.get("is_file") or "FILE" in row["kind"]]
    return [row["name"] for row in rows if os.path.isfile(options.get(row["name"], ""))]


def flag_of(name: str) -> str:
    """ "--hbond-cutoff" of "hbond_cutoff"."""
    return "--" + name.replace("_", "-")


def text_of(name: str, options: Options) -> str:
    """An option as a message shows it: "--steps 1000", "no --steps"."""
    if name not in options:
        return f"no {flag_of(name)}"
    value = options[name]
    return f"{flag_of(name)} {value if isinstance(value, str) else json.dumps(value)}"
