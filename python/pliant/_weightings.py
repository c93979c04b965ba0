# SPDX-License-Identifier: MIT
"""What the thesis tried, for whoever tries it again."""

WEIGHTINGS = (0.5, 0.75, 1.0)  #: section 3.1
