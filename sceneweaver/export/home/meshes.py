"""What of a home is seen beside its things, each once, as meshes in the home's frame.

A wall shows in each room the paint of that room. Ceilings are single sheets that are seen from below only: who looks
from above sees into the rooms, as most viewers leave out the backs of faces.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from sceneweaver.assets import Material, Mesh
from sceneweaver.assets.room_looks import PAINT, room_looks, wall_look
from sceneweaver.geometry.shell import FLOOR_THICKNESS, heights
from sceneweaver.home import Home, HomeDoor, HomeWindow
from sceneweaver.home.treads import treads
from sceneweaver.scene import Room

from ..bodies import some_faces
from ..openings import window_mesh
from ..room import manifold_mesh
from .names import HomeNames
from .pieces import polygons
from .structure import RAILING, StoreyPlan, deck, stair_steps

_OUTSIDE = replace(PAINT, name="outer wall")
_RAILING = Material("railing", (0.3, 0.31, 0.32), roughness=0.4, metallic=0.6)
_TREAD = Material("tread", (0.62, 0.46, 0.31), roughness=0.5, texture="oak")
_AHEAD = 0.02  # [m] before a face of a wall is the room that sees it
_APART = 1e-3  # [m] between a deck and the ceilings below it


@dataclass(frozen=True, eq=False)
class Part:
    """Something that is seen: its name in the home, what it is, and its mesh; ``room``: in which room it is."""

    name: str
    kind: str
    mesh: Mesh
    room: str | None = None


def structure_parts(home: Home, plans: list[StoreyPlan], names: HomeNames) -> list[Part]:
    """Floors and ceilings of rooms, walls of storeys, decks, railings, stairs and windows."""
    found = []
    for k, plan in enumerate(plans):
        storey = plan.storey.id
        rooms = {r.id: _looked(home, r.id) for r in home.rooms_of(storey)}
        found += _floors(home, plan, rooms)
        walls = _walls(plan, rooms)
        if len(walls.faces):
            found.append(Part(f"{names.home}:walls:{storey}", "wall", walls))
        if k:
            floor, low = deck(plan, plans[k - 1])
            solid = extruded(floor, low + _APART, plan.low - FLOOR_THICKNESS)
            if solid.num_tri():
                found.append(Part(f"{names.home}:floor:{storey}", "floor", manifold_mesh(solid, _OUTSIDE)))
        for room, rail in plan.railings().items():
            made = manifold_mesh(extruded(rail, plan.low, plan.low + RAILING[1]), _RAILING)
            found.append(Part(f"{names.home}:railing:{room}", "railing", made, room))
        for opening in plan.openings:
            if isinstance(opening.opening, HomeWindow):
                room, up = rooms[opening.opening.room], plan.low
                window = next(w for w in room.windows if w.id == opening.opening.id)
                mesh = _lifted(window_mesh(room, window, opening.thickness), up)
                found.append(Part(f"{names.home}:window:{window.id}", "window", mesh))
    for stair, steps in stair_steps(home).items():
        found.append(Part(f"{names.home}:stair:{stair}", "stair", _stair(steps)))
    return found


def by_material(mesh: Mesh) -> list[Mesh]:
    """A mesh as one of each material that it has."""
    found = []
    for number in np.unique(mesh.face_material).tolist():
        part = some_faces(mesh, mesh.face_material == number)
        zeros = np.zeros(len(part.faces), dtype=np.int32)
        found.append(replace(part, face_material=zeros, materials=(mesh.materials[number],)))
    return found


def extruded(plan: Any, low: float, high: float) -> Any:
    """A plan as a manifold from one height to another [m]."""
    from manifold3d import CrossSection, FillRule, Manifold

    rings = [np.asarray(ring.coords)[:-1] for p in polygons(plan) for ring in (p.exterior, *p.interiors)]
    if not rings:
        return Manifold()
    return Manifold.extrude(CrossSection(rings, FillRule.EvenOdd), high - low).translate((0.0, 0.0, low))


def _looked(home: Home, room_id: str) -> Room:
    """A room with its openings, in the finish of its scene."""
    shell, scene = home.shell(room_id), home.room(room_id).scene
    return shell if scene is None else shell.model_copy(update={"finish": scene.room.finish, "type": scene.room.type})


def _floors(home: Home, plan: StoreyPlan, rooms: dict[str, Room]) -> list[Part]:
    """The floor of each room with the thresholds of the doors that are given by it, and its ceiling."""
    found = []
    for room in home.rooms_of(plan.storey.id):
        own = {**plan.rooms, **plan.outdoors}[room.id]
        doors = [o for o in plan.openings if isinstance(o.opening, HomeDoor) and o.opening.room == room.id]
        for opening in doors:
            own = own.union(plan.walls.intersection(plan.hole(opening)))
        floor = extruded(own.difference(plan.holes), plan.low - FLOOR_THICKNESS, plan.low)
        looks = room_looks(rooms[room.id])
        if floor.num_tri():
            found.append(Part(f"{room.id}:floor", "floor", manifold_mesh(floor, looks.floor), room.id))
        if room.outdoor:
            continue
        above = extruded(plan.rooms[room.id].difference(_open_above(home, plan)), plan.high, plan.high + 1)
        sheet = _sheet(manifold_mesh(above, PAINT))
        if len(sheet.faces):
            painted = looks.ceiling or replace(looks.wall, name="ceiling")
            found.append(Part(f"{room.id}:ceiling", "ceiling", replace(sheet, materials=(painted,)), room.id))
    return found


def _open_above(home: Home, plan: StoreyPlan) -> Any:
    """Where stairs go up through the ceiling of a storey."""
    import shapely

    here = {room.id for room in home.rooms_of(plan.storey.id)}
    return shapely.union_all([shapely.Polygon(t.plan) for s in home.stairs if s.lower in here for t in treads(s)])


def _sheet(mesh: Mesh) -> Mesh:
    """The underside of a mesh."""
    corners = mesh.vertices[mesh.faces]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return some_faces(mesh, normal[:, 2] < -0.9 * np.linalg.norm(normal, axis=1))


def _walls(plan: StoreyPlan, rooms: dict[str, Room]) -> Mesh:
    """The walls of a storey with their openings, each face in the paint of the room that sees it."""
    solid = extruded(plan.walls, plan.low - FLOOR_THICKNESS, plan.high)
    for opening in plan.openings:
        low, high = (plan.low + z for z in heights(opening.opening))
        # What ends at the floor or the ceiling is cut a little beyond, so that no film of wall is left.
        low = plan.low - FLOOR_THICKNESS - 0.1 if low <= plan.low + 1e-6 else low
        high = high + 0.1 if high >= plan.high - 1e-6 else high
        solid = solid - extruded(plan.hole(opening), low, high)
        pocket = plan.pockets.get(opening.opening.id)
        if pocket is not None:
            solid = solid - extruded(pocket.plan, plan.low, high)
    return _painted(manifold_mesh(solid, PAINT), plan, rooms)


def _painted(mesh: Mesh, plan: StoreyPlan, rooms: dict[str, Room]) -> Mesh:
    """The walls of a storey, each face in the paint of the room before it; in openings and on top they are plain."""
    import shapely

    looks: list[Material] = [_OUTSIDE, PAINT]
    face_material = np.ones(len(mesh.faces), dtype=np.int32)
    corners = mesh.vertices[mesh.faces]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-30)
    middle = corners.mean(axis=1)
    upright = np.abs(normal[:, 2]) < 0.5
    before = middle[:, :2] + _AHEAD * normal[:, :2]
    left = upright & ~shapely.contains_xy(plan.walls, *before.T)
    face_material[left & ~_within(plan, before)] = 0
    for name, floor in {**plan.rooms, **plan.outdoors}.items():
        mine = np.flatnonzero(left & shapely.contains_xy(floor, *before.T))
        if not len(mine):
            continue
        room = rooms[name]
        nearest = [_wall_at(room, point, way) for point, way in zip(middle[mine], normal[mine], strict=True)]
        for face, wall in zip(mine, nearest, strict=True):
            look = wall_look(room, wall)
            if look not in looks:
                looks.append(look)
            face_material[face] = looks.index(look)
    return replace(mesh, face_material=face_material, materials=tuple(looks))


def _within(plan: StoreyPlan, points: np.ndarray) -> np.ndarray:
    """Whether points [N, 2] are in a room, or in an opening."""
    import shapely

    places = [*plan.rooms.values(), *map(plan.hole, plan.openings), *(p.plan for p in plan.pockets.values())]
    return shapely.contains_xy(shapely.union_all(places), *points.T)


def _wall_at(room: Room, point: np.ndarray, way: np.ndarray) -> int:
    """The number of the wall of a room on whose face a point lies."""

    def off(wall: Any) -> float:
        along, depth = wall.coordinates(point[:2])
        beyond = along - min(max(along, 0.0), wall.length)
        return abs(depth) + abs(beyond) + (1.0 - float(np.dot(wall.inward, way[:2])))

    return min(room.walls, key=off).index


def _stair(steps: list[tuple[np.ndarray, float, float]]) -> Mesh:
    """Treads, one on another, as one mesh."""
    from manifold3d import Manifold
    from shapely import Polygon

    solid = Manifold()
    for plan, low, high in steps:
        solid = solid + extruded(Polygon(plan), low, high)
    return manifold_mesh(solid, _TREAD)


def _lifted(mesh: Mesh, up: float) -> Mesh:
    return replace(mesh, vertices=mesh.vertices + (0.0, 0.0, up)) if up else mesh
