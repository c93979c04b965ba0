# SPDX-License-Identifier: MIT
"""A trajectory checked against OpenMM: ``pliant check``, and the function ``pliant.check``."""

from typing import TYPE_CHECKING

from pliant._callable_package import make_callable

if TYPE_CHECKING:
    from pliant.check.check_report import CheckReport
    from pliant.check.suite import check

__all__ = ["CheckReport", "check"]

make_callable(__name__, {"check": "suite", "CheckReport": "check_report"})
