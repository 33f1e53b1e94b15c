"""Things for bare walls: art over furniture, and in the middle of free stretches; radiators under windows."""

from __future__ import annotations

import math
import random
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from sceneweaver.assets import Asset, Wish
from sceneweaver.assets.roles import has_role
from sceneweaver.assets.taxonomy import category_named, members
from sceneweaver.geometry.walls import Wall, wall_behind
from sceneweaver.knowledge.shells import first_group, shells
from sceneweaver.knowledge.small_things import most_on_walls, sparse_walls, wall_things
from sceneweaver.scene import InputError, Intent, Pose, Relation, SceneObject, Window
from sceneweaver.scene.edits import Add, AnyEdit, Relate

from .draft import Draft
from .meant import decided_kinds
from .setup import Setup
from .wall_plan import CLOSE, TALL, Outlines, Rectangle, Span, extent, free_runs, obstacles

BARE = 1.2
"""Length [m] of bare wall on which something is hung."""

ABOVE_FLOOR, BELOW_SILL, NARROWER = 0.12, 0.12, 0.2
"""Gaps [m] between a radiator and the floor, the sill and the ends of its window, both ends together."""

EACH = 3.0
"""Length [m] of wall for each thing: people prefer few and large ones to many small ones."""

BESIDE_HUNG = 0.75 * EACH
"""Length [m] of wall beside something that hangs there from which on something more is hung."""

SHARE, OVER = 0.5, 2 / 3
"""Width of a thing, as a share of its stretch of wall and of the furniture under it."""

MIDDLE = 1.5
"""Height [m] of the middle of what is looked at."""

ABOVE = (0.15, 0.3)
"""Gap [m] between furniture and what hangs over it."""

READ, SEATS = 1.0, frozenset(members("chair_group"))
"""The depth [m] of floor that people need before a board, and what they move aside for it."""

BASES = 0.7
"""Width [m] from which low furniture has something over its middle."""

SHIFTS = (0.0, 0.1, -0.1, 0.2, -0.2, 0.35, -0.35)
"""Where along the wall a place is looked for [m], from the middle."""

LIFTS = (0.0, 0.12, 0.25, 0.4)
"""By how much [m] things hang higher where something is in the way."""


@dataclass
class _Work:
    """One call while it is carried out."""

    setup: Setup
    draft: Draft
    dice: random.Random
    outlines: Outlines
    edits: list[AnyEdit] = field(default_factory=list)

    @property
    def objects(self) -> list[SceneObject]:
        return list(self.draft.objects.values())


def covered(setup: Setup, walls: Sequence[int], bare: float = BARE) -> list[AnyEdit]:
    """Edits that hang something on each free stretch of walls.

    Args:
        setup: the room; what its request names is not hung.
        walls: numbers of walls; without any all of them, and radiators under windows as well.
        bare: length [m] of wall from which on something is hung.
    """
    draft = Draft.of(setup.scene)
    own, sparse = draft.room.walls, sparse_walls(setup.room_type.name)
    dice = random.Random(f"walls {setup.seed}")
    work = _Work(setup, draft, dice, Outlines(draft.objects.values()))
    for k in sorted(set(walls or range(len(own))), key=lambda k: (-own[k].length, k)):
        if not walls:
            _heat(work, own[k])
        least = max(bare, BESIDE_HUNG) if _is_hung(work, k) else bare
        for run in free_runs(draft.room, work.objects, own[k], least * (2.0 if sparse else 1.0)):
            _fill(work, own[k], run)
    return work.edits


def _is_hung(work: _Work, wall: int) -> bool:
    """Whether such things hang on a wall, between which more wall stays free."""
    things, walls = wall_things(work.setup.room_type.name), work.draft.room.walls
    hung = (o for o in work.objects if o.mount == "wall" and o.category in things)
    return any(wall_behind(walls, o.pose.position, o.pose.frame.axis) == wall for o in hung)


def _fill(work: _Work, wall: Wall, run: Span) -> None:
    """One free stretch: something over each piece of low furniture, else at even distances."""
    bases = [base for base in _bases(work, wall) if run[0] <= _middle(base, wall) <= run[1]]
    for base in bases:
        along, _ = extent(base, wall)
        middle = _middle(base, wall)
        room = 2 * min(middle - run[0], run[1] - middle)
        width = min(OVER * (along[1] - along[0]), room)
        if width >= 0.3:
            _hang(work, wall, middle, width, base)
    if bases:
        return
    length = run[1] - run[0]
    count = max(1, round(length / EACH))
    kind = None
    for k in range(count):
        middle = run[0] + (k + 0.5) * length / count
        kind = _hang(work, wall, middle, SHARE * length / count, None, kind) or kind


def _heat(work: _Work, wall: Wall) -> None:
    """A radiator below each window of a wall that has room for one, in rooms that have any."""
    room, name = work.draft.room, work.setup.room_type.name
    spec = shells().radiators
    if random.Random(f"radiators {work.setup.seed}").random() > spec.share or first_group(name) not in spec.groups:
        return
    for window in room.windows:
        tall = window.sill - ABOVE_FLOOR - BELOW_SILL
        if window.wall != wall.index or tall < category_named(spec.what).size.height[0]:  # type: ignore[union-attr]
            continue
        if any(o.category == spec.what and _within(o, window, wall) for o in work.objects):
            continue
        asset = _body(work, spec.what, window.width - NARROWER, min(tall, 0.6))
        if asset is None or asset.size[2] > tall:
            continue
        middle = window.offset + window.width / 2
        along = (middle - asset.size[1] / 2, middle + asset.size[1] / 2)
        taken = obstacles(room, work.outlines, wall, asset.size[0])
        place = Rectangle(along, (ABOVE_FLOOR, ABOVE_FLOOR + asset.size[2]))
        if not any(place.meets(other) for other in taken):
            _add(work, wall, asset, (middle, ABOVE_FLOOR), None)


