"""The pictures of a finished design: small ones first, then as good as there is time for, each written when drawn."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from sceneweaver.io import SceneWeaverError, own_folder, whole
from sceneweaver.runtime.deadline import Deadline, TimeUp
from sceneweaver.scene import Scene

from .faults import fault

if TYPE_CHECKING:
    from PIL.Image import Image

    from sceneweaver.render import EyeLevel

FOLDER = "views"
"""Where the pictures are, in the folder of a run."""

PACKING = 4
"""How hard pictures are packed, 0 to 9: harder takes twice the time for a few hundredths of the size."""

HANGS = 0.3
"""Seconds after which a picture or a file is given up that comes to no checkpoint: less than the report takes."""

VIEWS = (("top", "top_annotated"), ("corner",))
"""The views from above, those together that are drawn from one picture."""

SIZES = {(320, 240): 1.0, (640, 480): 2.5, (1280, 960): 6.0}
"""Pixels of the views from above, and how long they take by comparison; the smaller ones for when time is short."""

EYE_LEVEL = {
    ((320, 240), "draft"): 1.0,
    ((640, 480), "draft"): 3.5,
    ((960, 720), "draft"): 7.0,
    ((960, 720), "normal"): 24.0,
}
"""Pixels and quality of the pictures at eye level, and how long they take by comparison, worst first."""

FIRST = ((640, 480), "draft")
"""The first picture that there is of a room."""

PLENTY = 30.0
"""Seconds for pictures from which on the first is drawn before all others and the files for other tools."""

_RANK = {level: rank for rank, level in enumerate(EYE_LEVEL)}

SAFE = 1.3
"""How much more time than expected there has to be for a better picture to be begun."""


@dataclass
class Album:
    """The views of a scene, by name, in ``views``; each is in the folder of the run as soon as it is drawn.

    ``page`` is about how many seconds [s] the report takes: so many are left at the end. With ``hero`` only the view at
    eye level that shows the room best is drawn. ``notes`` say what is worse than it would be with more time, ``broken``
    what broke down.
    """

    scene: Scene
    load: Callable
    device: str
    folder: Path
    deadline: Deadline
    page: float
    hero: bool = False
    views: dict[str, Image] = field(default_factory=dict)
    notes: tuple[str, ...] = ()
    broken: tuple[str, ...] = ()
    _size: tuple[int, int] | None = None
    _took: float = 0.0
    _room: EyeLevel | None = None
    _level: tuple[tuple[int, int], str] | None = None
    _levels: dict[str, tuple[tuple[int, int], str]] = field(default_factory=dict)
    _took_at_eye_level: float = 0.0
    _failed: set[str] = field(default_factory=set)

    @property
    def missing(self) -> tuple[str, ...]:
        """Views that are not there, in an order in which to look at them."""
        from sceneweaver.render.viewpoints import EYE_VIEWS

        at_eye_level = EYE_VIEWS
        if self.hero:
            at_eye_level = (self._room.hero,) if self._room is not None else EYE_VIEWS[:1]
        overviews = (view for some in VIEWS for view in some)
        return tuple(view for view in (*at_eye_level, *overviews) if view not in self.views)

    @property
    def left(self) -> float:
        """Seconds for pictures."""
        return self.deadline.before(self.page).left

    def begin(self) -> None:
        """Draw small views from above, where there is a limit; without one the large ones come at once."""
        if not math.isinf(self.left):
            self._overviews(next(iter(SIZES)))

    def enlarge(self) -> None:
        """Draw the largest views from above that there is time for: the smaller ones told how long they take here."""
        best = list(SIZES)[-1]
        for size in reversed(SIZES):
            if self._size == size or self.broken:
                break
            if self._worth(self._took, SIZES[size], self._size and SIZES[self._size]) and self._overviews(size):
                break
        if self._size is not None and self._size != best:
            self.notes += (f"time was short, so the pictures have {self._size[0]} x {self._size[1]} pixels",)

    def begin_with_hero(self) -> bool:
        """Draw the best view at eye level as a draft, where there is a limit that leaves plenty of time; whether it is
        there."""
        return PLENTY <= self.left < math.inf and self._at_eye_level(FIRST, alone=True)

    def begin_at_eye_level(self) -> None:
        """Draw the room at eye level as a draft, where there is a limit."""
        if not math.isinf(self.left):
            self._at_eye_level(next(iter(EYE_LEVEL)))

    def improve_at_eye_level(self) -> None:
        """Draw it as well as there is time for: the drafts told how long it takes here."""
        for level in reversed(EYE_LEVEL):
            if self._level == level or self.broken:
                break
            if self._worth(self._took_at_eye_level, EYE_LEVEL[level], self._level and EYE_LEVEL[self._level]):
                self._at_eye_level(level)
                break

    def _worth(self, took: float, cost: float, before: float | None) -> bool:
        """Whether there is time for better pictures, after others that took so many seconds."""
        return math.isinf(self.left) or (before is not None and SAFE * took * cost / before <= self.left)

    def _overviews(self, size: tuple[int, int]) -> bool:
        """Draw all views from above in a size; whether they are there."""
        from sceneweaver.render import draw_rooms

        def draw() -> None:
            for views in VIEWS:
                self._keep(draw_rooms(self.scene, self.load, views, *size, device=self.device))

        began = time.monotonic()
        if self._done("pictures", draw):
            self._size, self._took = size, time.monotonic() - began
        return self._size == size

    def _at_eye_level(self, level: tuple[tuple[int, int], str], *, alone: bool = False) -> bool:
        """Draw views at eye level that are not there as good; ``alone``: the best of them. Whether they are there."""
        from sceneweaver.render import EyeLevel, Quality

        each: list[float] = []

        def draw() -> None:
            room = self._room = self._room or EyeLevel(self.scene, self.load, device=self.device)
            others = [] if alone or self.hero else [view for view in room.cameras if view != room.hero]
            views = [room.hero, *others]
            for view in views:
                if view in self._levels and _RANK[self._levels[view]] >= _RANK[level]:
                    continue
                began = time.monotonic()
                self._keep({view: room.draw(view, *level[0], getattr(Quality, level[1])())})
                self._levels[view] = level
                each.append((time.monotonic() - began) * len(views))

        if not self._done("pictures at eye level", draw):
            return False
        if each and (self.hero or not alone):
            self._level, self._took_at_eye_level = level, min(each)  # the first one works out what all share
        return True

    def _done(self, what: str, draw: Callable[[], None]) -> bool:
        """Draw in time; whether all is drawn. What broke down once is not tried again."""
        if self.left <= 0.0 or what in self._failed:
            return False
        try:
            with self.deadline.before(self.page).enforced(patience=HANGS):
                draw()
        except SceneWeaverError:
            raise
        except TimeUp:
            return False
        except Exception as error:
            self.broken += (fault(what, error),)
            self._failed.add(what)
            return False
        return True

    def _keep(self, drawn: dict[str, Image]) -> None:
        folder = own_folder(self.folder / FOLDER)
        for name, picture in drawn.items():
            with whole(folder / f"{name}.png", within=self.folder) as path:
                picture.save(path, "PNG", compress_level=PACKING)
            self.views[name] = picture
