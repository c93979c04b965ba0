# SPDX-License-Identifier: MIT
"""What pliant lab bench measures: a module for each subcommand, found by its name.

Each has ``ORDER`` (where its line stands in the help), ``SUMMARY`` (that line), ``DESCRIPTION`` and
``EPILOG`` of its own help, ``add_options(parser)``, and ``run(arguments)``, which returns the exit
code. What takes long to import is imported in these two.
"""
