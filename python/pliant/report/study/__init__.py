# SPDX-License-Identifier: MIT
"""One command from a structure to answers: ``pliant study``, ``pliant.study``."""
