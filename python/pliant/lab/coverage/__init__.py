# SPDX-License-Identifier: MIT
"""Whether the ensemble of a structure contains another known one: ``pliant lab bench coverage``."""
