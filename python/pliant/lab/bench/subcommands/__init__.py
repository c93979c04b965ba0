# SPDX-License-Identifier: MIT
"""What pliant lab bench measures: a module for each subcommand, imported when it is asked for.

Each has ``DESCRIPTION`` and ``EPILOG`` of its help, ``OPTIONS`` (what ``add_argument`` gets, by
name; ``dest`` is a parameter of ``measure``), ``measure(**options, progress)``, which returns
``Results``, and, where these can be drawn, ``PICTURE``: a module with ``draw(results, path)``, and
what it draws.
"""
