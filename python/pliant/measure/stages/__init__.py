# SPDX-License-Identifier: MIT
"""The stages of an analysis: each measures all frames of a trajectory and returns a part."""
