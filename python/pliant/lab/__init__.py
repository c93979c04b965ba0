# SPDX-License-Identifier: MIT
"""The laboratory: what measures Pliant, and the thesis tried again. Using Pliant needs none of it.

``bench`` and ``experiment`` are the subcommands of these names, ``peers`` has other programs work,
``validity`` measures ensembles. A wheel can leave all of it away: ``python/wheel/README.md``.
"""
