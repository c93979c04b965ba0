# SPDX-License-Identifier: MIT
"""The report of an ensemble in shards."""
