"""Set a valid layout straight: what stands nearly square, flush or centred is made so, as a tidy person would.

The engine leaves everything within its tolerances; people see three degrees and two centimetres. Each step moves
objects by little, and whatever the judge then finds worse goes back to where it was.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable

from sceneweaver.scene import Pose, Relation, Room, Scene, SceneObject
from sceneweaver.verify import check

from .frames import local, world
from .seats import spread

SQUARE = math.radians(12.0)
"""Angle within which something is taken for square to a wall."""

FLUSH = 0.004
"""Gap [m] that is left between furniture and wall."""

BESIDE = 0.02
"""Gap [m] that is left between neighbours."""

ROUNDS = 4

ALONE = 12
"""Objects of one step that are tried one by one."""

TUCKS = (0.25, 0.18, 0.1, 0.05)
"""Ways [m] by which chairs are pushed under a table, the first that all of a kind can go."""

Poses = dict[str, tuple[float, float, float, float]]
Step = Callable[[Scene], Poses]


def tidy(scene: Scene) -> Scene:
    """The scene with its objects set straight; what it violates is no more than before."""
    for step in (_square, _flush, _beside, _centred, _flush, spread):
        scene = _kept(scene, step(scene))
    return _tuck(scene)


def _kept(scene: Scene, wanted: Poses) -> Scene:
    """The scene with as many of the wanted poses as the judge finds no fault with.

    All at once first; then without those that are in trouble, which at last are tried one by one, the largest first.
    """
    wanted = {id: pose for id, pose in wanted.items() if _moves(scene.object(id), pose)}
    if not wanted:
        return scene
    before, late = _faults(scene), []
    for _ in range(ROUNDS):
        after = _moved(scene, wanted)
        worse = _faults(after) - before
        if not worse:
            scene = after
            break
        named = {id for _, objects in worse for id in objects if id in set(scene.ids)}
        blamed = named | {_root(scene, id) for id in named}
        late += [(id, wanted.pop(id)) for id in list(wanted) if id in blamed]
        if not wanted or not blamed:
            break
    late.sort(key=lambda row: -scene.object(row[0]).size[0] * scene.object(row[0]).size[1])
    for id, pose in late[:ALONE]:
        after = _moved(scene, {id: pose})
        if not _faults(after) - before:
            scene = after
    return scene


def _faults(scene: Scene) -> set[tuple[str, tuple[str, ...]]]:
    report = check(scene, walkable=False)
    return {(v.relation.type if v.relation else v.kind, v.objects) for v in report.violations}


def _moves(obj: SceneObject, pose: tuple[float, float, float, float]) -> bool:
    (x, y, z), yaw = obj.pose.position, obj.pose.yaw
    return max(abs(pose[0] - x), abs(pose[1] - y), abs(pose[2] - z), abs(_wrap(pose[3] - yaw))) > 1e-6


def _moved(scene: Scene, wanted: Poses) -> Scene:
    """The scene with objects elsewhere, and what stands on them carried along."""
    above: dict[str, list[str]] = {}
    for o in scene.objects:
        if o.support is not None:
            above.setdefault(o.support.object, []).append(o.id)
    poses: dict[str, Pose] = {}

    def place(id: str, x: float, y: float, z: float, yaw: float) -> None:
        old = scene.object(id).pose
        poses[id] = Pose.from_yaw(x, y, z, _wrap(yaw))
        turn = yaw - old.yaw
        c, s = math.cos(turn), math.sin(turn)
        for other in above.get(id, ()):
            p = scene.object(other).pose
            dx, dy = p.position[0] - old.position[0], p.position[1] - old.position[1]
            up = p.position[2] - old.position[2]
            place(other, x + c * dx - s * dy, y + s * dx + c * dy, z + up, p.yaw + turn)

    for id, pose in wanted.items():
        place(id, *pose)
    return scene.replace_poses(poses)


def _root(scene: Scene, id: str) -> str:
    obj = scene.object(id)
    while obj.support is not None:
        obj = scene.object(obj.support.object)
    return obj.id


def _free(scene: Scene) -> Iterable[SceneObject]:
    return (o for o in scene.objects if o.mount != "surface" and not o.fixed)


def _wrap(angle: float) -> float:
    return (angle + math.pi) % (2 * math.pi) - math.pi


def _walls(room: Room) -> list[tuple[tuple[float, float], tuple[float, float], tuple[float, float], float]]:
    """First corner, direction, inward normal and length of each wall."""
    out = []
    for a, b in zip(room.outline, (*room.outline[1:], room.outline[0]), strict=True):
        length = math.dist(a, b)
        t = ((b[0] - a[0]) / length, (b[1] - a[1]) / length)
        out.append((a, t, (-t[1], t[0]), length))
    return out


def _square(scene: Scene) -> Poses:
    """What is nearly parallel to a wall becomes so."""
    angles = [math.atan2(t[1], t[0]) for _, t, _, _ in _walls(scene.room)]
    found: Poses = {}
    for o in _free(scene):
        offs = [((a - o.pose.yaw + math.pi / 4) % (math.pi / 2)) - math.pi / 4 for a in angles]
        off = min(offs, key=abs)
        if abs(off) <= SQUARE:
            found[o.id] = (*o.pose.position, o.pose.yaw + off)
    return found


def _flush(scene: Scene) -> Poses:
    """What has its back at a wall touches it."""
    names = {r.subject for r in scene.relations if r.type in ("against_wall", "in_corner")}
    found: Poses = {}
    for o in _free(scene):
        if o.id not in names and o.mount != "wall":
            continue
        x, y, z = o.pose.position
        back = (-math.cos(o.pose.yaw), -math.sin(o.pose.yaw))
        best = None
        for p, t, n, length in _walls(scene.room):
            if back[0] * n[0] + back[1] * n[1] > -math.cos(math.radians(1.0)):
                continue
            gap = (x - p[0]) * n[0] + (y - p[1]) * n[1] - o.size[0] / 2
            along = (x - p[0]) * t[0] + (y - p[1]) * t[1]
            if abs(gap) <= 0.09 and 0 <= along <= length and (best is None or abs(gap) < abs(best[0])):
                best = gap, n
        if best is not None:
            shift = FLUSH - best[0]
            found[o.id] = (x + shift * best[1][0], y + shift * best[1][1], z, o.pose.yaw)
    return found


def _beside(scene: Scene) -> Poses:
    """Neighbours stand at the same small distance, with their backs in line where they nearly are."""
    found: Poses = {}
    for r in scene.relations:
        if r.type != "leftright_to_leftright" or not isinstance(r.target, str) or r.subject in found:
            continue
        a, b = scene.object(r.subject), scene.object(r.target)
        if a.mount != "floor" or b.mount != "floor" or a.fixed:
            continue
        u, v = local(a, b)
        side = 1.0 if v >= 0 else -1.0
        gap = abs(v) - (a.size[1] + b.size[1]) / 2
        if not 0.0 <= gap <= 0.06 or abs(_wrap(a.pose.yaw - b.pose.yaw)) > 0.02:
            continue
        backs = (u - a.size[0] / 2) + b.size[0] / 2
        u -= backs if abs(backs) < 0.12 else 0.0
        v = side * ((a.size[1] + b.size[1]) / 2 + min(gap, BESIDE))
        found[a.id] = world(b, u, v, a.pose.position[2], a.pose.yaw)
    return found


def _centred(scene: Scene) -> Poses:
    """What belongs to the middle of something stands there."""
    found: Poses = {}
    alone: dict[tuple[str, str], int] = {}
    for r in scene.relations:
        if isinstance(r.target, str):
            alone[r.type, r.target] = alone.get((r.type, r.target), 0) + 1
    windows = {w.id: w for w in scene.room.windows}
    known = {o.id: o for o in scene.objects}
    for r in scene.relations:
        a = known[r.subject]
        if a.fixed or a.mount == "surface" or a.id in found:
            continue
        pose = None
        if r.type == "at_window" and isinstance(r.target, str) and r.target in windows and a.mount == "wall":
            pose = _at_window(scene.room, windows[r.target], a)
        elif isinstance(r.target, str) and r.target in known:
            pose = _to_target(r, a, known[r.target], alone[r.type, r.target] == 1)
        if pose is not None:
            found[a.id] = pose
    for o in _free(scene):
        heights = o.intent.mounting_height
        if o.mount == "wall" and heights is not None:
            x, y, _, yaw = found.get(o.id, (*o.pose.position, o.pose.yaw))
            found[o.id] = (x, y, 0.5 * (heights[0] + heights[1]), yaw)
    return found


def _tuck(scene: Scene) -> Scene:
    """Push the chairs of each kind under their tables, all by the same way, as far as nothing is in the way."""
    known = {o.id: o for o in scene.objects}
    groups: dict[tuple[str, str], dict[str, SceneObject]] = {}
    for r in scene.relations:
        if r.type not in ("front_against", "front_to_front", "around") or "gap" in r.params:
            continue
        a, b = known[r.subject], known.get(r.target if isinstance(r.target, str) else "")
        if b is None or a.fixed or a.mount != "floor" or a.size[2] < b.size[2] - 0.2 or _gap(a, b) < -0.05:
            continue
        groups.setdefault((a.category, b.category), {})[a.id] = a
    for chairs in groups.values():
        before = _faults(scene)
        for way in TUCKS:
            moved = _moved(scene, {id: _ahead(chair, way) for id, chair in chairs.items()})
            if not _faults(moved) - before:
                scene = moved
                break
    return scene


def _ahead(obj: SceneObject, way: float) -> tuple[float, float, float, float]:
    (x, y, z), yaw = obj.pose.position, obj.pose.yaw
    return x + way * math.cos(yaw), y + way * math.sin(yaw), z, yaw


def _gap(a: SceneObject, b: SceneObject) -> float:
    """Distance [m] from a's front face to b's box, straight ahead of a; negative when it reaches into it."""
    u, v = local(b, a)
    turn = b.pose.yaw - a.pose.yaw
    reach = abs(math.cos(turn)) * b.size[0] / 2 + abs(math.sin(turn)) * b.size[1] / 2
    return u - reach - a.size[0] / 2


def _at_window(room: Room, window, a: SceneObject) -> tuple[float, float, float, float] | None:
    p, t, n, _ = _walls(room)[window.wall]
    x, y, z = a.pose.position
    if math.cos(a.pose.yaw) * n[0] + math.sin(a.pose.yaw) * n[1] < 0.99:
        return None  # at another wall
    along = (x - p[0]) * t[0] + (y - p[1]) * t[1]
    shift = window.offset + window.width / 2 - along
    return (x + shift * t[0], y + shift * t[1], z, a.pose.yaw)


def _to_target(r: Relation, a: SceneObject, b: SceneObject, alone: bool) -> tuple[float, float, float, float] | None:
    """The pose that centres a on b in the way that the relation means; None when it is too far off for that."""
    z, yaw = a.pose.position[2], a.pose.yaw
    u, v = local(a, b)
    if r.type == "centered_on" or (a.mount == "ceiling" and r.type == "near"):
        flat = a.size[2] < 0.02
        turned = _like(yaw, b.pose.yaw) if flat or a.mount == "ceiling" else yaw
        if r.type == "centered_on" and a.mount != "ceiling" and not flat:
            return world(b, u, 0.0, z, yaw) if abs(v) <= abs(u) else world(b, 0.0, v, z, yaw)
        return world(b, 0.0, 0.0, z, turned)
    if r.type == "above" and a.mount == "wall" and math.cos(yaw - b.pose.yaw) > 0.99:
        return world(b, u, 0.0, z, yaw)
    if r.type == "front_to_front" and alone and abs(v) < 0.6 and math.cos(yaw - b.pose.yaw) < -0.99:
        return world(b, u, 0.0, z, yaw)
    if r.type == "facing" and math.cos(yaw - b.pose.yaw) < -0.99 and abs(v) < 0.8 and u > 0.8:
        return world(b, u, 0.0, z, yaw)
    return None


def _like(yaw: float, other: float) -> float:
    """The quarter turn of ``other`` that is nearest to a yaw."""
    quarter = round((yaw - other) / (math.pi / 2))
    return other + quarter * math.pi / 2
