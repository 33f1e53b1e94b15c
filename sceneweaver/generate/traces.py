"""Traces of life: chairs not quite pushed in, slippers by the bed, a bag by the desk, toys on the floor."""

from __future__ import annotations

import math
import random
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from sceneweaver.assets import Wish
from sceneweaver.geometry.polygons import counter_clockwise
from sceneweaver.geometry.rotations import is_upright
from sceneweaver.knowledge.small_things import Trace
from sceneweaver.rules.design import limit
from sceneweaver.scene import Intent, Pose, Scene, SceneObject
from sceneweaver.scene.edits import SetPose

from .carry import move, world
from .draft import groups_of
from .program import decided_kinds
from .setup import Setup
from .surface_bodies import Shelf
from .surface_field import Field, Piece, Prism
from .surface_scene import TIES, TILT, Surroundings, solids_of

PULLED, TURNED, MOVED = 0.06, math.radians(1.4), 0.75
"""How far [m] a chair stands back from its table at most, how far it is turned (more looks like a mistake), and the
share of chairs that were moved."""

CLEARANCE, WALL_GAP = 0.02, 0.03
"""Free space [m] around what lies on the floor, and to the walls."""

WAY = 0.9
"""Depth [m] before a door and beside its frame that stays free."""

OVER, FLAT = 0.6, 0.025
"""Height [m] from which on furniture has room for a thing under it, and up to which a thing lies on it: a rug."""

TRIES = 12
"""Places that are tried for one thing beside a piece of furniture."""

OUTWARD = {"front": (1, 0), "back": (-1, 0), "left": (0, 1), "right": (0, -1)}
"""Direction of the sides of furniture, in its frame."""


def moved_chairs(scene: Scene, clutter: float, dice: random.Random) -> Iterator[SetPose]:
    """Chairs at tables, a little back and turned, with what lies on them."""
    tied = {r.subject for r in scene.relations if r.type in TIES}
    for o in scene.objects:
        if o.id not in tied or "chair_group" not in groups_of(o.category) or not is_upright(o.pose.quaternion, TILT):
            continue
        if dice.random() < MOVED:
            back, turn = clutter * PULLED * dice.random(), TURNED * dice.uniform(-1, 1)
            yield from move(scene, {o.id: world(o.pose, -back, 0.0, 0.0, turn)})


@dataclass(frozen=True)
class _Anchor:
    """What a thing may lie beside: its frame, its depth and width [m], and the sides that are used."""

    pose: Pose
    size: Sequence[float]
    sides: Sequence[str]
    door: bool = False


class FreeFloor:
    """The floor of a room as a surface, on which things are put down one by one."""

    def __init__(self, setup: Setup, dice: random.Random):
        scene = setup.scene
        self._setup, self._dice = setup, dice
        self._around = Surroundings(scene, setup.room_type)
        self._decided = decided_kinds(setup.brief, setup.room_type)
        self._shelf = Shelf(setup.library, scene.palette, setup.seed)
        self._field = Field(counter_clockwise(scene.room.outline), edge=WALL_GAP)
        gap = limit("door_frame", "gap")
        for door in scene.room.doors:  # the way through each door, with its frame
            wall, depth = scene.room.walls[door.wall], max(WAY, door.width)
            strip = wall.strip(door.offset - gap, door.width + 2 * gap, 0.0, depth)
            self._field.taken.append(Prism(counter_clockwise(strip), 0.0, OVER))
        for o in scene.objects:
            low = [p for p in solids_of(o) if p.low < OVER and p.high > FLAT]
            self._field.taken += [Prism(p.polygon, 0.0, OVER) for p in low]

    def strewn(self, trace: Trace, clutter: float) -> Iterator[SceneObject]:
        """Things of one kind of trace, each beside another piece of furniture as far as there are enough."""
        names = [n for n in trace.what if n not in self._decided and self._around.may_add(n)]
        anchors = list(self._anchors(trace))
        self._dice.shuffle(anchors)
        left = trace.count
        for anchor in anchors:
            if not left or not names:
                return
            if self._dice.random() > trace.chance:
                left -= 1
                continue
            obj = self._put(self._dice.choice(names), anchor, trace, clutter)
            if obj is not None:
                left -= 1
                yield obj

    def _anchors(self, trace: Trace) -> Iterator[_Anchor]:
        room = self._setup.scene.room
        if "door" in trace.beside:
            for door in room.doors:
                wall = room.walls[door.wall]
                x, y = wall.point(door.offset + door.width / 2, 0.0)
                nx, ny = wall.inward
                pose = world(Pose(), x, y, 0.0, math.atan2(ny, nx))
                yield _Anchor(pose, (0.1, door.width + 0.1), ("left", "right"), door=True)
        for o in self._setup.scene.objects:
            if o.mount == "floor" and groups_of(o.category) & set(trace.beside):
                for _ in range(1 + trace.count // 3):
                    yield _Anchor(o.pose, o.size[:2], trace.sides, "door" in trace.beside)

    def _put(self, category: str, anchor: _Anchor, trace: Trace, clutter: float) -> SceneObject | None:
        """A thing beside a piece of furniture; None where there is no room for it."""
        palette = self._setup.scene.palette
        wish = Wish(
            style=palette.style if palette is not None else None,
            palette=palette.code if palette is not None else None,
            seed=self._dice.randrange(3),
            count=1,
        )
        asset = self._setup.library.choose(category, 1, wish)[0]
        for _ in range(TRIES):
            pose = self._beside(anchor, asset.size, trace, clutter)
            piece, at = Piece(self._shelf.shape(asset), pose.yaw), np.array(pose.position[:2])
            if self._field.place([piece], [at[None]], CLEARANCE) is not None:
                self._field.put(piece, at)
                made = asset.object(self._around.new_id(category), pose=pose, mount="floor")
                return made.model_copy(update={"intent": Intent(priority="optional")})
        return None

    def _beside(self, anchor: _Anchor, size: Sequence[float], trace: Trace, clutter: float) -> Pose:
        """A pose beside an anchor, drawn anew at each call."""
        (d, w), (depth, width) = size[:2], anchor.size
        side, gap = self._dice.choice(anchor.sides), self._dice.uniform(*trace.gap)
        way, along = OUTWARD[side], self._dice.uniform(-0.8, 0.8)
        # What is long lies along the side that it is at.
        quarter = side in ("left", "right") and not anchor.door and d > w
        yaw = (math.pi / 2 if quarter else 0.0) + clutter * math.radians(trace.turn) * self._dice.uniform(-1, 1)
        c, s = abs(math.cos(yaw)), abs(math.sin(yaw))
        own = d * c + w * s, d * s + w * c
        x = way[0] * (depth / 2 + gap + own[0] / 2) + (0 if way[0] else along * max(0.0, depth - own[0]) / 2)
        y = way[1] * (width / 2 + gap + own[1] / 2) + (0 if way[1] else along * max(0.0, width - own[1]) / 2)
        if anchor.door:  # at the wall beside it
            x = own[0] / 2 + WALL_GAP + 0.01
        return world(anchor.pose, x, y, -anchor.pose.position[2], yaw)
