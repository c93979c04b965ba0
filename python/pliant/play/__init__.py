# SPDX-License-Identifier: MIT
"""``pliant play``: a page in a browser in which a person pulls on a molecule.

The page is one file, ``pliant.html`` beside this one, which ``./dev play`` makes of ``apps/play``.
"""
