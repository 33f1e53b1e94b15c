"""Small homes for the tests of exports: a furnished flat, a house of two storeys, and rooms with slanted walls."""

from __future__ import annotations

import math
from functools import cache
from types import MappingProxyType

from sceneweaver.assets import Asset, make
from sceneweaver.home import Home, HomeDoor, HomeRoom, HomeWindow, Stair, Storey
from sceneweaver.scene import Pose, Scene, SceneObject, Support

_MADE = (make("desk", 2), make("filing_cabinet", 1), make("mug", 2), make("rug", 1), make("wall_mirror", 1))
ASSETS = MappingProxyType({asset.id: asset for asset in _MADE})
DESK, CABINET, MUG, RUG, MIRROR = _MADE


def rectangle(x0: float, y0: float, x1: float, y1: float) -> tuple[tuple[float, float], ...]:
    """Corners, counter-clockwise."""
    return (x0, y0), (x1, y0), (x1, y1), (x0, y1)


def load(asset: str) -> Asset:
    """The assets of these homes."""
    return ASSETS[asset]


def desk_with_mug(x: float, y: float, yaw: float) -> tuple[SceneObject, SceneObject]:
    """A desk with a mug on it."""
    top = DESK.surfaces[0]
    mug = MUG.object("mug", pose=Pose.from_yaw(x, y, top.z, 0.4), support=Support(object="desk", surface=top.name))
    return DESK.object("desk", pose=Pose.from_yaw(x, y, 0.0, yaw)), mug


@cache
def flat() -> Home:
    """The example's two bedrooms, living room, kitchen, bath and hall; its kitchen has a door that slides.

    Both bedrooms have the same things under the same ids; the living room a rug under the way of its double door.
    """
    home = Home.example("flat")
    doors = [d.model_copy(update={"kind": "sliding"}) if d.id == "door-kitchen" else d for d in home.doors]
    home = home.with_changes(doors=tuple(doors))
    crate = SceneObject(id="crate", category="unheard of", size=(0.4, 0.5, 0.6), pose=Pose.from_yaw(5.4, 4.6, 0.0, 0.3))
    mirror = MIRROR.object("mirror", pose=Pose.from_yaw(0.3, 6.9, 1.4, 0.0))
    things = {
        "bedroom": (*desk_with_mug(9.4, 2.6, math.pi), CABINET.object("cabinet", pose=Pose.from_yaw(8.6, 0.9, 0, 1.6))),
        "bedroom-2": (
            *desk_with_mug(9.3, 6.6, math.pi),
            CABINET.object("cabinet", pose=Pose.from_yaw(8.0, 7.2, 0, -1.6)),
        ),
        "living": (RUG.object("rug", pose=Pose.from_yaw(2.6, 2.6, 0.0, 0.2)), *desk_with_mug(1.2, 1.0, 0.3)),
        "kitchen": (mirror,),
        "hall": (crate,),
        "bath": (),
    }
    for room, objects in things.items():
        home = home.with_scene(room, Scene(id=room, room=home.shell(room), objects=objects))
    return home


@cache
def house(shape: str = "straight") -> Home:
    """A hall with a stair up to a landing with a bedroom, which has a balcony."""
    outline = {
        "straight": rectangle(0.3, 0.3, 1.3, 4.5),
        "u": rectangle(0.3, 0.3, 2.4, 3.3),
        "l": ((0.3, 0.3), (1.3, 0.3), (1.3, 2.3), (3.3, 2.3), (3.3, 3.3), (0.3, 3.3)),
    }[shape]
    well = {"straight": rectangle(0.3, 0.3, 1.3, 5.0), "u": rectangle(0.3, 0.3, 2.4, 5.0)}.get(
        shape, rectangle(0.3, 0.3, 3.3, 5.0)
    )
    x = well[1][0] + 0.1
    rooms = [
        HomeRoom(id=f"stairs-{k}", type="stairs", storey=storey, outline=well) for k, storey in enumerate(("low", "up"))
    ]
    rooms += [
        HomeRoom(id="hall", type="hall", storey="low", outline=rectangle(x, 0.3, x + 4.0, 5.0)),
        HomeRoom(id="bedroom", type="bedroom", storey="up", outline=rectangle(x, 0.3, x + 4.0, 5.0)),
        HomeRoom(
            id="balcony",
            type="balcony",
            storey="up",
            outdoor=True,
            outline=rectangle(x + 4.3, 0.3, x + 5.8, 3.0),
        ),
    ]
    doors = (
        HomeDoor(id="front", room="hall", wall=0, offset=1.5, width=0.9, opens_into=None, hinge="left"),
        HomeDoor(id="low", room="stairs-0", wall=1, offset=3.8, width=0.8, to="hall", kind="open"),
        HomeDoor(id="up", room="bedroom", wall=3, offset=0.1, width=0.8, to="stairs-1", opens_into="bedroom"),
        HomeDoor(id="out", room="bedroom", wall=1, offset=0.5, width=0.9, to="balcony", kind="sliding"),
    )
    window = HomeWindow(id="pane", room="bedroom", wall=2, offset=1.0, width=1.2)
    stair = Stair(
        id="stair",
        lower="stairs-0",
        upper="stairs-1",
        outline=outline,
        up=(0.0, 1.0),
        shape=shape,  # pyright: ignore[reportArgumentType]
        width=1.0,
        risers=16 if shape != "l" else 15,
        going=0.25,
    )
    home = Home(
        id="house",
        storeys=(Storey(id="low"), Storey(id="up", elevation=3.0)),
        rooms=tuple(rooms),
        doors=doors,
        windows=(window,),
        stairs=(stair,),
    )
    for room in ("hall", "bedroom"):
        objects = desk_with_mug(x + 2.4, 4.3, -math.pi / 2)
        home = home.with_scene(room, Scene(id=room, room=home.shell(room), objects=objects))
    return home


@cache
def slanted() -> Home:
    """Two rooms with a slanted wall between them, and a door through it."""
    a, b = (0.0, 0.0), (3.0, 0.0)
    one = HomeRoom(id="one", storey="ground", outline=(a, b, (5.0, 2.0), (5.0, 4.0), (0.0, 4.0)))
    two = HomeRoom(id="two", storey="ground", outline=((3.142, 0.0), (5.0, 0.0), (5.0, 1.858)))
    door = HomeDoor(id="between", room="one", wall=1, offset=1.0, width=0.8, to="two", opens_into="one")
    return Home(id="slanted", rooms=(one, two), doors=(door,))
