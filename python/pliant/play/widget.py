# SPDX-License-Identifier: MIT
"""The page as a widget of a notebook: what anywidget needs, and what comes back from the page."""

from __future__ import annotations

import base64
import gzip
from pathlib import Path
from typing import Any

import anywidget
import numpy as np
import traitlets
from numpy.typing import NDArray

from pliant.play import page as pages


class PlayView(anywidget.AnyWidget):
    """A molecule to be pulled on in a notebook; ``pliant.view`` makes it.

    Attributes
    ----------
    positions : (N, 3) float64
        Where the joints are, Angstrom: after a drag, while it wanders, in the frame that is shown.
        A trait: ``view.observe(function, "positions")`` hears of each change.
    names : list of str
        Of the joints, once the page has opened them: "A:SER1:CA".
    model : str
        What holds them, once the page has chosen: a name in ``models()``, "" for a graph.
    """

    _esm = Path(__file__).with_name("widget.mjs")
    height = traitlets.Int(560).tag(sync=True)
    positions = traitlets.Any()
    names = traitlets.List(traitlets.Unicode())
    model = traitlets.Unicode()
    picture = traitlets.Bytes(b"").tag(sync=True)  # of what the page showed last: it is saved with
    session = traitlets.Bytes(b"").tag(sync=True)  # the notebook, as what was done is

    def __init__(
        self, page: bytes, start: NDArray[np.float64], height: int, picture: bytes = b""
    ) -> None:
        super().__init__(height=height, positions=start, picture=picture)
        self._page = gzip.compress(page, compresslevel=1)
        self.on_msg(self._take)

    def _take(self, _: object, said: Any, buffers: list[Any]) -> None:
        """What a cell that shows the page says."""
        tell = said.get("tell")
        if tell == "ready":
            self.send({"tell": "page"}, buffers=[self._page_of_now()])
        elif tell == "opened":
            self.names, self.model = said["names"], said["model"]
        elif tell == "moved":
            self.positions = np.frombuffer(buffers[0], "<f8").reshape(-1, 3).copy()
        elif tell == "rested":
            self.picture, self.session = bytes(buffers[0]), bytes(buffers[1])

    def _page_of_now(self) -> bytes:
        """The page, where what was done in it has been done: a notebook was opened once more."""
        if not self.session:
            return self._page
        page = pages.with_session(gzip.decompress(self._page), self.session)
        return gzip.compress(page, compresslevel=1)

    def _repr_mimebundle_(self, **options: Any) -> Any:
        """The widget, and a picture for where there is no kernel."""
        found = super()._repr_mimebundle_(**options)
        data = found[0] if isinstance(found, tuple) else found
        if data is not None and self.picture:
            data["image/png"] = base64.b64encode(self.picture).decode("ascii")
        return found

    def __repr__(self) -> str:
        return f"<PlayView of {len(self.positions)} joints>"
