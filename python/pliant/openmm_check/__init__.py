# SPDX-License-Identifier: MIT
"""A trajectory checked against OpenMM: ``pliant check``, and the function ``pliant.check``."""

from pliant.openmm_check.findings import Finding
from pliant.openmm_check.suite import CheckReport, check

__all__ = ["CheckReport", "Finding", "check"]
