# SPDX-License-Identifier: MIT
"""Ensembles past one process: shards of walkers, made by Dask or a queue, read as one trajectory.

A *plan* says what is asked for, and is kept in the folder as ``ensemble.pliant``. Each *shard* is a
file of its own, whose bits depend on the plan and the numbers of its walkers alone. The *manifest*
lists the shards that are complete.
"""
