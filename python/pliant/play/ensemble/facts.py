# SPDX-License-Identifier: MIT
"""An ensemble for the page: its frames, and what was found of them."""

from __future__ import annotations

import contextlib
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from pliant._core import Error, OptionError
from pliant.measure.domains import LOOSE
from pliant.measure.stages.analysis import AnalysisOptions
from pliant.measure.stages.opened import opened
from pliant.measure.stages.parts import Units
from pliant.measure.stages.reference import reference_of
from pliant.measure.stages.units import units_of
from pliant.play.ensemble.many_frames import LEAST_FRAMES
from pliant.play.ensemble.thinned import write_thinned
from pliant.play.ensemble.turns import Turn, largest_turn
from pliant.report.representatives import representatives
from pliant.report.sections import flexible
from pliant.report.sections.domains import RigidDomains, named_stretches
from pliant.trajectory.kind import ENSEMBLE, MEANING
from pliant.trajectory.shards.ensemble import EnsembleFrames

if TYPE_CHECKING:
    from pliant.measure.stages.analysis import Analysis

MOST_BYTES = 96 * 1024**2  #: of positions that a page is given: so many can be opened and played
MOST_SHAPES = 6  #: that stand for all, where the ensemble has no other shapes of its own
MOST_FRAMES_TURNED = 1000  #: of more frames so many, evenly, are looked at for the largest turn


@dataclass(frozen=True)
class EnsembleForPage:
    """An H5MD file and what goes with it."""

    data: bytes
    facts: dict[str, Any]


def ensemble_for_page(
    path: Path, structure: Path | None = None, most_bytes: int = MOST_BYTES
) -> EnsembleForPage:
    """What the page is given of an ensemble, a path or another trajectory in H5MD.

    structure: the start, which frames are compared with where `path` does not tell it.

    Raises InputError or FileError where the frames cannot be read.
    """
    named = None if structure is None else str(structure)
    analysis = opened(AnalysisOptions(str(path), reference=named))
    analysis = analysis.having(reference_of(analysis)).having(units_of(analysis))
    shapes = _shapes(path, analysis)
    chosen = _chosen(analysis, [row["frame"] for row in shapes.get("rows", [])], most_bytes)
    facts: dict[str, Any] = {
        "kind": analysis.kind,
        "meaning": MEANING[analysis.kind][1],
        "frames": len(analysis.frames),
        "numbers": analysis.frames[chosen].tolist(),
        "notes": list(analysis.remarks),
        "shapes": shapes,
        **_domains(analysis, chosen),
    }
    return EnsembleForPage(_file(path, analysis, chosen), facts)


