# SPDX-License-Identifier: MIT
"""The page in Debian's Firefox, where that and Xvfb are there: one drag, the same bits."""

import base64
import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from firefox import BINARY, Firefox
from h5md_contents import positions_in
from real_files import CAFFEINE, PEPTIDE
from wasm_solver import ROOT

BUILT = Path(os.environ.get("PLIANT_PLAY", ROOT / "build/play")) / "pliant.html"
COMMAND = Path(os.environ.get("PLIANT_COMMAND", Path(sys.executable).parent / "pliant"))

#: Where a joint is seen that nothing hides, in CSS pixels of the window.
SEEN = """(() => {
  const box = document.getElementById('canvas').getBoundingClientRect();
  for (let j = 0; j < P.session.model.joints; ++j) {
    const {x, y} = P.view.orbit.project([...P.session.positions.subarray(3 * j, 3 * j + 3)]);
    if (P.view.pick(x, y)?.joint === j)
      return {x: Math.round(box.left + x), y: Math.round(box.top + y)};
  }
})()"""

STEPS = """new Promise((done) => {
  const look = () => P.stage.history.length >= 6 ? done(true) : setTimeout(look, 20);
  look();
})"""


def dragged(firefox):
    """Opens the page, drags a joint of caffeine: forces as text, positions, model, complaints."""
    firefox.open(BUILT.as_uri())
    assert firefox.tell("window.pliant.then((parts) => { window.P = parts; return !!parts; })")
    firefox.tell("P.open.openExample('caffeine.sdf').then(() => true)")
    seen = firefox.tell(SEEN)
    move = {"type": "pointerMove", "x": seen["x"], "y": seen["y"]}
    firefox.mouse(move, {"type": "pointerDown", "button": 0})
    aside = {"type": "pointerMove", "x": seen["x"] + 60, "y": seen["y"] - 40, "duration": 200}
    firefox.mouse(aside)
    firefox.tell(STEPS)
    firefox.mouse({"type": "pointerUp", "button": 0})
    return firefox.tell(
        "P.session.forces().then((text) => ({text, positions: [...P.session.positions],"
        " model: P.stage.model.model, residual: P.stage.last.residual}))"
    )


@pytest.mark.long
def test_a_drag_in_firefox_has_the_bits_of_the_library(tmp_path):
    if not (BINARY and shutil.which("Xvfb") and BUILT.is_file()):
        pytest.skip("firefox-esr, xvfb or the page is not there: apt-get install, ./dev play")
    pytest.importorskip("websockets")
    (tmp_path / "profile").mkdir()
    with Firefox(tmp_path / "profile") as firefox:
        session = dragged(firefox)
    assert session["residual"] <= 1e-6
    forces, out = tmp_path / "session.forces.txt", tmp_path / "replayed.h5md"
    forces.write_text(session["text"])
    words = ["run", CAFFEINE, "--forces", forces, "--model", session["model"], "-o", out]
    subprocess.run([COMMAND, *map(str, words)], check=True, capture_output=True)
    frames = positions_in(out)
    assert len(frames) >= 6
    assert np.array_equal(frames[-1].ravel(), session["positions"])
    assert not np.array_equal(frames[-1], frames[0])


#: Bytes of the positions of all frames, and of where the solver stands.
BITS = """window.pliant.then(({stage, session}) => {
  const arrays = [...stage.frames.list.map(({positions}) => positions), session.positions];
  return arrays.map((array) => btoa(Array.from(new Uint8Array(array.buffer, array.byteOffset,
    array.byteLength), (byte) => String.fromCharCode(byte)).join('')));
})"""


@pytest.mark.long
def test_a_page_shared_from_chromium_is_the_same_bits_in_firefox(tmp_path):
    if not (BINARY and shutil.which("Xvfb") and BUILT.is_file() and shutil.which("node")):
        pytest.skip("firefox-esr, xvfb, node or the page is not there: apt-get install, ./dev play")
    pytest.importorskip("websockets")
    script = ROOT / "apps/play/test/from_python/make_session.mjs"
    subprocess.run(["node", script, PEPTIDE, tmp_path], check=True, capture_output=True)
    (tmp_path / "profile").mkdir()
    with Firefox(tmp_path / "profile") as firefox:
        firefox.open((tmp_path / "session.html").as_uri())
        rows = [np.frombuffer(base64.b64decode(row)) for row in firefox.tell(BITS)]
    frames = positions_in(tmp_path / "session.h5md").reshape(-1, 3 * 327)
    assert len(rows) == len(frames) + 1 >= 12
    assert all(a.tobytes() == b.tobytes() for a, b in zip(rows, frames, strict=False))
    assert rows[-1].tobytes() == frames[-1].tobytes()  # the solver has come there, too
