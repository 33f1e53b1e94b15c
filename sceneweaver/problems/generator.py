"""Make problems with a known witness: furniture is put into the cells of a room that was cut up, then related."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
import shapely

from sceneweaver.geometry.walls import walls_of
from sceneweaver.scene import SCHEMA, InputError, Pose, Relation, Scene
from sceneweaver.verify import check
from sceneweaver.verify.relations import judge_relation
from sceneweaver.verify.solids import Placed

from . import cells
from .case import ProblemCase, draw, from_plain, placed
from .cells import Box, NoFit, with_walls
from .measures import facts_of, footprint, tightness_of
from .plans import PLANS
from .recipes import MOST_SEED, RECIPES, UNITS, Recipe, Unit, whole_number
from .units import Draft, Spot

Json = dict[str, Any]

REACH = 3.0  # [m] between the middles of what is related
NEAREST = 6  # neighbours that are looked at
LIGHTEST, HEAVIEST = 0.03, 0.15  # weights of wishes: all together pull less at a thing than a hard relation
SIDES = ("left_of", "right_of", "in_front_of", "behind")


def plant(scene: Scene, count: int, rng: np.random.Generator) -> list[Json]:
    """At most ``count`` hard relations between floor objects that hold in a scene with something to spare.

    Each is judged with tighter numbers than it is given.
    """
    placed = Placed.of(scene)
    candidates = list(_candidates(scene))
    found: list[Json] = []
    for k in rng.permutation(len(candidates)):
        if len(found) == count:
            break
        tight, params = candidates[k]
        if judge_relation(placed, Relation.model_validate(tight)).holds:
            found.append({**tight, "params": params, "hard": True})
    return found


def wish(scene: Scene, count: int, rng: np.random.Generator) -> list[Json]:
    """So many soft relations between floor objects, drawn blindly, each at most once."""
    floor = [o.id for o in scene.objects if o.mount == "floor"]
    kinds = (("near", {"max": 0.3}), ("facing", {}), ("aligned", {}), *((kind, {}) for kind in SIDES))
    found: dict[tuple[str, str, str], Json] = {}
    most = len(kinds) * len(floor) * (len(floor) - 1)
    while len(found) < min(count, most):
        kind, params = kinds[rng.integers(len(kinds))]
        a, b = (floor[k] for k in rng.choice(len(floor), 2, replace=False))
        weight = round(float(rng.uniform(LIGHTEST, HEAVIEST)), 3)
        relation = {"type": kind, "subject": a, "target": b, "params": params, "hard": False, "weight": weight}
        found[kind, a, b] = relation
    return list(found.values())


def _candidates(scene: Scene) -> Iterator[tuple[Json, Json]]:
    """Relations with tight numbers, and the numbers to give them."""
    floor = [i for i, o in enumerate(scene.objects) if o.mount == "floor"]
    at = np.array([scene.objects[i].pose.position[:2] for i in floor])
    feet = [footprint(scene.objects[i]) for i in floor]
    for a, i in enumerate(floor):
        away = np.linalg.norm(at - at[a], axis=1)
        for b in np.argsort(away, kind="stable")[1 : NEAREST + 1]:
            if away[b] > REACH:
                continue
            pair = {"subject": scene.objects[i].id, "target": scene.objects[floor[b]].id}
            gap = float(feet[a].distance(feet[b]))
            low, high = round(max(gap - 0.15, 0.0), 2), round(gap + 0.15, 2)
            yield {"type": "near", **pair, "params": {"max": round(gap + 0.02, 2)}}, {"max": round(gap + 0.2, 2)}
            yield {"type": "distance", **pair, "params": {"min": low, "max": high}}, {"min": low, "max": high}
            yield {"type": "facing", **pair, "params": {"degrees": 11.0}}, {}
            for kind in ("aligned", "parallel"):
                yield {"type": kind, **pair, "params": {"degrees": 1.0}}, {}
            yield {"type": "centered_on", **pair, "params": {"offset": 0.06}}, {}
            for kind in SIDES:
                yield {"type": kind, **pair, "params": {"max": 1.4, "min": 0.1, "band": 1.2}}, {}


MOST_OBJECTS = 1000
TRIES = 60
WITHIN = 0.01  # of the tightness that is asked for
SILL = 0.95
ALIKE = 6  # units that are put in order of size
CORRIDOR = 0.7  # [m] left between what stands along two walls
STRIP = 1.1  # [m] depth of the cells along them


def generate(
    family: str,
    objects: int = 20,
    tightness: float = 0.4,
    seed: int = 0,
    *,
    density: float | None = None,
    shape: str | None = None,
    name: str | None = None,
) -> ProblemCase:
    """Make a problem of a family whose witness is known, as the room was built around it.

    Args:
        family: one of those with feasible problems, but for "bedrooms" and "designs".
        objects: how many, up to 1,000.
        tightness: share of the floor that footprints and hard zones take, the doors' own floor left out. It is
            reached to 0.01. For surfaces it is that of the things on their boards as well.
        seed: from 0 to 2**32 - 1; equal arguments give equal problems.
        density: hard relations an object, drawn among those that hold; by default what the family has.
        shape: of the room ("rectangle", "L", "T", "U", "S"); by default one of the family's. Of chips it is "gsrc" or
            "mcnc" (the circuits whose sizes and nets they are like), of facilities "equal" or "unequal", of warehouses
            "rows" or "mixed".
        name: by default made of the family and the numbers.

    Raises:
        InputError: an unknown family or shape, numbers out of range, or no room found that is so tight.

    Examples:
        >>> from sceneweaver import problems
        >>> case = problems.generate("packing", objects=6, tightness=0.5, seed=1)
        >>> abs(case.facts["tightness"] - 0.5) < 0.01
        True
    """
    if family in PLANS:
        return _planned(family, objects, tightness, seed, shape, name)
    recipe = _recipe(family, objects, tightness, seed, density, shape)
    for attempt in range(TRIES):
        rng = np.random.default_rng([seed, objects, attempt])
        shape_now = shape or recipe.shapes[seed % len(recipe.shapes)]
        try:
            scene = _tight(recipe, objects, tightness, shape_now, [seed, objects, attempt])
            scene = _related(scene, recipe, density, rng)
        except NoFit:
            continue
        if recipe.turned:
            scene = _turned(scene, float(rng.uniform(0.1, 1.4)))
        if check(scene, walkable=False).valid:
            return planted(family, name or _title(family, objects, tightness, seed), scene, seed)
    raise InputError(f"tightness: no room of {objects} objects of {family} was found at {tightness}; try a lower one")


def _title(family: str, objects: int, tightness: float, seed: int) -> str:
    return f"{family}/n{objects:03d}-t{100 * tightness:02.0f}-s{seed}"


def _planned(family: str, objects: int, tightness: float, seed: int, kind: str | None, name: str | None) -> ProblemCase:
    """A plan of blocks of a family of `PLANS`."""
    make, kinds = PLANS[family]
    whole_number("objects", objects, 4, MOST_OBJECTS)
    whole_number("seed", seed, 0, MOST_SEED)
    if not 0.3 <= tightness <= 0.95:
        raise InputError(f"tightness: {tightness!r} is not from 0.3 to 0.95")
    if kind is not None and kind not in kinds:
        raise InputError(f"shape: {kind!r} is none that {family} can have; give one of {', '.join(kinds)}")
    for attempt in range(TRIES):
        try:
            plan = make(objects, tightness, kind or kinds[0], np.random.default_rng([seed, objects, attempt]))
        except NoFit:
            continue
        scene = plan.scene()
        if check(scene, walkable=False).valid:
            return planted(family, name or _title(family, objects, tightness, seed), scene, seed, plan.objective)
    raise InputError(f"tightness: no plan of {objects} blocks of {family} was found at {tightness}; try other numbers")


def planted(family: str, name: str, scene: Scene, seed: int, objective: Sequence[Json] = ()) -> ProblemCase:
    """The problem whose witness is a scene that is valid as it is; it begins with all that may move anywhere."""
    witness = np.array([(*o.pose.position, o.pose.yaw) for o in scene.objects]).round(5).tolist()
    data = scattered(scene, seed).model_copy(update={"id": name.replace("/", "-")}).to_json()
    plain: Json = {"name": name, "family": family, "version": 1, "scene": data, "certificate": None}
    return from_plain({**plain, "witness": witness, "objective": list(objective)}, facts_of(scene))


def scattered(scene: Scene, seed: int) -> Scene:
    """The scene at a bad start: what may move lies anywhere."""
    return placed(scene, draw(scene, None, 1, seed)[0].astype(np.float64).round(4))


def _recipe(family: str, objects: int, tightness: float, seed: int, density: float | None, shape: str | None) -> Recipe:
    if family not in RECIPES:
        raise InputError(f"family: {family!r} is none that can be generated; give one of {', '.join(RECIPES)}")
    whole_number("objects", objects, RECIPES[family].least, MOST_OBJECTS)
    if not 0.05 <= tightness <= 0.9:
        raise InputError(f"tightness: {tightness!r} is not from 0.05 to 0.9")
    whole_number("seed", seed, 0, MOST_SEED)
    if density is not None and not 0 <= density <= 10:
        raise InputError(f"density: {density!r} is not from 0 to 10")
    if shape is not None and (shape not in cells.SHAPES or RECIPES[family].corridor):
        raise InputError(f"shape: {shape!r} is none that {family} can have; give one of {', '.join(cells.SHAPES)}")
    return RECIPES[family]


def _tight(recipe: Recipe, objects: int, tightness: float, shape: str, seed: list[int]) -> Scene:
    """The room with its furniture at the wanted tightness: the same draw, with more or less air around all."""
    side = math.sqrt(min(tightness, 0.9))
    for _ in range(12):
        if not 0.15 < side < 0.985:
            raise NoFit("too tight")
        scene = _furnished(recipe, objects, side, math.sqrt(tightness), shape, np.random.default_rng(seed))
        found = tightness_of(scene)
        if abs(found - tightness) < WITHIN / 2:
            return scene
        side *= math.sqrt(tightness / found)
    raise NoFit("the tightness was not reached")


def _units(recipe: Recipe, objects: int, rng: np.random.Generator) -> list[Unit]:
    """Units with so many objects in all."""
    kinds, shares = zip(*recipe.units, strict=True)
    found: list[Unit] = []
    left = objects
    while left:
        odds = np.array([s if kind.objects <= left else 0.0 for kind, s in zip(kinds, shares, strict=True)])
        unit = kinds[rng.choice(len(kinds), p=odds / odds.sum())] if odds.any() else UNITS["crate"]
        found.append(unit)
        left -= unit.objects
    found = [found[k] for k in rng.permutation(len(found))]
    # Small ones beside small ones: a cut between a small and a large one leaves a strip.
    return [unit for k in range(0, len(found), ALIKE) for unit in sorted(found[k : k + ALIKE], key=lambda u: u.area)]


def _furnished(
    recipe: Recipe, objects: int, side: float, thing_side: float, shape: str, rng: np.random.Generator
) -> Scene:
    units = _units(recipe, objects, rng)
    areas = [unit.area * float(rng.uniform(0.85, 1.2)) / side**2 for unit in units]
    if recipe.corridor:
        boxes, spaces = _corridor(areas, rng)
    else:
        door = cells.PORCH**2
        boxes = cells.rectangles(shape, sum(areas) + door, float(rng.uniform(0.9, 1.4)))
        spaces = cells.cut(boxes, areas, rng)
    outline = cells.outline_of(boxes)
    walls = walls_of(outline)
    door = {"id": "door", "wall": 0, "offset": cells.DOOR_OFFSET, "width": cells.DOOR_WIDTH, "height": 2.05}
    room: dict[str, Any] = {"type": "room", "outline": outline, "height": 2.8, "doors": [door], "windows": []}
    draft = Draft(rng, side, thing_side)
    if recipe.window:
        wall = max(walls[1:], key=lambda w: w.length)
        width = round(min(1.6, 0.5 * wall.length), 2)
        offset = round((wall.length - width) / 2, 2)
        room["windows"] = [
            {"id": "window", "wall": wall.index, "offset": offset, "width": width, "sill": SILL, "height": 1.2}
        ]
        draft.sill = (shapely.Polygon(wall.strip(offset, width, 0.0, 0.3)).bounds, SILL)
    for unit, space in zip(units, spaces, strict=True):
        _fill(draft, recipe, unit, with_walls(space, walls))
    for object_id in draft.at_wall:
        draft.relate("against_wall", object_id)
    for item, pose in zip(draft.objects, draft.poses, strict=True):
        placed = Pose.from_yaw(*pose)
        item["pose"] = {"position": list(placed.position), "quaternion": list(placed.quaternion)}
    data = {"schema": SCHEMA, "id": "draft", "room": room, "objects": draft.objects, "relations": draft.relations}
    return Scene.from_json(data)


def _corridor(areas: list[float], rng: np.random.Generator) -> tuple[list[Box], list[Box]]:
    """A narrow room and the cells along its walls."""
    depth = 2 * STRIP + CORRIDOR
    width = round((sum(areas) - STRIP * (depth - 2 * STRIP) + cells.PORCH * STRIP) / (2 * STRIP), 2)
    if width < 3 * STRIP:
        raise NoFit("too few for the walls of a room")
    south: Box = (cells.PORCH, 0.0, width, STRIP)
    north: Box = (0.0, depth - STRIP, width, depth)
    share = (width - cells.PORCH) / (2 * width - cells.PORCH)
    k = int(np.searchsorted(np.cumsum(areas), share * sum(areas)))
    if not 0 < k < len(areas):
        raise NoFit("one wall stays empty")
    spaces = cells.split(south, areas[:k], rng) + cells.split(north, areas[k:], rng)
    return [(0.0, 0.0, width, round(depth, 2))], spaces


def _fill(draft: Draft, recipe: Recipe, unit: Unit, cell: cells.Cell) -> None:
    """Put a unit into a cell, facing whichever way it fits."""
    rng = draft.rng
    wall = bool(cell.walls) and rng.random() < recipe.at_wall
    if recipe.corridor and not cell.walls:
        raise NoFit("a cell has no wall")
    backs = [(k + 2) % 4 for k in cell.walls] if wall else []
    if recipe.corridor:  # towards the middle of the room, not along it
        backs = [f for f in backs if f % 2] or backs
    tries = [(f, True) for f in rng.permutation(backs)]
    if not recipe.corridor:
        tries += [(f, False) for f in rng.permutation(4)]
    rows = (draft.objects, draft.relations, draft.poses, draft.at_wall)
    marks = [len(row) for row in rows]
    for facing, to_wall in tries:
        try:
            unit.fill(Spot(draft, cell, int(facing), to_wall))
            return
        except NoFit:
            for row, mark in zip(rows, marks, strict=True):
                del row[mark:]
    raise NoFit("a unit does not fit into its cell")


def _related(scene: Scene, recipe: Recipe, density: float | None, rng: np.random.Generator) -> Scene:
    wanted = recipe.density if density is None else density
    count = math.ceil(wanted * len(scene.objects)) - len(scene.relations)
    relations = scene.to_json()["relations"]
    if count < 0 and density is not None:
        relations = relations[:count]  # those to walls come last
    if count > 0:
        more = plant(scene, count, rng)
        if len(more) < count:
            raise NoFit("so many relations do not hold")
        relations = relations + more
    relations = relations + wish(scene, round(recipe.wishes * len(scene.objects)), rng)
    return Scene.from_json({**scene.to_json(), "relations": relations})


def _turned(scene: Scene, angle: float) -> Scene:
    """The whole scene turned about the origin."""
    c, s = math.cos(angle), math.sin(angle)
    data = scene.to_json()
    data["room"]["outline"] = [[round(c * x - s * y, 4), round(s * x + c * y, 4)] for x, y in scene.room.outline]
    for row, item in zip(data["objects"], scene.objects, strict=True):
        x, y, z = item.pose.position
        yaw = math.remainder(item.pose.yaw + angle, 2 * math.pi)
        pose = Pose.from_yaw(round(c * x - s * y, 5), round(s * x + c * y, 5), z, yaw)
        row["pose"] = {"position": list(pose.position), "quaternion": list(pose.quaternion)}
    return Scene.from_json(data)
