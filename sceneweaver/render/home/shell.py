"""The building around the furniture as meshes: walls of any thickness with the paint of each room, floors, doors that
stand open, windows, stairs and railings. All heights are counted from the floor of the storey."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace

import numpy as np
import shapely

from sceneweaver.assets.body import Material, Mesh
from sceneweaver.geometry.walls import walls_of
from sceneweaver.home import Home, HomeDoor, HomeRoom, HomeWindow, wall_openings, wall_polygons
from sceneweaver.home.treads import treads
from sceneweaver.scene import Room, Scene, Window

from ..blocks import Builder, Finishes, Range, wall_block
from ..interior.build import has_panelled_doors
from ..openings import add_frame, add_leaf, add_window, leaf_span
from ..shell import add_facing, add_wall_finish, floor_mesh

OPEN = 1.48
"""How far leaves stand open in a walk [rad]."""

_PAINT = 5e-4  # thickness of the paint of a room on its walls [m]
_FOOT = -0.08  # height at which walls begin: under the floors [m]
_SLAB = 0.12  # thickness of the slab under a storey [m]
_TREAD = 0.045  # thickness of a step [m]
_POCKET = 0.92  # how far a sliding leaf is in its wall, in its widths
_RAIL = (0.04, 1.0)  # thickness and height of a railing [m]

LEDGE = Material("window ledge", (0.80, 0.79, 0.77), roughness=0.7)
"""What thick walls end in under windows: metal would mirror the ground."""

_OAK = Material("stair tread", (0.70, 0.53, 0.36), roughness=0.45, texture="oak")
_RISER = Material("stair riser", (0.93, 0.925, 0.91), roughness=0.6)
_STEEL = Material("railing", (0.30, 0.31, 0.32), roughness=0.5)


def scene_of(home: Home, room: HomeRoom) -> Scene:
    """The furnished room, or an empty one."""
    return room.scene if room.scene is not None else Scene(id=room.id, room=home.shell(room.id))


def indoors(home: Home, storey: str) -> list[HomeRoom]:
    """The rooms of a storey that have walls around them."""
    return [room for room in home.rooms_of(storey) if not room.outdoor]


def is_glazed(home: Home, door: HomeDoor) -> bool:
    """Whether a door is of glass: one that slides, to the outside."""
    return door.kind == "sliding" and (door.to is None or home.room(door.to).outdoor or home.room(door.room).outdoor)


def glass_of(home: Home, room: HomeRoom) -> list[Window]:
    """What lets daylight into a room, as windows: these, and doors of glass."""
    shell = home.shell(room.id)
    glazed = {door.id for door in home.doors_of(room.id) if is_glazed(home, door)}
    doors = [
        Window(id=d.id, wall=d.wall, offset=d.offset, width=d.width, sill=0.0, height=d.height)
        for d in shell.doors
        if d.id in glazed
    ]
    return [*shell.windows, *doors]


def walls_mesh(home: Home, storey: str, looks: Mapping[str, Finishes], top: float) -> Mesh | None:
    """The walls of a storey up to a height [m], each room in its own paint."""
    builder = Builder(top)
    openings = wall_openings(home, storey)
    walls = shapely.union_all(wall_polygons(home, storey))
    some = next(iter(looks.values()))
    cuts = sorted({_FOOT, 0.0, top, *(min(z, top) for found in openings for z in _heights(found.opening))})
    for low, high in zip(cuts, cuts[1:], strict=False):
        gone = [shapely.Polygon(f.corners).buffer(1e-4) for f in openings if _spans(f.opening, (low + high) / 2)]
        solid = walls.difference(shapely.union_all(gone)) if gone else walls
        extrude(builder, solid, (low, high), some.outside, some.cut if high == top else some.outside)
    builder.top = top - 0.002
    for room in indoors(home, storey):
        look, shell = looks[room.id], scene_of(home, room).room
        for wall in shell.walls:
            add_facing(builder, shell, wall, (0.0, top), _PAINT, look.wall(wall.index))
            add_wall_finish(builder, shell, wall, look, min(top, shell.height))
    return builder.mesh()


def _heights(opening: HomeDoor | HomeWindow) -> Range:
    low = opening.sill if isinstance(opening, HomeWindow) else 0.0
    return low, low + opening.height


def _spans(opening: HomeDoor | HomeWindow, z: float) -> bool:
    low, high = _heights(opening)
    return low < z < high


def extrude(builder: Builder, shape: shapely.Geometry, z: Range, side: Material, top: Material) -> None:
    """Polygons with holes from one height to another [m]."""
    import manifold3d

    for part in shapely.get_parts(shape):
        if not isinstance(part, shapely.Polygon) or part.area < 1e-6:
            continue
        part = shapely.geometry.polygon.orient(part)
        rings = [np.asarray(ring.coords)[:-1, :2] for ring in (part.exterior, *part.interiors)]
        plan = np.concatenate(rings)
        faces = np.asarray(manifold3d.triangulate(rings), dtype=np.int32)
        low, high = (np.column_stack([plan, np.full(len(plan), level)]) for level in z)
        builder.add(high, faces, top)
        builder.add(low, faces[:, ::-1], side)
        start, quads = 0, []
        n = len(plan)
        for ring in rings:
            k = np.arange(len(ring)) + start
            after = np.roll(k, -1)
            quads += [np.stack([k, after, after + n], axis=1), np.stack([k, after + n, k + n], axis=1)]
            start += len(ring)
        builder.add(np.concatenate([low, high]), np.concatenate(quads).astype(np.int32), side)


def floors_of(home: Home, storey: str, looks: Mapping[str, Finishes]) -> Iterator[Mesh]:
    """The floor of each room, without the holes of stairs that come up, and the slab under all of them."""
    holes = [shapely.Polygon(s.outline) for s in home.stairs if home.room(s.upper).storey == storey]
    for room in home.rooms_of(storey):
        floor = shapely.Polygon(room.outline)
        for part in shapely.get_parts(floor.difference(shapely.union_all(holes)) if holes else floor):
            if isinstance(part, shapely.Polygon) and part.area > 1e-4 and not part.interiors:
                plan = np.asarray(shapely.geometry.polygon.orient(part).exterior.coords)[:-1]
                yield floor_mesh(looks[room.id].looks.floor, plan)
    whole = [*wall_polygons(home, storey), *(shapely.Polygon(room.outline) for room in home.rooms_of(storey))]
    slab = shapely.union_all([p.buffer(1e-4, join_style="mitre") for p in whole])
    if holes:  # the floor's own edge is before that of the slab
        slab = slab.difference(shapely.union_all(holes).buffer(0.004, join_style="mitre"))
    builder = Builder()
    some = next(iter(looks.values()))
    extrude(builder, slab, (-_SLAB, -0.002), some.outside, some.outside)
    mesh = builder.mesh()
    if mesh is not None:
        yield mesh


def ceiling_mesh(home: Home, room: HomeRoom, look: Finishes) -> Mesh | None:
    """The ceiling of a room, over half of its walls as well, with a shaft over a stair that goes up."""
    height = home.storey_of(room.id).height
    plan = shapely.Polygon(room.outline).buffer(0.5 * home.walls.inner, join_style="mitre")
    builder = Builder()
    for stair in home.stairs:
        if stair.lower == room.id:
            hole = shapely.Polygon(stair.outline)
            plan = plan.difference(hole)
            above = home.storey_of(stair.upper)
            rise = above.elevation - home.storey_of(stair.lower).elevation + above.height
            shaft = hole.buffer(0.02, join_style="mitre").difference(hole)
            extrude(builder, shaft, (height, rise), look.looks.wall, look.looks.wall)
            extrude(builder, hole.buffer(0.02, join_style="mitre"), (rise, rise + 0.02), look.ceiling, look.ceiling)
    extrude(builder, plan, (height, height + 0.1), look.ceiling, look.ceiling)
    return builder.mesh()


def doors_of(
    home: Home,
    storey: str,
    looks: Mapping[str, Finishes],
    ajar: Callable[[HomeDoor], float | None],
    top: float = np.inf,
) -> Iterator[tuple[str, Mesh]]:
    """The doors of a storey by id, with their frames.

    Args:
        home: The home.
        storey: Which storey of it.
        looks: What each room is made of.
        ajar: How far a door stands open [rad]; None: it has no leaf.
        top: Height [m] at which all is cut.
    """
    for found in wall_openings(home, storey):
        door = found.opening
        if not isinstance(door, HomeDoor):
            continue
        host = door.opens_into or door.room
        if home.room(host).outdoor and door.to is not None:
            host = door.room if host == door.to else door.to
        room = scene_of(home, home.room(host)).room
        builder = Builder(top)
        _add_door(builder, home, door, room, looks[host], ajar(door), found.thickness)
        mesh = builder.mesh()
        if mesh is not None:
            yield door.id, mesh


def _add_door(
    builder: Builder, home: Home, door: HomeDoor, room: Room, look: Finishes, ajar: float | None, thick: float
) -> None:
    own = next(d for d in room.doors if d.id == door.id)
    wall = room.walls[own.wall]
    if is_glazed(home, door):
        pane = Window(id=door.id, wall=own.wall, offset=own.offset, width=own.width, sill=0.0, height=own.height)
        add_window(builder, wall, pane, replace(look, metal=LEDGE), thick=thick)
        return
    add_frame(builder, wall, own, look, thick)
    if ajar is None or door.kind == "open":
        return
    panelled = has_panelled_doors(room)
    low, high = leaf_span(own)
    if door.kind == "double":
        middle = (low + high) / 2
        for span, hand in (((low, middle - 0.002), "in-left"), ((middle + 0.002, high), "in-right")):
            leaf = own.model_copy(update={"swing": hand if own.swing != "out" else "out"})
            add_leaf(builder, wall, span, leaf, look, panelled, ajar, thick)
    elif door.kind == "sliding":
        after = wall.length - own.offset - own.width >= own.offset
        shift = (_POCKET if after else -_POCKET) * own.width if ajar else 0.0
        add_leaf(builder, wall, (low + shift, high + shift), own, look, panelled, 0.0, thick)
    else:
        add_leaf(builder, wall, (low, high), own, look, panelled, ajar, thick)


def windows_of(
    home: Home, storey: str, looks: Mapping[str, Finishes], bright: bool = False, top: float = np.inf
) -> Iterator[tuple[str, Mesh]]:
    """The windows of a storey by id; ``bright``: with daylight behind them."""
    for found in wall_openings(home, storey):
        window = found.opening
        if isinstance(window, HomeWindow):
            shell = home.shell(window.room)
            own = next(w for w in shell.windows if w.id == window.id)
            builder = Builder(top)
            add_window(builder, shell.walls[own.wall], own, looks[window.room], bright, found.thickness)
            mesh = builder.mesh()
            if mesh is not None:
                yield window.id, mesh


def lowest(home: Home, storey: str) -> float:
    """How far one sees down from a storey [m, negative]: under its floor, or to that from which a stair comes up."""
    floor = home.storey(storey).elevation
    below = [home.storey_of(s.lower).elevation - floor for s in home.stairs if home.room(s.upper).storey == storey]
    return min(below, default=0.0) - 0.3


def stairs_mesh(home: Home, storey: str, top: float = np.inf) -> Mesh | None:
    """The stairs that leave a storey upward, up to a height [m], and those that come up to it, in a shaft."""
    builder = Builder()
    for stair in home.stairs:
        lower, upper = home.storey_of(stair.lower), home.storey_of(stair.upper)
        if storey not in (lower.id, upper.id):
            continue
        rise = (upper.elevation - lower.elevation) / stair.risers
        base = 0.0 if storey == lower.id else lower.elevation - upper.elevation
        if storey == upper.id:
            hole = shapely.Polygon(stair.outline)
            extrude(builder, hole.buffer(0.02, join_style="mitre").difference(hole), (base, -0.06), _RISER, _RISER)
            extrude(builder, hole.buffer(0.02, join_style="mitre"), (base - 0.02, base), _OAK, _OAK)
        for step in treads(stair):
            z = base + step.number * rise
            if z > top:
                break
            builder.prism(step.plan, (z - _TREAD, z), _OAK)
            inner = step.plan.mean(axis=0) + 0.985 * (step.plan - step.plan.mean(axis=0))
            builder.prism(inner, (z - rise - 0.02, z - _TREAD), _RISER)
    return builder.mesh()


def ground_mesh(home: Home, storey: str, look: Material) -> Mesh | None:
    """An endless ground under the floor of a storey, with holes where stairs come up."""
    builder = Builder()
    holes = [shapely.Polygon(s.outline).buffer(0.1) for s in home.stairs if home.room(s.upper).storey == storey]
    reach = 500.0
    extrude(
        builder,
        shapely.box(-reach, -reach, reach, reach).difference(shapely.union_all(holes)),
        (-9.0, -0.051),
        look,
        look,
    )
    return builder.mesh()


def railings_mesh(home: Home, storey: str) -> Mesh | None:
    """Railings of balconies where no wall is, and around the hole of a stair where nobody comes up."""
    builder = Builder()
    solid = shapely.union_all(wall_polygons(home, storey)).buffer(0.02, join_style="mitre")
    thick, high = _RAIL
    for room in home.rooms_of(storey):
        if room.outdoor:
            for a, b in _free_edges(room.outline, solid):
                _add_rail(builder, a, b, thick, high)
    return builder.mesh()


def _free_edges(
    outline: Iterable[tuple[float, float]], solid: shapely.Geometry
) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    for wall in walls_of(list(outline)):
        free = shapely.LineString([wall.start, wall.end]).difference(solid)
        for part in shapely.get_parts(free):
            if part.length > 0.05:
                ends = np.asarray(part.coords)
                yield ends[0], ends[-1]


def _add_rail(builder: Builder, a: np.ndarray, b: np.ndarray, thick: float, high: float) -> None:
    wall = walls_of([a, b, (a + b) / 2 + (b - a)[::-1] * (-1.0, 1.0)])[0]
    builder.prism(wall_block(wall, (0.0, wall.length), (-thick, 0.0)), (high - 0.05, high), _STEEL)
    builder.prism(wall_block(wall, (0.0, wall.length), (-thick, 0.0)), (0.08, 0.11), _STEEL)
    count = max(2, round(wall.length / 0.11))
    for k in range(count + 1):
        at = k * (wall.length - 0.016) / count
        builder.prism(wall_block(wall, (at, at + 0.016), (-0.028, -0.012)), (0.0, high - 0.05), _STEEL)


def around(home: Home, storey: str) -> Room:
    """The building of a storey as one room, with a window wherever something is of glass: what `outside_mesh` asks."""
    rooms = indoors(home, storey)
    whole = shapely.union_all([*wall_polygons(home, storey), *(shapely.Polygon(r.outline) for r in rooms)])
    parts = [p for p in shapely.get_parts(whole.buffer(1e-3, join_style="mitre")) if isinstance(p, shapely.Polygon)]
    ring = shapely.get_exterior_ring(shapely.Polygon(max(parts, key=lambda part: part.area).exterior).simplify(0.005))
    ring = shapely.LinearRing(shapely.get_coordinates(ring))
    corners = np.asarray(ring.coords)[:: 1 if ring.is_ccw else -1][:-1]
    outline = tuple((round(float(x), 3), round(float(y), 3)) for x, y in corners)
    walls, seen = walls_of(outline), {}
    for room in rooms:
        for window in glass_of(home, room):
            wall = room.walls[window.wall]
            x, y = wall.point(window.offset + window.width / 2, -home.walls.outer)
            near = [w for w in walls if w.outward[0] * wall.outward[0] + w.outward[1] * wall.outward[1] > 0.9]
            if near:
                best = min(near, key=lambda w: abs(w.coordinates((x, y))[1]))
                seen.setdefault(
                    best.index, Window(id=window.id, wall=best.index, offset=0.0, width=0.1, sill=1, height=1)
                )
    light = next((r.scene.room.light for r in rooms if r.scene is not None and r.scene.room.light), None)
    height = home.storey(storey).height
    return Room.model_construct(
        type="home", outline=outline, height=height, doors=(), windows=tuple(seen.values()), finish=None, light=light
    )
