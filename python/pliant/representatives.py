# SPDX-License-Identifier: MIT
"""A few frames that stand for all: ``pliant representatives``, ``pliant.representatives``."""

from typing import TYPE_CHECKING

from pliant._callable_package import make_callable

if TYPE_CHECKING:
    from pliant.analyse.choose_representatives import Representatives, representatives

__all__ = ["Representatives", "representatives"]

_MODULE = "pliant.analyse.choose_representatives"

make_callable(__name__, {"representatives": _MODULE, "Representatives": _MODULE})
