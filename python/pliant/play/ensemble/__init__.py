# SPDX-License-Identifier: MIT
"""What the page shows of many frames and cannot find by itself: domains, their turns, shapes."""
