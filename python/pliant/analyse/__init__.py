# SPDX-License-Identifier: MIT
"""A trajectory as figures, tables and a page: ``pliant analyse``, the function ``pliant.analyse``.

The analyses themselves, for use with MDAnalysis, are in ``pliant.analysis``.
"""

from typing import TYPE_CHECKING

from pliant._callable_package import make_callable

if TYPE_CHECKING:
    from pliant.analyse.analysis import Analysis, AnalysisOptions
    from pliant.analyse.choose_representatives import Representatives, representatives
    from pliant.analyse.stages import analyse_trajectory
    from pliant.analyse.suite import AnalysisReport, analyse

__all__ = [
    "Analysis",
    "AnalysisOptions",
    "AnalysisReport",
    "Representatives",
    "analyse",
    "analyse_trajectory",
    "representatives",
]

make_callable(
    __name__,
    {
        "AnalysisReport": "suite",
        "Representatives": "choose_representatives",
        "Analysis": "analysis",
        "AnalysisOptions": "analysis",
        "analyse": "suite",
        "representatives": "choose_representatives",
        "analyse_trajectory": "stages",
    },
)
