# SPDX-License-Identifier: MIT
"""What ``pliant rigidity`` found, as a page."""
