"""Traces of life: chairs not quite pushed in, slippers by the bed, a bag by the desk, toys on the floor."""

from __future__ import annotations

import math
import random
from collections.abc import Iterator, Sequence
from typing import Any

from sceneweaver.assets import Wish
from sceneweaver.geometry.polygons import union
from sceneweaver.geometry.rotations import is_upright
from sceneweaver.knowledge.lived_in import Trace, traces
from sceneweaver.rules.design import limit
from sceneweaver.scene import InputError, Intent, Pose, Scene, SceneObject
from sceneweaver.scene.edits import Add, AnyEdit
from sceneweaver.scene.messages import show

from .base import Context, Proposal
from .carry import move, world
from .draft import groups_of
from .prior_program import decided_kinds
from .surface_scene import TIES, TILT, Surroundings

PULLED, TURNED = 0.06, math.radians(1.4)
"""How far [m] a chair stands back from its table at most, and how far it is turned: more looks like a mistake."""

CLEARANCE, WALL_GAP = 0.02, 0.03
"""Free space [m] around what lies on the floor, and to the walls."""

WAY = 0.9
"""Depth [m] before a door and beside its frame that stays free."""

OUTWARD = {"front": (1, 0), "back": (-1, 0), "left": (0, 1), "right": (0, -1)}
"""Direction of the sides of furniture, in its frame."""


class AddClutter:
    """Makes a finished room look lived-in; every edit by itself leaves it valid as far as a tool can tell."""

    name = "add_clutter"

    def propose(self, context: Context) -> Proposal:
        """Small shifts of chairs, then things on the floor; ``inputs`` may give the ``clutter`` in 0..1."""
        clutter = context.inputs.get("clutter", context.clutter)
        if isinstance(clutter, bool) or not isinstance(clutter, int | float) or not 0 <= clutter <= 1:
            raise InputError(f"clutter: {show(clutter)} is no number from 0 to 1")
        if clutter == 0 or context.brief.only or context.brief.density == "sparse":
            return Proposal(notes=("the room is left as it is",))
        rng = random.Random(f"{context.seed}/clutter")
        edits: list[AnyEdit] = [*_chairs(context.scene, clutter, rng)]
        floor = _Floor(context, rng)
        for trace in traces():
            if trace.clutter <= clutter and (not trace.rooms or context.room_type.name in trace.rooms):
                edits += floor.strewn(trace, clutter)
        return Proposal(edits=tuple(edits))


def _chairs(scene: Scene, clutter: float, rng: random.Random) -> Iterator[AnyEdit]:
    """Chairs at tables, a little back and turned, with what lies on them."""
    tied = {r.subject for r in scene.relations if r.type in TIES}
    for o in scene.objects:
        if o.id not in tied or "chair_group" not in groups_of(o.category) or not is_upright(o.pose.quaternion, TILT):
            continue
        if rng.random() < 0.75:
            back, turn = clutter * PULLED * rng.random(), TURNED * rng.uniform(-1, 1)
            yield from move(scene, {o.id: world(o.pose, -back, 0.0, 0.0, turn)})


