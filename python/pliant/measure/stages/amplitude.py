# SPDX-License-Identifier: MIT
"""The amplitude that samples were asked for: an input, which no report gives as a result."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pliant._core import samplers


def asked_amplitude(parameters: Mapping[str, Any]) -> float | None:
    """The amplitude that was asked for by the parameters of a file, Angstrom.

    None where the frames are no samples, or of a sampler that is asked for none.
    """
    asked = parameters.get("sample/amplitude")
    if asked is None:
        return None
    without = [row.name for row in samplers() if not row.has_amplitude]
    # conformers go as far as their torsions turn: nothing is asked for
    return None if parameters.get("sample/sampler") in without else float(asked)
