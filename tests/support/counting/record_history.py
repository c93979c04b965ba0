# SPDX-License-Identifier: MIT
"""Appends what Pliant takes today to data/bench_history.jsonl: ./dev bench --record

    record_history.py [--output FILE] [--ratios-only]

Times depend on the machine and on what else it does, so that only ratios are recorded: to OpenMM's
CCMA, which repairs the same broken molecule in turn with each technique, in the same process. The
second kind are instructions under valgrind, which no load changes: a later row over the first one.
Needs OpenMM and valgrind. docs/make_pictures.py draws the rows.
"""

from __future__ import annotations

import argparse
import datetime
import json
import platform
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import count_instructions

ROOT = Path(__file__).resolve().parents[3]
HISTORY = ROOT / "data" / "bench_history.jsonl"
PROTEIN = ROOT / "data" / "proteins" / "three_helices.pdb"
TECHNIQUES = ("auto", "blocks", "units", "shake")
TOLERANCE = 1e-6
ROUNDS = {"repeats": 15, "frames": 60}

Row = dict[str, Any]


def pliant(*words: object) -> Row:
    """What a benchmark of the installed command says, as JSON."""
    command = [Path(sys.executable).parent / "pliant", "bench", *map(str, words), "--json"]
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True)
    return dict(json.loads(done.stdout))


def ratios() -> dict[str, float]:
    """How many times as fast as CCMA techniques are, and how many of its repairs a frame takes."""
    names = ",".join(TECHNIQUES)
    options = ("--no-gromacs", "--quiet", "--techniques", names, "--tolerances", TOLERANCE)
    race = pliant("work-precision", PROTEIN, "--repeats", ROUNDS["repeats"], *options)
    found = {
        f"{row['method']}: times as fast as CCMA": round(row["ratio_to_openmm"], 2)
        for row in race["rows"]
        if row["ratio_to_openmm"] and not row["method"].startswith(("ccma", "shake_dynamics"))
    }
    repair = next(row["ns_per_bar"] for row in race["rows"] if row["method"] == "ccma")
    frames = pliant("throughput", PROTEIN, "--frames", ROUNDS["frames"])["rows"]
    frame = next(row["milliseconds"] for row in frames if row["hydrogens"] == "all")
    found["repairs by CCMA in the time of a frame of sample"] = round(
        frame * 1e6 / (repair * race["bars"]), 2
    )
    return found


def instructions() -> dict[str, int]:
    """Millions of them, by the kind of work: the first word of a workload's name."""
    sums: dict[str, int] = {}
    for name, counts in count_instructions.count().items():
        kind = name.split()[0]
        sums[kind] = sums.get(kind, 0) + counts["instructions"]
    return {kind: round(count / 1e6) for kind, count in sorted(sums.items())}


def processor() -> str:
    """The name of the processor, as Linux has it."""
    lines = Path("/proc/cpuinfo").read_text().splitlines()
    named = (line.partition(": ")[2] for line in lines if line.startswith("model name"))
    return next(named, platform.machine())


def git(*words: str) -> str:
    """What git says."""
    return subprocess.run(
        ["git", *words], cwd=ROOT, capture_output=True, text=True, check=False
    ).stdout.strip()


def row(ratios_only: bool) -> Row:
    """All of it, and of what."""
    import openmm

    import pliant as package

    changed = "-changed" if git("status", "--porcelain", "--untracked-files=no") else ""
    return {
        "day": datetime.datetime.now(datetime.timezone.utc).date().isoformat(),
        "version": package.__version__,
        "commit": git("rev-parse", "--short=12", "HEAD") + changed,
        "processor": processor(),
        "openmm": openmm.version.short_version,
        "ratios": ratios(),
        "million_instructions": {} if ratios_only else instructions(),
    }


def told(this: Row, before: Row | None) -> Iterator[str]:
    """What was measured, beside the row before."""
    for kind in ("ratios", "million_instructions"):
        for name, value in this[kind].items():
            earlier = (before or {}).get(kind, {}).get(name)
            yield f"  {name:<52}{value:>10}{'' if earlier is None else f'   before {earlier}'}"


def main() -> None:
    """Measures, appends, and says what came out."""
    parser = argparse.ArgumentParser(description="appends a row to the history of benchmarks")
    parser.add_argument("--output", type=Path, default=HISTORY)
    parser.add_argument(
        "--ratios-only", action="store_true", help="count no instructions: minutes less"
    )
    options = parser.parse_args()
    path = options.output
    known = path.read_text(encoding="utf-8").splitlines() if path.exists() else []
    this = row(options.ratios_only)
    with path.open("a", encoding="utf-8") as file:
        file.write(json.dumps(this) + "\n")
    print(*told(this, json.loads(known[-1]) if known else None), sep="\n")
    print(f"\nOne more row in {path}")


if __name__ == "__main__":
    main()
