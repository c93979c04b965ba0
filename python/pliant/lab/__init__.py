# SPDX-License-Identifier: MIT
"""The laboratory: what measures Pliant and what it is compared with. Using Pliant needs none of it.

``bench`` and ``experiment`` are the subcommands of these names, ``peers`` has other programs work.
"""
