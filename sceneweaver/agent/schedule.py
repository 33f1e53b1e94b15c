"""How the time limit of a design is divided: search, judgement, files, pictures and the page.

What comes after the search is estimated, for a room of so many objects, and kept from the search; what one part does
not use goes to the next. Estimates are seconds on a machine on which a run takes `STARTING` to start up, times how much
longer that took here: it measures how fast this machine is just now.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sceneweaver.export import format_named

STARTING = 3.5
"""Seconds in which a run starts up and reads its request where the estimates were measured."""

EXPECTED, GROWTH = 80, 20
"""Objects of a room that is not there yet, and how many more there may be at the end than in the best so far."""

JUDGEMENT, SCENE, PAGE, EXIT = (0.4, 0.009), (0.2, 0.002), (0.7, 0.006), (0.9, 0.0)
"""Seconds for a room and for each of its objects: the last touch and what opens; scene and metrics; the report; the end
of the process."""

OVERVIEWS, EYE_LEVEL = (2.6, 0.003), (5.0, 0.028)
"""The same for the smallest pictures from above and at eye level, once their kernels are there."""

SLOWEST = 4.0
"""How much slower than there this machine is taken to be at most: a start may have waited for a disk."""

LEAST = 2.0
"""Seconds that are kept for writing the results at least."""

MOST = 0.5
"""Share of the time after starting up that is kept for what comes after the search at most."""


@dataclass(frozen=True)
class Schedule:
    """About how long each part after the search takes, in seconds.

    Attributes:
        started: seconds that it took to start up and to read the request.
        objects: in the room at the end.
        formats: that are written for other tools.
        pictures: whether pictures and the report are.
    """

    started: float = 0.0
    objects: int = EXPECTED
    formats: Sequence[str] = ()
    pictures: bool = True

    @property
    def judgement(self) -> float:
        """The last touch, and what physics and doors say."""
        return self._of(*JUDGEMENT)

    @property
    def drafts(self) -> float:
        """The smallest pictures."""
        return self._of(*OVERVIEWS) + self._of(*EYE_LEVEL) if self.pictures else 0.0

    @property
    def page(self) -> float:
        """The report."""
        return self._of(*PAGE) if self.pictures else 0.0

    @property
    def files(self) -> float:
        """Scene, metrics, and the files for other tools."""
        return self._of(*SCENE) + sum(self._of(*format_named(name).seconds) for name in self.formats)

    @property
    def exit(self) -> float:
        """The end of the process."""
        return self._of(*EXIT)

    def kept(self, limit: float) -> float:
        """Seconds of a time limit [s] that are kept from the search."""
        wanted = self.judgement + max(LEAST, self.files + self.drafts + self.page + self.exit)
        return min(MOST * max(0.0, limit - self.started), wanted)

    def _of(self, room: float, each: float) -> float:
        return (room + each * self.objects) * min(max(1.0, self.started / STARTING), SLOWEST)