def _within(obj: SceneObject, window: Window, wall: Wall) -> bool:
    """Whether the middle of a thing is before a window, as seen along its wall."""
    return obj.mount == "wall" and window.offset < _middle(obj, wall) < window.offset + window.width


def _bases(work: _Work, wall: Wall) -> Iterator[SceneObject]:
    """Low furniture at a wall, wide enough for something to hang over it."""
    for obj in work.objects:
        if obj.mount != "floor" or not 0.3 < obj.size[2] < TALL:
            continue
        along, deep = extent(obj, wall)
        front = obj.pose.frame.axis
        turned = abs(front[0] * wall.along[0] + front[1] * wall.along[1]) < 0.1
        if turned and deep[0] <= CLOSE and along[1] - along[0] >= BASES:
            yield obj


def _middle(obj: SceneObject, wall: Wall) -> float:
    (start, end), _ = extent(obj, wall)
    return (start + end) / 2


def _hang(
    work: _Work, wall: Wall, middle: float, width: float, base: SceneObject | None, kind: str | None = None
) -> str | None:
    """Hang one thing of about that width [m] at a place along a wall; the category, or None where nothing fits."""
    names = _candidates(work, art=base is not None)
    for name in ([kind] if kind in names else []) + [n for n in names if n != kind]:
        for share in (1.0, 0.7):
            asset = _body(work, name, width * share)
            if asset is None:
                continue
            found = _place(work, wall, middle, asset, base)
            if found is not None:
                _add(work, wall, asset, found, base)
                return name
    return None


def _candidates(work: _Work, art: bool) -> list[str]:
    """What may hang here, in the order in which it is tried."""
    brief, there = work.setup.brief, Counter(o.category for o in work.objects)
    banned = decided_kinds(brief, work.setup.room_type)
    shares = {
        name: share
        for name, share in wall_things(work.setup.room_type.name).items()
        if name not in banned and there[name] < (most_on_walls(name) or 99) and (not art or has_role(name, "looked_at"))
    }
    return sorted(shares, key=lambda name: -(work.dice.random() ** (1.0 / shares[name])))[:3]


def _body(work: _Work, category: str, width: float, height: float | None = None) -> Asset | None:
    """A body of about that width [m], in the look of the room."""
    usual = category_named(category).size
    assert usual is not None
    low, high = usual.width
    setup, palette = work.setup, work.setup.scene.palette
    wish = Wish(
        size=(None, round(min(max(width, low), high), 3), height),
        style=palette.style if palette is not None else setup.brief.style,
        palette=palette.code if palette is not None else None,
        seed=work.dice.randrange(2**31),
        count=1,
        mount="wall",
    )
    try:
        asset = setup.library.choose(category, 1, wish, False)[0]
    except InputError:
        return None
    return asset if asset.size[1] <= 1.6 * width else None


def _place(
    work: _Work, wall: Wall, middle: float, asset: Asset, base: SceneObject | None
) -> tuple[float, float] | None:
    """Where along the wall its middle is and how high its bottom [m], free of all that is there."""
    depth, width, height = asset.size
    taken = obstacles(work.draft.room, work.outlines, wall, depth)
    if has_role(asset.category, "board"):
        taken += _before_boards(work, wall)
    bottom = MIDDLE - height / 2
    if not has_role(asset.category, "looked_at"):
        low, high = category_named(asset.category).bottom or (1.2, 1.5)
        bottom = (low + high) / 2
    if base is not None:
        bottom = max(bottom, base.pose.position[2] + base.size[2] + ABOVE[0])
    for lift in LIFTS:
        z = bottom + lift
        if z + height > work.draft.room.height - 0.1:
            return None
        for shift in SHIFTS if base is None else SHIFTS[:1]:
            along = (middle + shift - width / 2, middle + shift + width / 2)
            if along[0] < 0.02 or along[1] > wall.length - 0.02:
                continue
            if not any(Rectangle(along, (z, z + height)).meets(other) for other in taken):
                return middle + shift, round(z, 3)
    return None


def _before_boards(work: _Work, wall: Wall) -> Iterator[Rectangle]:
    """The stretches of a wall before which furniture stands."""
    for obj in work.objects:
        if obj.mount != "floor" or obj.category in SEATS:
            continue
        along, deep = extent(obj, wall)
        if deep[0] < READ and deep[1] > 0.0:
            yield Rectangle(along, (0.0, work.draft.room.height))


def _add(work: _Work, wall: Wall, asset: Asset, place: tuple[float, float], base: SceneObject | None) -> None:
    along, bottom = place
    x, y = wall.point(along, asset.size[0] / 2 + 0.001)
    axis = Pose.from_yaw(x, y, bottom, wall.yaw + math.pi / 2)
    made = asset.object(work.draft.fresh(asset.category), pose=axis, mount="wall")
    intent = Intent(priority="optional", mounting_height=(max(0.0, bottom - 0.01), bottom + 0.01), keep_clear=True)
    made = made.model_copy(update={"intent": intent})
    relations = [Relation(type="against_wall", subject=made.id, target=f"wall:{wall.index}")]
    if base is not None:
        relations.append(Relation(type="above", subject=made.id, target=base.id, hard=False))
    work.draft.objects[made.id] = made
    work.outlines.add(made)
    work.draft.relations += relations
    work.edits += [Add(object=made), *(Relate(relation=r) for r in relations)]
