# SPDX-License-Identifier: MIT
"""The sections of the report of one file: each measures something, and has the words for it."""
