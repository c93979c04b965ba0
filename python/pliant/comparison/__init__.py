# SPDX-License-Identifier: MIT
"""Our trajectory beside another program's: ``pliant compare``, the function ``pliant.compare``."""

from pliant.comparison.suite import ComparisonReport, compare

__all__ = ["ComparisonReport", "compare"]
