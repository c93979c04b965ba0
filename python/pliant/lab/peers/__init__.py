# SPDX-License-Identifier: MIT
"""Other programs at work beside ours: rulers for both sides, and OpenMM in a child process."""
