"""One scene, judged: for each figure a numerator and a denominator, or why there is none."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np

from sceneweaver.assets.placed import Load
from sceneweaver.io import InputError
from sceneweaver.io.messages import clean
from sceneweaver.runtime.deadline import NEVER, Deadline, TimeUp
from sceneweaver.verify import check
from sceneweaver.verify.report import Report
from sceneweaver.verify.solids import Placed

from . import moving, openings, standing
from .candidate import Candidate, guessed_sizes
from .lines import judged
from .metrics import ABSENT, METRICS
from .requested import COLUMNS, Annotated
from .sizing import sizes_of
from .staying import stability

PLAN = 32
"""Cells along a side of the plan by which layouts are compared."""

_LINES = dict(zip(COLUMNS, ("counts_met", "attributes_met", "object_relations_met", "room_relations_met"), strict=True))


@dataclass(frozen=True)
class SceneRow:
    """What was measured of a scene.

    Attributes:
        system, scene: names.
        format: of its file.
        room: kind of room.
        prompt: the request that it was made for.
        figures: by metric the numerator and the denominator of the scene.
        missing: by metric why there is none.
        lacks: all that the scene's file does not say.
        depths: of its penetrations over 1 mm [mm].
        categories: how many objects there are of each.
        plan: what is covered in plan, `PLAN` rows of cells as integers, bit by bit.
        guessed: how many objects have a size that is in no file.
        notes: what was assumed, and what went wrong.
        error: why nothing could be measured.
        seconds: that it took.
        key: of scene and settings, by which a run goes on.
    """

    system: str
    scene: str
    format: str = ""
    room: str = ""
    prompt: str = ""
    figures: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    missing: Mapping[str, str] = field(default_factory=dict)
    lacks: tuple[str, ...] = ()
    depths: tuple[float, ...] = ()
    categories: Mapping[str, int] = field(default_factory=dict)
    plan: tuple[int, ...] = ()
    guessed: int = 0
    notes: tuple[str, ...] = ()
    error: str = ""
    seconds: float = 0.0
    key: str = ""

    def value(self, key: str) -> float | None:
        """A figure of the scene; None where there is none."""
        top, bottom = self.figures.get(key, (0.0, 0.0))
        return top / bottom if bottom else None

    def to_dict(self) -> dict[str, Any]:
        """Plain JSON data."""
        return asdict(self)

    @classmethod
    def from_dict(cls, data: Mapping[str, Any]) -> SceneRow:
        """From `to_dict`.

        Raises:
            TypeError, ValueError, KeyError: data that is none.
        """
        more = {name: tuple(data.get(name, ())) for name in ("lacks", "depths", "plan", "notes")}
        figures = {str(k): (float(a), float(b)) for k, (a, b) in data["figures"].items()}
        return cls(**{**data, **more, "figures": figures})


def judge_scene(
    system: str,
    candidate: Candidate,
    *,
    simulate: bool = True,
    asked: Annotated | None = None,
    load: Load | None = None,
    time_limit: float | None = None,
    key: str = "",
) -> SceneRow:
    """Measure all that can be measured of a scene.

    Args:
        system: its name.
        candidate: the scene.
        simulate: whether it is simulated by MuJoCo.
        asked: the annotated request that it was made for.
        load: from asset id to asset; None: the library of this user.
        time_limit: seconds after which it is given up; the row then says so.
        key: kept in the row.
    """
    began = time.perf_counter()
    scene = candidate.scene
    named: dict[str, Any] = {
        "system": system,
        "scene": candidate.name,
        "format": candidate.format,
        "room": scene.room.type,
        "prompt": scene.prompt or (asked.text if asked is not None else ""),
        "key": key,
    }
    deadline = NEVER if time_limit is None else Deadline(time.monotonic() + time_limit)
    found = _Figures(candidate, simulate, asked, load)
    error = ""
    try:
        with deadline.enforced():
            found.measure()
    except TimeUp:
        error = f"{time_limit:g} s were not enough"
    except (InputError, ArithmeticError, ValueError) as problem:
        error = clean(str(problem)) or type(problem).__name__
    if error:
        return SceneRow(**named, error=error, seconds=time.perf_counter() - began)
    return SceneRow(
        **named,
        figures=found.figures,
        missing=found.missing,
        lacks=tuple(candidate.lacks.values()),
        depths=tuple(found.depths),
        categories=dict(Counter(sorted(o.category for o in scene.objects))),
        plan=found.plan,
        guessed=len(guessed_sizes(scene)),
        notes=(*candidate.notes, *found.notes),
        seconds=time.perf_counter() - began,
    )


class _Figures:
    """The figures of a scene while they are found."""

    def __init__(self, candidate: Candidate, simulate: bool, asked: Annotated | None, load: Load | None) -> None:
        self.scene, self.lacks, self.asked, self.load = candidate.scene, dict(candidate.lacks), asked, load
        if not simulate:
            self.lacks["physics"] = ABSENT["physics"]
        if asked is None:
            self.lacks["prompts"] = ABSENT["prompts"]
        self.figures: dict[str, tuple[float, float]] = {}
        self.missing: dict[str, str] = {}
        self.depths: list[float] = []
        self.notes: list[str] = []
        self.plan: tuple[int, ...] = ()

    def measure(self) -> None:
        """Find all."""
        if not self.scene.objects:
            self.lacks["sizes"] = ABSENT["objects"]
        for metric in METRICS:
            reason = next((self.lacks[need] for need in metric.needs if need in self.lacks), None)
            if reason is not None:
                self.missing[metric.key] = reason
        self._put("objects", len(self.scene.objects), 1)
        placed = Placed.of(self.scene)
        report = check(self.scene, walkable=False)
        self._solids(report)
        self._geometry(placed)
        self._sizes()
        self._stability()
        if self.asked is not None:
            self._requested(report, self.asked)
        if "sizes" not in self.lacks:
            self.plan = plan_of(placed)

    def _put(self, key: str, top: float, bottom: float, otherwise: str = "there are none") -> None:
        if key in self.missing:
            return
        if bottom:
            self.figures[key] = (float(top), float(bottom))
        else:
            self.missing[key] = otherwise

    def _solids(self, report: Report) -> None:
        collisions = [v for v in report.violations if v.kind == "collision"]
        involved = {name for v in collisions for name in v.objects}
        if "sizes" not in self.lacks:
            self.depths = [1e3 * v.amount for v in collisions]
        self._put("out_of_bounds", report.out_of_bounds, 1)
        self._put("collisions", len(collisions), 1)
        self._put("clean_scenes", not collisions and not report.out_of_bounds, 1)
        self._put("penetrating_objects", len(involved), len(self.scene.objects))
        self._put("penetrating_scenes", bool(collisions), 1)

    def _geometry(self, placed: Placed) -> None:
        if "sizes" in self.lacks:
            return
        held = standing.supported(placed)
        self._put("supported_objects", sum(held), len(held))
        if "room" in self.lacks:
            return
        free = moving.navigability(placed)
        self._put("navigability", free or 0.0, free is not None, "the room is too large for the floor grid")
        ahead = moving.accessibility(placed)
        self._put("accessibility", sum(ahead), len(ahead), "nothing is used from a side")
        before = openings.openings(placed)
        self._put("openings_clear", sum(not o.by for o in before), len(before), "there are no doors or windows")
        self._put("openings_covered", sum(o.share for o in before), len(before), "there are no doors or windows")

    def _sizes(self) -> None:
        if "sizes_usual" in self.missing:
            return
        guessed = guessed_sizes(self.scene)
        if guessed and len(guessed) == len(self.scene.objects):
            self.missing |= dict.fromkeys(("sizes_usual", "size_log_ratio"), ABSENT["sizes"])
            return
        found = sizes_of(self.scene, guessed)
        self._put("sizes_usual", found.usual, found.known, "no object is of a known category")
        self._put("size_log_ratio", found.off, found.known, "no object is of a known category")

    def _stability(self) -> None:
        if "stable_objects" in self.missing:
            return
        try:
            stayed = stability(self.scene, self.load)
        except InputError as error:
            self.missing["stable_objects"] = f"not simulated: {clean(str(error))}"
            return
        if stayed.diverged:
            self.notes.append("the simulation diverged: no object counts as stable")
        self._put("stable_objects", stayed.stable, stayed.free, "nothing may move")

    def _requested(self, report: Report, asked: Annotated) -> None:
        lines = judged(self.scene, report, asked)
        for metric, key in _LINES.items():
            own = [met for met in lines if met.line.metric == metric and met.holds is not None]
            self._put(key, sum(bool(met.holds) for met in own), len(own), "its request has no such line")


def plan_of(placed: Placed) -> tuple[int, ...]:
    """What is covered in plan, `PLAN` rows of as many cells over the room's box: one integer a row, a bit a cell."""
    import shapely

    outline = np.asarray(placed.scene.room.outline, dtype=float)
    low, size = outline.min(axis=0), np.ptp(outline, axis=0)
    steps = (np.arange(PLAN) + 0.5) / PLAN
    x, y = np.meshgrid(low[0] + steps * size[0], low[1] + steps * size[1])
    taken = shapely.union_all(placed.parts.polygons)
    shapely.prepare(taken)
    cells = shapely.contains_xy(taken, x.ravel(), y.ravel()).reshape(PLAN, PLAN)
    return tuple(int("".join("1" if cell else "0" for cell in row), 2) for row in cells)
