# SPDX-License-Identifier: MIT
"""Open questions of the thesis: one module each, with TITLE and answer()."""
