# SPDX-License-Identifier: MIT
"""One command from a structure to answers: ``pliant study``, the function ``pliant.study``."""

from typing import TYPE_CHECKING

from pliant._callable_package import make_callable

if TYPE_CHECKING:
    from pliant.study.studied import Study
    from pliant.study.suite import study

__all__ = ["Study", "study"]

make_callable(__name__, {"Study": "studied", "study": "suite"})
