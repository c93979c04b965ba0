# SPDX-License-Identifier: MIT
"""Known pairs of structures: does an ensemble of one contain the other, do domains repeat?"""
