# SPDX-License-Identifier: MIT
"""Counts instructions and bars looked at, which a busy machine does not change.

    PYTHONPATH=PACKAGE count_instructions.py [--json] [--compare BEFORE.json]

Whichever package is importable does the small fixed work of counted_work.py under valgrind's
callgrind, which counts the instructions of the processor. Plans, imports and the interpreter do not
count. With --compare the ratios to an earlier --json are printed, and the exit code is 1 if one is
above 1.03. Needs valgrind with its headers and a C compiler.
"""

from __future__ import annotations

import argparse
import ctypes
import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

MOST_RATIO = 1.03
SWITCH = """
#include <valgrind/callgrind.h>
void start(void) { CALLGRIND_START_INSTRUMENTATION; }
void zero(void) { CALLGRIND_ZERO_STATS; }
void dump(void) { CALLGRIND_DUMP_STATS; }
"""

Counts = dict[str, dict[str, int]]  # "instructions" and "bars" by the name of a workload


def work_within(switch: str) -> None:
    """Does all work, in a process under callgrind; prints a line of JSON for each count taken."""
    import counted_work

    callgrind = ctypes.CDLL(switch)
    callgrind.start()
    for row in counted_work.rows():
        for sign, work in ((1, row.work), (-1, row.less)):
            if work is not None:
                callgrind.zero()
                bars = work()
                callgrind.dump()
                print(json.dumps([row.name, sign, bars]), flush=True)


def count() -> Counts:
    """The counts of all workloads, by a process under callgrind."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        said = run_under_callgrind(folder, compiled_switch(folder))
        found: Counts = {}
        for number, line in enumerate(said, start=1):
            row, sign, bars = json.loads(line)
            instructions = instructions_in(folder / f"out.{number}")
            counts = found.setdefault(row, {"instructions": 0, "bars": 0})
            counts["instructions"] += sign * instructions
            counts["bars"] += sign * bars
    return found


def compiled_switch(folder: Path) -> Path:
    """A library by which a process tells callgrind when to count."""
    source, library = folder / "switch.c", folder / "switch.so"
    source.write_text(SWITCH)
    compiler = os.environ.get("CC", "cc")
    subprocess.run([compiler, "-shared", "-fPIC", "-o", library, source], check=True)
    return library


def run_under_callgrind(folder: Path, switch: Path) -> list[str]:
    """The lines that the process says; the counts are in out.1, out.2 and so on."""
    command = [
        *"valgrind --tool=callgrind --instr-atstart=no -q".split(),
        f"--callgrind-out-file={folder}/out",
        sys.executable,
        __file__,
    ]
    environment = os.environ | {"PYTHONHASHSEED": "0", "OPENBLAS_NUM_THREADS": "1"}
    done = subprocess.run(
        [*command, "--within", switch],
        env=environment,
        stdout=subprocess.PIPE,
        text=True,
        check=True,
    )
    return done.stdout.splitlines()


def instructions_in(path: Path) -> int:
    """Instructions of a dump, without those of the interpreter and of numpy."""
    return sum(
        cost for library, cost in costs(path.read_text().splitlines()) if is_counted(library)
    )


def is_counted(library: str) -> bool:
    """Whether a program or library is ours or one that ours uses."""
    name = Path(library).name
    is_python = name.startswith(("python", "libpython", "_ctypes", "libffi"))
    return not is_python and "/numpy" not in library


def costs(lines: list[str]) -> Iterator[tuple[str, int]]:
    """Library and own instructions of each line of code in a dump (Callgrind Format, version 1)."""
    names: dict[str, str] = {}
    library, is_call = "", False
    for line in lines:
        if line.startswith(("ob=", "cob=")):
            number, _, name = line.partition("=")[2].partition(" ")
            names.setdefault(number, name)
            library = names[number] if line.startswith("ob=") else library
        elif line.startswith("calls="):
            is_call = True  # the next line tells what the called function took
        elif line[:1] in "0123456789+-*" and line:
            if not is_call:
                yield library, int(line.split()[1])
            is_call = False


def with_sums(counts: Counts) -> Counts:
    """The rows, and after them a row for each benchmark."""
    sums: Counts = {}
    for name, row in counts.items():
        total = sums.setdefault(f"all of {name.split()[0]}", {"instructions": 0, "bars": 0})
        for what, number in row.items():
            total[what] += number
    return counts | sums


def print_table(counts: Counts, before: Counts) -> None:
    """The counts, beside the ratios to those before where there are any."""
    width = max(map(len, counts))
    print(f"{'':{width}} {'instructions':>15} {'bars':>11}" + "   ratios" * bool(before))
    for name, row in counts.items():
        ratios = ratios_of(row, before[name]) if name in before else {}
        columns = "".join(f" {ratio:8.4f}" for ratio in ratios.values())
        print(f"{name:{width}} {row['instructions']:15,} {row['bars']:11,}{columns}")


def ratios_of(row: dict[str, int], before: dict[str, int]) -> dict[str, float]:
    """Counts over those before; one that was nothing stays 1 if it still is."""
    return {what: row[what] / before[what] if before[what] else 1.0 + row[what] for what in before}


def findings(counts: Counts, before: Counts) -> list[str]:
    """What became slower, or is not to be compared."""
    found = [f"{name}: is in one of both only" for name in sorted(counts.keys() ^ before.keys())]
    for name in counts.keys() & before.keys():
        for what, ratio in ratios_of(counts[name], before[name]).items():
            if ratio > MOST_RATIO:
                found.append(f"{name}: {ratio:.3f} times the {what}")
    return sorted(found)


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--json", action="store_true", help="print the counts as JSON")
    parser.add_argument("--compare", type=Path, help="what --json printed before")
    parser.add_argument("--within", help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.within:
        work_within(arguments.within)
        return 0
    counts = with_sums(count())
    before = json.loads(arguments.compare.read_text()) if arguments.compare else {}
    print(json.dumps(counts, indent=1)) if arguments.json else print_table(counts, before)
    found = findings(counts, before) if arguments.compare else []
    for text in found:
        print(text, file=sys.stderr)
    return int(bool(found))


if __name__ == "__main__":
    sys.exit(main())
