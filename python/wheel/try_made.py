# SPDX-License-Identifier: MIT
"""Tries wheels that another machine made: try_made.py WHEELS TRIED

Installs the wheel in the folder WHEELS that fits this Python into an environment of its own, with
NumPy and h5py alone, samples a helix and runs the tests that the package brings along, away from
the sources, and copies the wheel into the folder TRIED. On any system; needs nothing but Python.
"""

import os
import shutil
import subprocess
import sys
import tempfile
import venv
from pathlib import Path


def run(*words: object, folder: Path) -> None:
    """Runs a command there; ends this program if it fails."""
    print("$", *words, flush=True)
    code = subprocess.run([str(word) for word in words], cwd=folder, check=False).returncode
    if code:
        sys.exit(code)


def fitting_wheel(python: Path, wheels: Path, folder: Path) -> Path:
    """The wheel that pip takes for this Python, copied into a folder."""
    source = ("--no-index", "--no-deps", "--find-links", wheels)
    run(
        python,
        "-m",
        "pip",
        "download",
        "--quiet",
        *source,
        "--dest",
        folder,
        "pliant",
        folder=folder,
    )
    (found,) = folder.glob("pliant-*.whl")
    return found


def helix_of(python: Path) -> str:
    """The molecule that the package brings along."""
    code = "import pliant; print(pliant.__path__[0])"
    package = subprocess.run([python, "-c", code], check=True, capture_output=True, text=True)
    return str(Path(package.stdout.strip(), "static", "examples", "peptide_20.pdb"))


def try_in(folder: Path, wheels: Path) -> Path:
    """The wheel that was tried."""
    venv.create(folder / "venv", with_pip=True)
    scripts = folder / "venv" / ("Scripts" if os.name == "nt" else "bin")
    python, pliant = scripts / "python", scripts / "pliant"
    (folder / "wheel").mkdir()
    wheel = fitting_wheel(python, wheels, folder / "wheel")
    run(python, "-m", "pip", "install", "--quiet", "pytest", wheel, folder=folder)
    run(pliant, "--version", folder=folder)
    run(pliant, "sample", helix_of(python), "-o", "ensemble.h5md", folder=folder)
    run(python, "-m", "pytest", "--quiet", "--pyargs", "pliant", folder=folder)
    return wheel


def main() -> int:
    """Tries, and copies what passed."""
    wheels, tried = (Path(word).resolve() for word in sys.argv[1:])
    tried.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as name:
        wheel = try_in(Path(name).resolve(), wheels)
        print("tried:", shutil.copy2(wheel, tried))
    return 0


if __name__ == "__main__":
    sys.exit(main())
