# SPDX-License-Identifier: MIT
"""OpenMM at work in processes of its own, which it may abort."""
