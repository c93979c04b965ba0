# SPDX-License-Identifier: MIT
"""How frames of an ensemble were drawn: the values of /observables/sampler."""

from __future__ import annotations

#: Names by value; "other" are those of samplers that draw in one way.
DRAWN_BY = ("other", "modes", "wide modes", "turns", "turns with modes", "pocket")
#: Frames up to this value are around the start; others go further.
DRAWN_ALONG_MODES = 1
