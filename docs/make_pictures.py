# SPDX-License-Identifier: MIT
"""Draws the pictures of the tutorial and the gallery: the commands of the tutorial make them.

Usage: .venv/bin/python docs/make_pictures.py, once `./dev demo` has fetched ubiquitin
"""

from __future__ import annotations

import importlib.resources
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE / "tools"))

import transcripts  # noqa: E402
from history_picture import make_history_picture  # noqa: E402

DPI = 110


def run(folder: Path, *words: str) -> None:
    """Runs a command of pliant in a folder."""
    command = Path(sys.executable).parent / "pliant"
    subprocess.run([command, *words], cwd=folder, check=True, stdout=subprocess.DEVNULL)


def draw_dilution(folder: Path) -> None:
    """Which residues are rigid together as hydrogen bonds are taken out."""
    import pliant

    structure = pliant.read(folder / "1ubi.pdb")
    structure.perceive_bonds()
    picture = pliant.rigidity(structure).dilution_picture("ubiquitin")
    (folder / "dilution.svg").write_text(picture)


def make(folder: Path) -> None:
    """Makes all pictures of docs/pictures in a folder."""
    transcripts.fill(folder)
    run(folder, "sample", "1ubi.pdb", "-o", "ubiquitin.h5md")
    run(folder, "analyse", "ubiquitin.h5md", "-o", "report", "--dpi", str(DPI))
    run(folder, "compare", "ubiquitin.h5md", "2k39.pdb")
    draw_dilution(folder)
    adk = importlib.resources.files("MDAnalysisTests") / "data" / "adk_open.pdb"
    run(folder, "sample", str(adk), "-o", "adk.h5md")
    run(folder, "analyse", "adk.h5md", "-o", "adk", "--dpi", str(DPI))


NAMES = {
    "report/flexibility.png": "ubiquitin_flexibility.png",
    "ubiquitin.compare-residues.png": "ubiquitin_comparison.png",
    "adk/shapes.png": "adk_shapes.png",
    "dilution.svg": "ubiquitin_dilution.svg",
}

if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as work:
        make(Path(work))
        for made, name in NAMES.items():
            (HERE / "pictures" / name).write_bytes((Path(work) / made).read_bytes())
    make_history_picture(HERE / "pictures" / "bench_history.svg")
