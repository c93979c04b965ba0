# SPDX-License-Identifier: MIT
"""The WebAssembly module of the page, asked as the page asks it, by node."""

import hashlib
import json
import os
import shutil
import subprocess
from pathlib import Path

import numpy as np
from real_files import ROOT

WASM = ROOT / "build" / "play" / "pliant.wasm"
BUILT = Path(os.environ.get("PLIANT_PLAY", ROOT / "build/play"))  #: folder of the page
CHROMIUM = os.environ.get("CHROMIUM", "/usr/bin/chromium")


def is_there():
    """Whether ./dev play has built the module and node is here to run it."""
    return WASM.exists() and shutil.which("node") is not None


def what_page_lacks():
    """What is not here of that which opens the page in Chromium; empty if all is."""
    for program in ("node", CHROMIUM):
        if not shutil.which(program):
            return f"{program} is not installed"
    packages = ROOT / "build/play/node_modules"
    for file in (BUILT / "pliant.html", packages / "playwright-core/package.json"):
        if not file.is_file():
            return f"{file} is missing: ./dev play makes it"
    return ""


class Solver:
    """One worker; a context manager."""

    def __enter__(self):
        script = ROOT / "apps" / "play" / "test" / "from_python" / "answer_lines.mjs"
        self.node = subprocess.Popen(
            ["node", script], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )
        return self

    def __exit__(self, *_):
        self.node.stdin.close()
        self.node.wait(900)

    def ask(self, what, **fields):
        """The reply; a failed one raises ValueError with its text."""
        print(json.dumps({"do": what, **fields}), file=self.node.stdin, flush=True)
        reply = json.loads(self.node.stdout.readline())
        if not reply["ok"]:
            raise ValueError(reply["error"])
        return reply

    def open(self, path, model="bonds"):
        """Opens a file by its path; the model as `build_model` calls it."""
        return self.ask("open", name=Path(path).name, file=str(path), model=model)


def sha1(array, kind=np.float64):
    """What a reply tells of an array with these numbers."""
    return hashlib.sha1(np.ascontiguousarray(array, kind).tobytes()).hexdigest()
