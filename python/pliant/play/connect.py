# SPDX-License-Identifier: MIT
"""``pliant play --connect``: the page on a run that goes on elsewhere."""

from __future__ import annotations

import asyncio
import warnings
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from pliant._core import FileError, InputError, PliantWarning, build_model, read, read_graph_xml
from pliant.base import console
from pliant.base.extras import need
from pliant.play import page
from pliant.play.upstream import Upstream


def connect(
    host: str,
    port: int,
    given: Path,
    show: Callable[[str], None],
    facts: Mapping[str, Any] | None = None,
) -> int:
    """Serves the page of a run until that has ended, or Ctrl-C; returns the exit code.

    Parameters
    ----------
    host, port
        Of the run.
    given : Path
        The file that the run reads.
    show : function
        Takes the page's address.
    facts
        What else the page is told.

    Raises
    ------
    InputError, FileError
        The file cannot be read, is of other atoms, or nobody listens there.
    """
    need("pliant play --connect", "websockets")
    bare, data = page.page_file().read_bytes(), page.read_given(given)
    upstream = _reached(host, port)
    try:
        model = matching_model(given, upstream.atoms)
        name = console.printable(given.name)

        def make_page(address: str) -> bytes:
            full = page.with_file(bare, name, data, model=model, live=address, **(facts or {}))
            return page.with_connection(full, address)

        asyncio.run(_serve(upstream, make_page, show))
    except KeyboardInterrupt:
        console.note("stopped; the run goes on")
        return console.EXIT_OK
    finally:
        upstream.close()
    return console.EXIT_OK if upstream.has_ended else console.EXIT_FAILED


def _reached(host: str, port: int) -> Upstream:
    try:
        return Upstream(host, port)
    except OSError as error:
        wanted = "expected a run that listens there (pliant run --imd) and sends frames"
        raise FileError(f"{host}:{port}: {wanted}: {error.strerror or error}") from None


async def _serve(
    upstream: Upstream, make_page: Callable[[str], bytes], show: Callable[[str], None]
) -> None:
    from pliant.play.bridge import Bridge

    await Bridge(upstream, make_page).run(show, console.note)


def matching_model(given: Path, atoms: int) -> str:
    """The model with which a file has as many joints as a run; the page tells what it warns of.

    Raises InputError if none has.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", PliantWarning)
        return _matching_model(given, atoms)


def _matching_model(given: Path, atoms: int) -> str:
    if given.name.endswith(".xml"):
        found = [("bonds", len(read_graph_xml(given).positions))]
    else:
        found = [("bonds", len(read(given)))]
        if found[0][1] != atoms:
            found += _with_hydrogens(given)
    for model, joints in found:
        if joints == atoms:
            return model
    counts = " or ".join(dict.fromkeys(str(joints) for _, joints in found))
    raise InputError(
        f"{given}: has {counts} joints, the run {atoms}: expected the file that the run reads, or "
        "the PDB file that it writes"
    )


def _with_hydrogens(given: Path) -> list[tuple[str, int]]:
    """Joints with the hydrogens that the model of a protein adds, without the waters it leaves."""
    structure = read(given)
    structure.perceive_bonds()
    try:
        return [("protein", build_model(structure, "protein").framework.joint_count)]
    except InputError:
        return []
