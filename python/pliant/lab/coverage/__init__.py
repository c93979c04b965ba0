# SPDX-License-Identifier: MIT
"""Whether the ensemble of one structure contains another known one: ``pliant bench coverage``."""
