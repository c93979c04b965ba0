# SPDX-License-Identifier: MIT
"""A trajectory as figures, tables and a page: ``pliant analyse``, the function ``pliant.analyse``.

The analyses themselves, for use with MDAnalysis, are in ``pliant.analysis``.
"""

from typing import TYPE_CHECKING

from pliant._callable_package import make_callable

if TYPE_CHECKING:
    from pliant.analyse.choose_representatives import Representatives, representatives
    from pliant.analyse.stages import study_trajectory
    from pliant.analyse.study import Study, StudyOptions
    from pliant.analyse.suite import AnalysisReport, analyse

__all__ = [
    "AnalysisReport",
    "Representatives",
    "Study",
    "StudyOptions",
    "analyse",
    "representatives",
    "study_trajectory",
]

make_callable(
    __name__,
    {
        "AnalysisReport": "suite",
        "Representatives": "choose_representatives",
        "Study": "study",
        "StudyOptions": "study",
        "analyse": "suite",
        "representatives": "choose_representatives",
        "study_trajectory": "stages",
    },
)
