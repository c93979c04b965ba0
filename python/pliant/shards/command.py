# SPDX-License-Identifier: MIT
"""The subcommand ``pliant ensemble``: an ensemble in shards, on the cores of many machines."""

from __future__ import annotations

import argparse
import contextlib
import sys
import time
from collections.abc import Iterator, Sequence
from pathlib import Path

from pliant._core import Error, OptionError
from pliant.base.console import (
    EXIT_FAILED,
    EXIT_OK,
    counted,
    given,
    note,
    print_json,
    printable,
    printable_name,
    progress,
    run_command,
)
from pliant.base.extras import need
from pliant.base.processes import ended_by_signals
from pliant.shards.cluster import Place, dashboard_of, open_place
from pliant.shards.command_options import ensemble_parser
from pliant.shards.drive import Outcome, complete
from pliant.shards.folder_lock import alone_in
from pliant.shards.make_shard import Making, check_options, make_shard
from pliant.shards.options import Options, add_options
from pliant.shards.plan_made import make_plan, settled, withdraw, write_plan, write_whole
from pliant.shards.slurm_script import slurm_script
from pliant.shards.time_limit import EXIT_AGAIN, OutOfTimeError, deadline_of
from pliant.shards.verify import verify
from pliant.trajectory.shards.plan import PLAN, EnsemblePlan, load_plan

EXIT_UNCONVERGED = 3


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs the subcommand with a list of arguments (default: sys.argv); returns the exit code."""
    words = list(sys.argv[1:] if arguments is None else arguments)
    return run_command("ensemble", lambda: _main(words))


def _main(words: list[str]) -> int:
    with ended_by_signals("ensemble", {"SIGUSR1": EXIT_AGAIN}):
        parser = ensemble_parser()
        asked, _ = parser.parse_known_args(words)  # what the others are is known then
        asked.task = _task(asked)
        rows = add_options(parser, asked.task, vars(asked)) if asked.task else []
        options, rest = parser.parse_known_args(words, argparse.Namespace(task=asked.task))
        parser.expect_no_more(rest)
        return _in_time(options, given(options, rows), words)


def _task(asked: argparse.Namespace) -> str:
    """That of the shards; "" of an ensemble that is there."""
    for name in ("verify", "shard"):
        if getattr(asked, name) is not None:
            return ""
    if (asked.walkers is None) == (asked.frames is None):
        raise OptionError("expected --walkers N (of pliant run) or --frames N (of pliant sample)")
    return "run" if asked.frames is None else "sample"


def _in_time(options: argparse.Namespace, passed_on: Options, words: list[str]) -> int:
    options.deadline = deadline_of(options.walltime, time.time())
    try:
        return _ensemble(options, passed_on, words)
    except OutOfTimeError:
        text = f"--walltime {options.walltime} is nearly over: the same command goes on"
        print(f"pliant ensemble: {text}", file=sys.stderr)
        return EXIT_AGAIN


def _how(options: argparse.Namespace) -> Making:
    return Making(options.scratch, options.deadline, options.commit_seconds)


def _ensemble(options: argparse.Namespace, passed_on: Options, words: list[str]) -> int:
    if not options.task and options.input is not None:
        name = "--shard" if options.verify is None else "--verify"
        raise OptionError(f'unexpected argument "{options.input}": does not go with {name}')
    if options.verify is not None:
        return _verify(options)
    if options.output is None:
        raise OptionError("-o DIR: expected the folder of the ensemble")
    folder = Path(options.output)
    if options.shard is not None:
        return _make_one(folder, options)
    if options.slurm_script is None and not (folder / PLAN).exists():
        need("pliant ensemble", "dask", "distributed")  # before anything is made
    _expect_one_place(options)
    plan = _plan(options, passed_on)
    with alone_in(folder):
        if options.slurm_script is not None:
            return _write_script(plan, folder, options, words)
        return _make_all(plan, folder, options)


def _expect_one_place(options: argparse.Namespace) -> None:
    given = [
        name
        for name in ("--scheduler", "--cluster", "--slurm-script")
        if getattr(options, name[2:].replace("-", "_")) is not None
    ]
    if len(given) > 1:
        raise OptionError(f"{given[0]}: does not go with {given[1]}: expected one place")


def _plan(options: argparse.Namespace, passed_on: Options) -> EnsemblePlan:
    if options.input is None:
        raise OptionError("INPUT: expected a file")
    count = options.walkers or options.frames
    return make_plan(options.task, options.input, count, options.shard_size, passed_on)


def _make_all(plan: EnsemblePlan, folder: Path, options: argparse.Namespace) -> int:
    @contextlib.contextmanager
    def place(shards: int) -> Iterator[Place]:
        where = (options.workers, options.scheduler, options.cluster)
        with open_place(*where, shards) as opened:
            if not options.quiet and (link := dashboard_of(opened.client)):
                note(f"Dask's dashboard: {link}")
            yield opened

    with _planned(plan, folder, options) as agreed, progress("shards", options.quiet) as show:
        outcome = complete(agreed, folder, place, show, options.retries, _how(options))
    if options.json:
        print_json(outcome.as_json())
    elif not options.quiet:
        _print_outcome(outcome)
    return EXIT_UNCONVERGED if _is_incomplete(outcome) else EXIT_OK


@contextlib.contextmanager
def _planned(
    plan: EnsemblePlan, folder: Path, options: argparse.Namespace
) -> Iterator[EnsemblePlan]:
    """The folder's plan. One that is new goes again if an error comes before its first shard."""
    there = settled(folder, plan, options.shard_size)
    if there is not None:
        yield there
        return
    write_plan(folder, plan)
    try:
        yield plan
    except (Error, OSError, KeyboardInterrupt, SystemExit):
        withdraw(folder)
        raise


