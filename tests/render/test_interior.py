"""The room around the furniture at eye level: closed, in place, and never in the way of an object."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from sceneweaver.assets.body import Material
from sceneweaver.geometry.shell import WALL_THICKNESS
from sceneweaver.render.blocks import Builder, finishes_of
from sceneweaver.render.camera import Camera
from sceneweaver.render.interior import build_interior
from sceneweaver.render.interior.fittings import SOCKET, SWITCH, plan_fittings
from sceneweaver.render.mouldings import Plane, moulding, plate, rectangle
from sceneweaver.render.tracing import Triangles
from sceneweaver.scene import Door, Room, Scene, Window
from tests.render.scenes import box, everything, room_of, zoo
from tests.render.scenes import rectangle as room_outline

CLAY = Material("clay", (0.5, 0.5, 0.5))
L_ROOM = ((0.0, 0.0), (5.0, 0.0), (5.0, 2.0), (2.0, 2.0), (2.0, 4.0), (0.0, 4.0))


def volume(mesh) -> float:
    """Signed volume [m3] of closed bodies whose faces are outward."""
    a, b, c = (mesh.vertices[mesh.faces[:, k]] for k in range(3))
    return float((np.cross(a, b) * c).sum() / 6)


def living() -> Scene:
    room = Room(
        type="living_room",
        outline=room_outline(5.0, 4.0),
        doors=(Door(id="d", wall=0, offset=0.5, width=0.9, height=2.0, swing="in-right"),),
        windows=(Window(id="w", wall=2, offset=1.5, width=1.6, sill=0.9, height=1.3),),
    )
    desk = box("desk", 4.6, 2.0, size=(0.7, 1.4, 0.74), yaw=np.pi, category="desk")
    return room_of(desk, room=room)


@pytest.mark.parametrize("path", [rectangle((0, 2), (0, 1)), np.array(L_ROOM)])
def test_a_closed_moulding_has_the_volume_of_its_profile(path) -> None:
    builder, width, height = Builder(), 0.1, 0.2
    profile = [(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)]
    moulding(builder, Plane.floor(), path, profile, CLAY, closed=True)
    whole = shapely.Polygon(path)
    expected = height * (whole.area - whole.buffer(-width, join_style="mitre").area)
    mesh = builder.mesh()
    assert mesh is not None and volume(mesh) == pytest.approx(expected)


def test_open_mouldings_and_plates_are_closed_on_both_sides_of_a_wall() -> None:
    wall = living().room.walls[2]
    for plane in (Plane.on_wall(wall), Plane.on_wall(wall, 0.1)):
        builder = Builder()
        moulding(builder, plane, [(0, 0), (0, 2), (1, 2)], [(0, 0), (0.1, 0), (0.1, 0.1), (0, 0.1)], CLAY)
        plate(builder, plane, rectangle((3, 4), (0, 1)), (0.0, 0.1), CLAY)
        mesh = builder.mesh()
        # The mitre of the turn to the right lies outside of the path: two lengths, and the corner.
        assert mesh is not None and volume(mesh) == pytest.approx(0.1 * 0.1 * 3.1 + 0.1)


@pytest.mark.parametrize("scene", [living(), everything(), zoo("living-dining-L"), zoo("studio-U")], ids=lambda s: s.id)
def test_nothing_is_seen_past_the_room_but_through_windows(scene: Scene) -> None:
    parts = [part for part in build_interior(scene, finishes_of(scene)) if part.category != "outside"]
    starts = np.cumsum([0, *(len(part.mesh.vertices) for part in parts)])
    faces = np.concatenate([part.mesh.faces + start for part, start in zip(parts, starts, strict=False)])
    triangles = Triangles(np.concatenate([part.mesh.vertices for part in parts]), faces)
    x, y = shapely.Polygon(scene.room.outline).representative_point().coords[0]
    cameras = [Camera.look_at((x, y, 1.3), (x + a, y + b, 1.3 + c), 1.6) for a, b, c in _WAYS]
    assert (triangles.first_hits(cameras, 96, 96).face >= 0).all()


_WAYS = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]


def test_every_part_is_there_once_and_where_it_belongs() -> None:
    scene = living()
    parts = {part.name: part for part in build_interior(scene, finishes_of(scene))}
    expected = {
        "floor",
        "ceiling",
        "coving",
        "skirting",
        "fittings",
        "outside",
        "d",
        "w",
        *(f"wall:{k}" for k in range(4)),
    }
    assert set(parts) == expected
    assert parts["d"].category == "door" and parts["w"].category == "window"
    inner = shapely.Polygon(scene.room.outline)
    for name in ("d", "w", "skirting", "coving", "fittings"):
        plan = parts[name].mesh.vertices[:, :2]
        assert shapely.contains_xy(inner.buffer(WALL_THICKNESS + 0.07), *plan.T).all(), name
        assert not shapely.contains_xy(inner.buffer(-0.12), *plan.T).any(), name
    # The leaf fills its opening, but for a gap: no light comes in around it.
    door = parts["d"].mesh.bounds
    assert door[0, 0] < 0.5 and door[1, 0] > 1.4 and door[1, 2] == pytest.approx(2.0 + 0.058, abs=1e-3)


def test_an_open_door_has_no_leaf_and_a_corridor_behind_it() -> None:
    scene = living()
    camera = Camera.level((0.95, -0.3, 1.5), np.pi / 2, 1.2)
    (door,) = (part for part in build_interior(scene, finishes_of(scene), [camera]) if part.name == "d")
    mesh = door.mesh
    hits = Triangles(mesh.vertices, mesh.faces).first_hits([camera], 9, 9)
    assert hits.face[0, 4, 4] < 0  # free to look in
    back = Camera.level((0.95, 1.0, 1.5), -np.pi / 2, 0.3)
    assert (Triangles(mesh.vertices, mesh.faces).first_hits([back], 9, 9).face >= 0).all()


def test_switches_sockets_and_radiators_are_in_reach_and_in_nobodys_way() -> None:
    scene = living()
    found = plan_fittings(scene)
    (switch,) = found.switches
    # The hinge of a door that swings in to the right is at its far end: the handle, and so the switch, is at the near.
    assert switch.wall == 0 and switch.offset < 0.5 and switch.height == SWITCH
    assert len(found.sockets) >= 5 and {spot.height for spot in found.sockets} == {SOCKET}
    desk = [spot for spot in found.sockets if spot.wall == 1 and abs(abs(spot.offset - 2.0) - 0.82) < 0.01]
    assert len(desk) == 2
    (radiator,) = found.radiators
    assert radiator.wall == 2 and 1.5 <= radiator.along[0] < radiator.along[1] <= 3.1 and radiator.height[1] < 0.9


def test_a_radiator_keeps_away_from_furniture() -> None:
    scene = living()
    sofa = box("sofa", 2.7, 3.6, size=(0.8, 2.0, 0.8), yaw=-np.pi / 2, category="sofa")
    blocked = scene.model_copy(update={"objects": (*scene.objects, sofa)})
    (radiator,) = plan_fittings(blocked).radiators
    a, b = radiator.along
    wall = scene.room.walls[radiator.wall]
    strip = shapely.Polygon(wall.strip(a - 0.1, b - a + 0.2, 0.0, 0.195))
    for thing in blocked.objects:
        plan = shapely.Polygon(thing.pose.frame.to_world(np.array(thing.solids[0].polygon)))
        assert strip.intersection(plan).area < 1e-9
    low = living().room.windows[0].model_copy(update={"sill": 0.3})
    room = scene.room.model_copy(update={"windows": (low,)})
    (aside,) = plan_fittings(scene.model_copy(update={"room": room})).radiators
    assert aside.wall != 2 or aside.along[0] > 3.1 or aside.along[1] < 1.5