def _chosen(analysis: Analysis, wanted: list[int], most_bytes: int) -> np.ndarray:
    """Places of the frames that are handed over: all, or some evenly and those that are wanted."""
    count = len(analysis.frames)
    room = max(LEAST_FRAMES, most_bytes // (24 * len(analysis.universe.atoms)))
    if count <= room:
        return np.arange(count)
    evenly = np.linspace(0, count - 1, max(2, room - len(wanted))).astype(int)
    return np.union1d(evenly, np.searchsorted(analysis.frames, wanted))


def _file(path: Path, analysis: Analysis, chosen: np.ndarray) -> bytes:
    """As it is, or with the chosen frames alone."""
    frames = analysis.source
    source = frames.paths[0] if isinstance(frames, EnsembleFrames) else path
    if source == path and len(chosen) == len(analysis.frames):
        return path.read_bytes()
    places = {int(analysis.frames[k]): int(k) for k in chosen}
    with tempfile.TemporaryDirectory(prefix="pliant-") as folder:
        output = Path(folder) / "thinned.h5md"
        write_thinned(
            source, output, analysis.frames[chosen], lambda k: analysis.positions(places[k])
        )
        return output.read_bytes()


def _shapes(path: Path, analysis: Analysis) -> dict[str, Any]:
    """Frames that stand for all: one a shape of sampler `reach`, else by k-medoids."""
    drawn = analysis.observable("sampler")
    if drawn is not None and drawn.any():
        with contextlib.suppress(OptionError):  # it has no other shapes
            found = representatives(str(path), shapes=True)
            words = [f"shape of {count} frames" for count in found.nearest]
            return _rows(
                "Other shapes",
                "One frame for each shape that is none of the start.",
                found.frames,
                words,
            )
    count = min(MOST_SHAPES, len(analysis.frames) // 2)
    if count < 2:
        return {}
    found = representatives(str(path), count)
    words = [f"nearest to {count} frames" for count in found.nearest]
    about = (
        f"Frames that stand for all: one is {found.mean_distance:.1f} Å off on average. How often "
        "a shape occurs is not known."
    )
    return _rows("Representatives", about, found.frames, words)


def _rows(title: str, about: str, frames: np.ndarray, words: list[str]) -> dict[str, Any]:
    rows = [{"frame": int(frame), "text": text} for frame, text in zip(frames, words, strict=True)]
    return {"title": title, "about": about, "rows": rows}


def _domains(analysis: Analysis, chosen: np.ndarray) -> dict[str, Any]:
    """Domains and their turns; or why there are none to show."""
    try:
        for part in flexible.measure(analysis):
            analysis = analysis.having(part)
    except (ValueError, Error) as error:
        return {"noDomains": str(error)}
    if RigidDomains not in analysis:
        return {"noDomains": "domains are looked for in chains of 20 residues or more that move"}
    found = analysis[RigidDomains].found
    if found.count < 2:
        one = "all of it moves as one piece"
        return {"noDomains": one if found.count else "no reproducible domains were found"}
    of_unit, units = analysis[RigidDomains].of_unit, analysis[Units]
    of_joint = _of_joints(analysis, of_unit)
    names = [named_stretches(analysis, of_unit == k) for k in range(found.count)]
    sites = units.atoms[np.unique(units.unit, return_index=True)[1]]
    frames = _turned(analysis, chosen)
    positions = np.array([analysis.positions(k)[sites] for k in frames])
    ends = None if analysis.kind == ENSEMBLE else (0, len(frames) - 1)
    core = of_unit == 0
    turns = []
    for k in range(1, found.count):
        turn = largest_turn(positions, core, of_unit == k, ends)
        turns.append(_turn_told(analysis, k, turn, frames))
    return {
        "domain": of_joint.tolist(),
        "domainNames": names,
        "explained": found.explained,
        "core": sites[core].tolist(),
        "turns": turns,
    }


def _turned(analysis: Analysis, chosen: np.ndarray) -> np.ndarray:
    """Places of the frames in which turns are looked for: those that the domains were found in."""
    near = analysis.around_start
    frames = chosen if near is None else chosen[near[chosen]]
    if len(frames) < 2:
        frames = chosen
    return np.asarray(frames[:: -(-len(frames) // MOST_FRAMES_TURNED)])


def _of_joints(analysis: Analysis, of_unit: np.ndarray) -> np.ndarray:
    """(N,) the domain of each atom's residue."""
    owners = analysis[Units].owners
    of_residue = np.full(len(analysis.universe.residues), LOOSE)
    of_residue[owners] = of_unit
    return np.asarray(of_residue[analysis.universe.atoms.resindices])


def _turn_told(analysis: Analysis, domain: int, turn: Turn, frames: np.ndarray) -> dict[str, Any]:
    found = analysis[RigidDomains].found
    site_of = analysis[RigidDomains].sites
    labels = analysis[Units].labels
    hinges = [
        labels[site_of[one.site]]
        for one in found.hinges
        if domain in (found.domain[one.before], found.domain[one.after])
    ]
    return {
        "domain": domain,
        "angle": turn.angle,
        "shift": turn.shift,
        "point": turn.point.tolist(),
        "axis": turn.axis.tolist(),
        "from": int(analysis.frames[frames[turn.before]]),
        "to": int(analysis.frames[frames[turn.after]]),
        "hinges": hinges,
    }
