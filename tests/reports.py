"""Reports for tests that need one, whatever the judge would say."""

from __future__ import annotations

from sceneweaver.verify import Report

COUNTS = (
    "requested",
    "placed",
    "dropped",
    "collisions",
    "out_of_bounds",
    "unsupported",
    "blocked_zones",
    "blocked_openings",
)


def empty_report() -> Report:
    """A valid report that counts nothing."""
    return Report(valid=True, **dict.fromkeys(COUNTS, 0))
