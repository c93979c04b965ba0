# SPDX-License-Identifier: MIT
"""Notebooks: run in a folder of their own, and shown as pages."""

from __future__ import annotations

import base64
import os
import re
import tempfile
from pathlib import Path

import nbformat
from jupyter_client.manager import AsyncKernelManager
from jupyter_core.utils import run_sync
from nbclient import NotebookClient
from nbformat import NotebookNode

ROOT = Path(__file__).resolve().parents[2]
SECONDS = 900  #: a cell may take, on a machine that does other things too
COLOURS = re.compile(r"\x1b\[[0-9;]*m")


def run(path: Path) -> NotebookNode:
    """The notebook with the outputs of a fresh kernel; raises CellExecutionError if one fails.

    It runs in an empty folder, beside a link `data` to the data of the repository.
    """
    notebook = nbformat.read(path, as_version=4)
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "data").symlink_to(ROOT / "data")
        resources = {"metadata": {"path": folder}}
        kernel = AsyncKernelManager(transport="ipc", connection_file=f"{folder}/kernel.json")
        try:
            NotebookClient(notebook, kernel, timeout=SECONDS, resources=resources).execute()
        finally:  # the client leaves a kernel that it was given alone
            run_sync(kernel.shutdown_kernel)(now=True)
    return notebook


def as_page(path: Path) -> tuple[str, dict[str, bytes]]:
    """The notebook, run, as Markdown; and its pictures by name.

    With PLIANT_DOCS_QUICK set it is not run, for those who look at how pages look.
    """
    pictures: dict[str, bytes] = {}
    done = nbformat.read(path, as_version=4) if "PLIANT_DOCS_QUICK" in os.environ else run(path)
    parts = [_shown(cell, path.stem, pictures) for cell in done.cells]
    note = f"*This page is the notebook `docs/notebooks/{path.name}`, run when the site was built.*"
    return "\n\n".join([*parts, note]) + "\n", pictures


def _shown(cell: NotebookNode, stem: str, pictures: dict[str, bytes]) -> str:
    if cell.cell_type == "markdown":
        return str(cell.source)
    kept = [one for one in cell.outputs if one.get("name") != "stderr"]
    shown = [_output(output, stem, pictures) for output in kept]
    return "\n\n".join([f"```python\n{cell.source}\n```", *shown])


def _output(output: NotebookNode, stem: str, pictures: dict[str, bytes]) -> str:
    if output.output_type == "stream":
        return _plain(output.text)
    data = output.data
    if "image/png" in data:
        return _picture(base64.b64decode(data["image/png"]), "png", stem, pictures)
    if "image/svg+xml" in data:
        return _picture(data["image/svg+xml"].encode(), "svg", stem, pictures)
    if "text/html" in data:
        return f'<div class="output">{data["text/html"]}</div>'
    return _plain(data.get("text/plain", ""))


def _picture(content: bytes, suffix: str, stem: str, pictures: dict[str, bytes]) -> str:
    name = f"{stem}-{len(pictures) + 1}.{suffix}"
    pictures[name] = content
    return f"![Output of the cell above]({name})"


def _plain(text: str) -> str:
    return f"```text\n{COLOURS.sub('', text).rstrip()}\n```"
