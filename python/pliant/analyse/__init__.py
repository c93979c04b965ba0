# SPDX-License-Identifier: MIT
"""A trajectory as figures, tables and a page: ``pliant analyse``, the function ``pliant.analyse``.

The analyses themselves, for use with MDAnalysis, are in ``pliant.analysis``.
"""

from typing import TYPE_CHECKING

from pliant._callable_package import make_callable

if TYPE_CHECKING:
    from pliant.analyse.suite import AnalysisReport, analyse

__all__ = ["AnalysisReport", "analyse"]

make_callable(__name__, {"AnalysisReport": "suite", "analyse": "suite"})
