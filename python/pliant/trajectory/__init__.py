# SPDX-License-Identifier: MIT
"""Trajectories: their files, their frames, and the objects of other packages that hold frames."""

from typing import TYPE_CHECKING

from pliant.base.late_names import late_names

if TYPE_CHECKING:
    from pliant.trajectory.record import RunRecord, read_record
    from pliant.trajectory.recorded_contacts import RecordedContacts

__all__ = ["RecordedContacts", "RunRecord", "read_record"]

__getattr__ = late_names(
    __name__,
    {
        "RecordedContacts": "pliant.trajectory.recorded_contacts",
        "RunRecord": "pliant.trajectory.record",
        "read_record": "pliant.trajectory.record",
    },
)
