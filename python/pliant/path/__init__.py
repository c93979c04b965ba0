# SPDX-License-Identifier: MIT
"""A way from one structure to another, each frame whole: ``pliant path``, ``pliant.path``.

The library finds it (``PathWalk``, src/pliant/path/path.hpp), by targeting: S. Wells et al., Phys.
Biol. 2 (2005) S127; D. W. Farrell, K. Speranskiy, M. F. Thorpe, Proteins 78 (2010) 2908.
"""

from typing import TYPE_CHECKING

from pliant._callable_package import make_callable

if TYPE_CHECKING:
    from pliant.path.found import MolecularPath
    from pliant.path.walk import path

__all__ = ["MolecularPath", "path"]

make_callable(__name__, {"path": "walk", "MolecularPath": "found"})