def _is_incomplete(outcome: Outcome) -> bool:
    return outcome.total("unconverged") > 0 or outcome.total("left_out") > 0


def _print_outcome(outcome: Outcome) -> None:
    plan = outcome.plan
    print(f"{plan.what:<16}{plan.count}, in {counted(plan.shard_count, 'shard')}")
    print(f"shards          {outcome.made} made, {outcome.found} there already")
    frames, size = outcome.total("frames"), outcome.total("bytes")
    print(f"frames          {frames}, {size / 1e6:.1f} MB, {size / max(frames, 1):.0f} bytes each")
    if outcome.total("unconverged"):
        print(f"not converged   {outcome.total('unconverged')} frames, which say so")
    if outcome.total("left_out"):
        print(f"left out        {outcome.total('left_out')} frames, which could not be resolved")
    print(f"time            {outcome.seconds:.2f} s")
    print(f"ensemble        {printable_name(outcome.folder)}")


def _make_one(folder: Path, options: argparse.Namespace) -> int:
    plan = load_plan(folder)
    if options.shard >= plan.shard_count:
        raise OptionError(
            f"--shard {options.shard}: expected a shard from 0 to {plan.shard_count - 1}"
        )
    record = make_shard(plan, plan.shard(options.shard), str(folder), _how(options))
    if options.json:
        print_json(record.as_json())
    elif not options.quiet:
        print(f"shard           {printable_name(folder / record.file)}")
    return EXIT_OK


def _write_script(
    plan: EnsemblePlan, folder: Path, options: argparse.Namespace, words: list[str]
) -> int:
    path = Path(options.slurm_script)
    with _planned(plan, folder, options) as agreed:
        check_options(agreed, str(folder))  # the jobs would all fail, later
        text = slurm_script(agreed, folder, _without_script(words), _how(options), options.walltime)
        write_whole(path, text)
    if not options.quiet:
        print(f"script          {printable_name(path)}: sbatch {printable_name(path)}")
    return EXIT_OK


def _without_script(words: list[str]) -> list[str]:
    """The command that counts the shards once all jobs have ended."""
    kept = [word for word in words if not word.startswith("--slurm-script=")]
    if "--slurm-script" in kept:
        place = kept.index("--slurm-script")
        del kept[place : place + 2]
    return kept


def _verify(options: argparse.Namespace) -> int:
    with progress("verify", options.quiet) as show:
        result = verify(Path(options.verify), show)
    if options.json:
        print_json(result.as_json())
    elif not options.quiet:
        complete = f"{result.shards} of {result.plan.shard_count}"
        print(f"shards          {complete} are complete and match the manifest")
        print(f"frames          {result.frames}, each once, {result.bytes / 1e6:.1f} MB")
    for problem in result.problems:
        print(f"pliant ensemble: error: {printable(problem)}", file=sys.stderr)
    return EXIT_FAILED if result.problems else EXIT_OK


if __name__ == "__main__":
    sys.exit(main())
