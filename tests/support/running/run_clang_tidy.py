# SPDX-License-Identifier: MIT
"""clang-tidy over the library and the command; ends with 1 if it finds anything.

    run_clang_tidy.py BUILD [--jobs N] [PART...]

BUILD holds compile_commands.json of a build without precompiled headers. One that compiles files in
batches (PLIANT_UNITY) takes a fraction of the time: most of it is spent on headers. Files of it
whose path has one of the PARTs in it are looked at, all if none is given. What is in a header is
said once.
"""

from __future__ import annotations

import argparse
import json
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
FINDING = re.compile(r"^/.*:\d+:\d+: (warning|error): ")


def sources(build: Path, parts: list[str]) -> list[str]:
    """The files that are compiled, each once."""
    commands = json.loads((build / "compile_commands.json").read_text())
    found = sorted({row["file"] for row in commands})
    return [file for file in found if not parts or any(part in file for part in parts)]


def findings(program: Path, build: Path, source: str) -> list[str]:
    """What is said of one file: paragraphs that each begin with a place."""
    command = [str(program), "--quiet", "-p", str(build), source]
    said = subprocess.run(command, capture_output=True, text=True, check=False).stdout
    found: list[str] = []
    for line in said.splitlines():
        if FINDING.match(line):
            found.append(line)
        elif found:
            found[-1] += "\n" + line
    return found


def main() -> int:
    """Looks at all files and prints what was found."""
    parser = argparse.ArgumentParser(description="clang-tidy over src and apps")
    parser.add_argument("build", type=Path)
    parser.add_argument("parts", nargs="*", metavar="PART")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--program", default=Path(sys.executable).with_name("clang-tidy"))
    options = parser.parse_args()
    files = sources(options.build, options.parts)
    known: dict[str, None] = {}
    with ThreadPoolExecutor(options.jobs) as pool:
        for found in pool.map(lambda f: findings(options.program, options.build, f), files):
            for text in found:
                if text not in known:
                    known[text] = None
                    print(text.replace(f"{ROOT}/", ""), flush=True)
    print(f"{len(files)} files, {len(known)} findings")
    return 1 if known or not files else 0


if __name__ == "__main__":
    sys.exit(main())
