# SPDX-License-Identifier: MIT
"""Our trajectory beside another program's: ``pliant compare``, the function ``pliant.compare``."""

from typing import TYPE_CHECKING

from pliant._callable_package import make_callable

if TYPE_CHECKING:
    from pliant.compare.comparison_report import ComparisonReport
    from pliant.compare.suite import compare

__all__ = ["ComparisonReport", "compare"]

make_callable(__name__, {"ComparisonReport": "comparison_report", "compare": "suite"})
