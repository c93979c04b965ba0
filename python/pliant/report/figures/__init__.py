# SPDX-License-Identifier: MIT
"""What figures of reports share, and how they are drawn beside other work."""