class _Floor:
    """The free floor of a room, on which things are put down one by one."""

    def __init__(self, context: Context, rng: random.Random):
        import shapely

        self._context, self._rng = context, rng
        self._around = Surroundings(context.scene, context.room_type)
        self._decided = decided_kinds(context.brief)
        room = context.scene.room
        self._inside: Any = shapely.Polygon(room.outline).buffer(-WALL_GAP)
        gap = limit("door_frame", "gap")
        strips = [(room.walls[d.wall], d.offset - gap, d.width + 2 * gap, max(WAY, d.width)) for d in room.doors]
        shapes = [shapely.Polygon(wall.strip(start, width, 0.0, depth)) for wall, start, width, depth in strips]
        for o in context.scene.objects:
            low = [p.polygon for p in o.solids if o.pose.position[2] + p.z[0] < 0.6 and p.z[1] > 0.025]
            low += [z.polygon for z in o.zones if z.hard]
            shapes += [shapely.polygons(o.pose.frame.to_world(_array(p))) for p in low]
        valid = shapely.is_valid(shapes).tolist() if shapes else []
        self._taken: Any = union(s if good else s.buffer(0) for s, good in zip(shapes, valid, strict=True))

    def strewn(self, trace: Trace, clutter: float) -> Iterator[AnyEdit]:
        """Things of one kind of trace, each beside another piece of furniture as far as there are enough."""
        names = [n for n in trace.what if n not in self._decided and self._around.may_add(n)]
        places = list(self._places(trace))
        self._rng.shuffle(places)
        left = trace.count
        for anchor in places:
            if not left or not names:
                return
            if self._rng.random() > trace.chance:
                left -= 1
                continue
            obj = self._put(self._rng.choice(names), anchor, trace, clutter)
            if obj is not None:
                left -= 1
                yield Add(object=obj)

    def _places(self, trace: Trace) -> Iterator[tuple[Pose, tuple[float, float], Sequence[str]]]:
        """Frames and sizes (depth, width) [m] of what things may lie beside, with the sides."""
        room = self._context.scene.room
        if "door" in trace.beside:
            for door in room.doors:
                wall = room.walls[door.wall]
                x, y = wall.strip(door.offset + door.width / 2, 0.0, 0.0, 0.0)[0]
                nx, ny = wall.inward
                yield world(Pose(), x, y, 0.0, math.atan2(ny, nx)), (0.1, door.width + 0.1), ("left", "right")
        for o in self._context.scene.objects:
            if o.mount == "floor" and {o.category, *groups_of(o.category)} & set(trace.beside):
                for _ in range(1 + trace.count // 3):
                    yield o.pose, o.size[:2], trace.sides

    def _put(
        self, category: str, anchor: tuple[Pose, tuple[float, float], Sequence[str]], trace: Trace, clutter: float
    ) -> SceneObject | None:
        """A thing beside a piece of furniture; None where there is no room for it."""
        import shapely

        palette = self._context.scene.palette
        wish = Wish(
            style=palette.style if palette is not None else None,
            palette=palette.code if palette is not None else None,
            seed=self._rng.randrange(3),
            count=1,
        )
        asset = self._context.library.choose(category, 1, wish)[0]
        d, w, _ = asset.size
        pose, (depth, width), sides = anchor
        for _ in range(12):
            side, gap = self._rng.choice(sides), self._rng.uniform(*trace.gap)
            way, along = OUTWARD[side], self._rng.uniform(-0.8, 0.8)
            quarter = side in ("left", "right") and "door" not in trace.beside
            stray = clutter * math.radians(trace.turn) * self._rng.uniform(-1, 1)
            yaw = (math.pi / 2 if quarter and d > w else 0.0) + stray
            own = [abs(d * math.cos(yaw)) + abs(w * math.sin(yaw)), abs(d * math.sin(yaw)) + abs(w * math.cos(yaw))]
            x = way[0] * (depth / 2 + gap + own[0] / 2) + (0 if way[0] else along * max(0.0, depth - own[0]) / 2)
            y = way[1] * (width / 2 + gap + own[1] / 2) + (0 if way[1] else along * max(0.0, width - own[1]) / 2)
            if "door" in trace.beside:
                x = own[0] / 2 + WALL_GAP + 0.01
            place = world(pose, x, y, -pose.position[2], yaw)
            corners = [(s * d / 2, t * w / 2) for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
            ground = shapely.Polygon(place.frame.to_world(_array(corners)))
            if self._inside.contains(ground) and self._taken.distance(ground) >= CLEARANCE:
                self._taken = self._taken.union(ground)
                made = asset.object(self._around.new_id(category), pose=place, mount="floor")
                return made.model_copy(update={"intent": Intent(priority="optional")})
        return None


def _array(points: Sequence[Sequence[float]]):
    import numpy as np

    return np.asarray(points, dtype=float)
