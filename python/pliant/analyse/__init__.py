# SPDX-License-Identifier: MIT
"""A trajectory as figures, tables and one HTML page: what ``pliant analyse`` writes."""

from pliant.analyse.stages import study_trajectory
from pliant.analyse.study import Study, StudyOptions

__all__ = ["Study", "StudyOptions", "study_trajectory"]
