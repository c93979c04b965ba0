# SPDX-License-Identifier: MIT
"""Domains that repeat: what the report says of them."""
