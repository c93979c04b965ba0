# SPDX-License-Identifier: MIT
"""What the verdict of a check speaks of: a tick must not stand for more than was looked at."""

from __future__ import annotations

from dataclasses import dataclass, field

from pliant.base.console import counted
from pliant.checks.force_field.minimised import ForceFieldReport, listed
from pliant.trajectory.h5md import FramesOfH5md


@dataclass(frozen=True)
class Coverage:
    """Frames and parts of the molecule that were looked at."""

    frames: int  #: whose bars were measured
    md_starts: int = 0  #: frames that a force field minimised
    #: residues and molecules that the force field was asked without: how many of each name
    left_out: dict[str, int] = field(default_factory=dict)
    ligands: list[str] = field(default_factory=list)  #: that it was asked with, by label

    @property
    def without(self) -> str:
        """ "2 CSO, 1 XK2"; "" where nothing was left out."""
        return listed(self.left_out)

    @property
    def text(self) -> str:
        """ "bars of all 20 frames; MD starts: 3 frames, the protein alone, without 1 XK2"."""
        bars = f"bars of all {self.frames} frames" if self.frames > 1 else "bars of the frame"
        if not self.md_starts:
            return bars
        alone = ", the protein alone" if self.left_out else ""
        whole = f", with {', '.join(self.ligands)}" if self.ligands else alone
        without = f", without {self.without}" if self.left_out else ""
        return f"{bars}; MD starts: {counted(self.md_starts, 'frame')}{whole}{without}"


def coverage(recording: FramesOfH5md, found: ForceFieldReport | None) -> Coverage:
    """Of a check whose force field found `found`, if it was asked."""
    if found is None or found.why_not:
        return Coverage(len(recording))
    return Coverage(len(recording), len(found.usable), found.left_out, found.ligands)
