"""Physics: the candidates of a room settled at once, beside MuJoCo C on one core."""

from __future__ import annotations

from benchmarks.judging import Judge
from benchmarks.layouts import designed, small
from benchmarks.results import Result
from benchmarks.settings import Settings
from benchmarks.worlds import measure, tabulate


def run(settings: Settings, judge: Judge) -> Result:
    """Let many layouts of a designed bedroom loose, and some of them by MuJoCo C on one core."""
    del judge  # MuJoCo C is the judge here
    count = settings.size(1024, 8)
    case = small(count, settings.seed) if settings.quick else designed(count, settings.device)
    seconds = 0.4 if settings.quick else 3.0
    return tabulate(measure(case, settings.device, settings.size(64, 4), seconds, settings.jobs))
