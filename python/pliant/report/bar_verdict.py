# SPDX-License-Identifier: MIT
"""Whether the bars of all frames are whole, as a sentence."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pliant.base.verdict import Verdict
from pliant.measure.stages.names import bar_labels
from pliant.measure.stages.parts import Residuals

if TYPE_CHECKING:
    from pliant.measure.residuals import BarResiduals
    from pliant.measure.stages.analysis import Analysis


BRIEF = "fixed distances"  #: what bars are to those who do not know the word


def bar_verdict(analysis: Analysis) -> Verdict:
    """Judges the bars of all frames analysed, from the coordinates."""
    residuals = analysis.get(Residuals)
    if residuals is None:
        return Verdict(
            "open",
            "There are no bars in this file to judge.",
            analysis.skipped["bar residuals"],
            BRIEF,
        )
    within = residuals.found.within
    beyond = np.count_nonzero(~within)
    details = _worst(analysis, residuals)
    if beyond == 0:
        return Verdict("good", "Every bar of every frame is within tolerance.", details, BRIEF)
    broken = residuals.broken_promises
    count = f"{beyond} of {len(within)} frames"
    if broken is None:
        return Verdict("bad", f"{count} have a bar beyond tolerance.", details)
    if broken.any():
        called = f"{np.count_nonzero(broken)} of which the run calls converged"
        sentence = f"{count} have a bar beyond tolerance, {called}."
        return Verdict("bad", sentence, details)
    sentence = f"{count} have a bar beyond tolerance; the run says so of each."
    return Verdict("mixed", sentence, details)


def tolerance_text(residuals: BarResiduals) -> str:
    """The tolerance with its unit."""
    if residuals.tolerance_length > 0:
        return f"{residuals.tolerance_length:g} Å"
    return scientific(residuals.tolerance, 0)


def scientific(value: float, digits: int = 2) -> str:
    """A small number for readers: 9.97 × 10⁻⁷; for 10⁻⁶ sharp only the power."""
    mantissa, exponent = f"{value:.{digits}e}".split("e")
    power = "10" + str(int(exponent)).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
    if value == 0:
        return "0"
    return power if mantissa == "1" else f"{mantissa} × {power}"


def _worst(analysis: Analysis, part: Residuals) -> str:
    residuals, found = part.measured, part.found
    k = int(np.argmax(found.max_relative))
    bar = residuals.bars[found.worst_bar[k]]
    (name,) = bar_labels(analysis.universe.atoms, [bar])
    where = f"frame {analysis.frames[k]}"
    if analysis.steps is not None:
        where += f" (step {analysis.steps[k]})"
    return (
        f"The worst is off by {scientific(found.max_relative[k])} of its length (tolerance "
        f"{tolerance_text(residuals)}): bar {name} in {where}. Measured from the "
        f"{'double' if residuals.precision == 'float64' else 'single'}-precision "
        f"coordinates in the file{_rounded(residuals.rounded_to)}."
    )


def _rounded(unit: float) -> str:
    """What the file says of coordinates that the run had rounded before they were written."""
    return f", which are rounded to {scientific(unit)} Å; that much is allowed for" if unit else ""
