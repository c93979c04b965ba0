# SPDX-License-Identifier: MIT
"""The figures of a report: figure_table.py lists them."""
