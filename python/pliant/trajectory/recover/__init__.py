# SPDX-License-Identifier: MIT
"""What can be read of a damaged trajectory, in a file that is complete again."""
