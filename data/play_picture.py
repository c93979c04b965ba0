# SPDX-License-Identifier: MIT
"""Draws pictures/play.webp, the page of `pliant play` with a hand that pulls on a protein.

    ./dev play && python data/play_picture.py PROTEIN.pdb

Needs node, Chromium and Pillow, and the page that ./dev play builds. An animation of five seconds
that begins again, below two megabytes; the first frame is pictures/play.png.
"""

import argparse
import subprocess
import tempfile
from pathlib import Path

from PIL import Image

HERE = Path(__file__).resolve().parent
MAKE = HERE.parent / "apps" / "play" / "make_pictures.mjs"
SECONDS = 5.0
WIDTH = 880
MOST_BYTES = 2_000_000


def frames_of(protein: Path) -> list[Image.Image]:
    """Screenshots of the page while the hand pulls, scaled down."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(["node", MAKE, protein, folder], check=True)
        pictures = [Image.open(path).convert("RGB") for path in sorted(Path(folder).glob("*.png"))]
    height = round(WIDTH * pictures[0].height / pictures[0].width)
    return [one.resize((WIDTH, height), Image.Resampling.LANCZOS) for one in pictures]


def main() -> None:
    """Writes both pictures."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("protein", type=Path)
    frames = frames_of(parser.parse_args().protein)
    output = HERE / "pictures" / "play.webp"
    duration = round(1000 * SECONDS / len(frames))
    webp = {"duration": duration, "loop": 0, "quality": 70, "method": 6}
    frames[0].save(output, save_all=True, append_images=frames[1:], **webp)
    frames[len(frames) // 4].save(HERE / "pictures" / "play.png", optimize=True)
    if output.stat().st_size > MOST_BYTES:
        raise SystemExit(f"{output}: {output.stat().st_size} bytes, more than {MOST_BYTES}")


if __name__ == "__main__":
    main()
