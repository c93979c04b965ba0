# SPDX-License-Identifier: MIT
"""Ensembles past one process: shards of walkers, made by Dask or a queue."""
