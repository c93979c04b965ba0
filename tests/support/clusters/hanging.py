# SPDX-License-Identifier: MIT
"""A clock for tests of jobs that hang: no job is too slow on it but the one that is meant."""

from types import SimpleNamespace

from pliant.checks.openmm import child


def clock_that_waits_for(job, monkeypatch):
    """Stands still until the job of this number, from 1, has begun: `progress` for run_jobs."""
    now = [0.0]
    monkeypatch.setattr(child, "time", SimpleNamespace(monotonic=lambda: now[0]))

    def begun(jobs, _):
        now[0] = 1e6 if jobs >= job else 0.0

    return begun
