# SPDX-License-Identifier: MIT
"""What the frames of a file are: independent draws, a path of pushes or between structures, or
something of others."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pliant.analyse.found import ENSEMBLE, PATH, TRAJECTORY, TRANSITION
from pliant.analysis.flexibility import numbered_blocks, path_blocks

if TYPE_CHECKING:
    from pliant.analyse.study import Study

#: numbers of frames of `pliant sample` are white within blocks of so many
WHITE = 100

SENTENCES = {
    ENSEMBLE: (
        "An ensemble: frames are independent and show what can move. How often a shape occurs is "
        "not known, and how far frames go overall was an input."
    ),
    PATH: (
        "Not an ensemble: each frame is the one before, pushed and resolved. How far atoms got "
        "depends on the pushes and on how many there were, so these fluctuations are not a "
        "property of the molecule. For those, see pliant sample."
    ),
    TRANSITION: (
        "A path from one structure to another: the frames are in order, and show that there is a "
        "way. They say nothing about time, rates, or how often a shape occurs; the fluctuations "
        "are those of the path, not a property of the molecule. The 3-D view plays it."
    ),
    TRAJECTORY: (
        "A trajectory of another program: its fluctuations are taken as they are; errors come from "
        "blocks of frames that are longer than the correlation time of the slowest motion."
    ),
}


def kind_of(study: Study) -> str:
    """ENSEMBLE, PATH, TRANSITION or TRAJECTORY, by what the file tells of itself."""
    told = study.record.parameters if study.record else {}
    if "path/end" in told:
        return TRANSITION
    sampler = told.get("sample/sampler")
    if sampler is not None:
        return PATH if sampler == "walk" else ENSEMBLE
    return PATH if any(name.startswith("run/") for name in told) else TRAJECTORY


def frame_blocks(study: Study) -> list[np.ndarray]:
    """Blocks of frames that count as independent: the white ones of an ensemble, else stretches
    longer than the memory of the first three principal components."""
    if study.kind == ENSEMBLE:
        numbers = study.frames if study.steps is None else study.steps
        return numbered_blocks(np.asarray(numbers), WHITE)
    if study.pca is None or study.pca_stride > 1:
        return path_blocks(np.arange(len(study.frames), dtype=float))
    return path_blocks(study.pca.results.projections[:, :3])
