# SPDX-License-Identifier: MIT
"""What else a molecule could look like: the other shapes in an ensemble."""
