# SPDX-License-Identifier: MIT
"""Makes the pictures of the tutorial and the gallery, by the code that the gallery shows.

Usage: .venv/bin/python docs/make_pictures.py, once `./dev demo` has fetched ubiquitin
"""

from __future__ import annotations

import os
import sys
import tempfile
from pathlib import Path

from PIL import Image

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE / "tools"))

import transcripts  # noqa: E402

#: what the code of the gallery makes, and its name among the pictures
NAMES = {
    "report/flexibility.png": "ubiquitin_flexibility.png",
    "pictures/ubiquitin.compare-residues.png": "ubiquitin_comparison.png",
    "adk/correlations.png": "adk_domains.png",
    "adk/shapes.png": "adk_shapes.png",
    "pocket/pockets.png": "hiv_pockets.png",
    "path.png": "adk_path.png",
    "fit/fitted.png": "adk_in_map.png",
    "dilution.svg": "ubiquitin_dilution.svg",
    "ibuprofen.png": "ibuprofen.png",
    "convergence.png": "convergence.png",
}


def make(folder: Path) -> None:
    """Runs the code of the gallery in a folder, which is the working folder meanwhile."""
    transcripts.fill(folder)
    names: dict[str, object] = {}
    before = os.getcwd()
    os.chdir(folder)
    try:
        for block in transcripts.blocks((transcripts.PAGES / "gallery.md").read_text()):
            transcripts.run(block, folder, names)
    finally:
        os.chdir(before)


def keep(made: Path, picture: Path) -> None:
    """Copies a picture; a PNG with 256 colours, in a third of the bytes."""
    if made.suffix == ".png":
        Image.open(made).convert("RGB").quantize(256).save(picture, optimize=True)
    else:
        picture.write_bytes(made.read_bytes())


if __name__ == "__main__":
    os.environ["MPLBACKEND"] = "Agg"
    with tempfile.TemporaryDirectory() as work:
        make(Path(work))
        for made, name in NAMES.items():
            keep(Path(work) / made, HERE / "pictures" / name)
