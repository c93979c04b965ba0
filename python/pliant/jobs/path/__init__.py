# SPDX-License-Identifier: MIT
"""A way from one structure to another, each frame whole: ``pliant path``, ``pliant.path``.

The library finds it (``PathWalk``, src/pliant/path/path.hpp), by targeting: S. Wells et al., Phys.
Biol. 2 (2005) S127; D. W. Farrell, K. Speranskiy, M. F. Thorpe, Proteins 78 (2010) 2908.
"""
