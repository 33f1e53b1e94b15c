"""Homes to draw: a flat with a little furniture, and a house of two storeys with a stair, an L and balconies."""

from __future__ import annotations

from functools import cache

import sceneweaver as sw
from sceneweaver.home import Home, HomeDoor, HomeRoom, HomeWindow, Stair, Storey

WIDE = (5.9, 1.3, 8.1, 3.9)


def box(x0: float, y0: float, x1: float, y1: float) -> tuple[tuple[float, float], ...]:
    return (x0, y0), (x1, y0), (x1, y1), (x0, y1)


def furnished(home: Home, room: str, *things: tuple[str, str]) -> Home:
    """The home with things placed along walls of a room, by words and the compass point they stand against."""
    building = sw.build(home.shell(room), name=room)
    for words, against in things:
        building.add(words, against=against)
    scene = sw.refine(building.scene(), candidates=8, seed=1, device="cpu").best
    return home.with_scene(room, scene)


@cache
def flat() -> Home:
    """The example with a bed, a wardrobe and a sofa."""
    home = Home.example("flat")
    home = furnished(home, "bedroom", ("double bed", "south"), ("wardrobe", "north"))
    return furnished(home, "living", ("sofa", "west"), ("bookcase", "north"))


@cache
def house() -> Home:
    """Two storeys: an L of a living room, a U of a stair, a terrace and a balcony behind sliding doors."""
    low, up = "ground", "upper"
    rooms = (
        HomeRoom(id="hall", type="hall", storey=low, outline=box(0.3, 0.3, 2.3, 3.9)),
        HomeRoom(id="wc", type="toilet", storey=low, outline=box(2.4, 0.3, 3.6, 1.9)),
        HomeRoom(
            id="kitchen",
            type="kitchen",
            storey=low,
            outline=((3.7, 0.3), (5.8, 0.3), (5.8, 3.9), (2.4, 3.9), (2.4, 2.0), (3.7, 2.0)),
        ),
        HomeRoom(id="stairs", type="stairs", storey=low, outline=box(5.9, 0.3, 8.1, 3.9)),
        HomeRoom(
            id="living",
            type="living_room",
            storey=low,
            outline=((0.3, 4.0), (8.1, 4.0), (8.1, 6.9), (4.6, 6.9), (4.6, 8.4), (0.3, 8.4)),
        ),
        HomeRoom(id="terrace", type="terrace", storey=low, outline=box(4.9, 7.2, 8.4, 9.0), outdoor=True),
        HomeRoom(id="landing", type="landing", storey=up, outline=box(2.4, 2.6, 5.8, 3.9)),
        HomeRoom(id="stairs-up", type="stairs", storey=up, outline=box(5.9, 0.3, 8.1, 3.9)),
        HomeRoom(id="bed-1", type="bedroom", storey=up, outline=box(0.3, 4.0, 4.2, 6.9)),
        HomeRoom(id="bed-2", type="bedroom", storey=up, outline=box(4.3, 4.0, 8.1, 6.9)),
        HomeRoom(id="bath", type="bathroom", storey=up, outline=box(0.3, 0.3, 2.3, 3.9)),
        HomeRoom(id="study", type="study", storey=up, outline=box(2.4, 0.3, 5.8, 2.5)),
        HomeRoom(id="balcony", type="balcony", storey=up, outline=box(4.3, 7.2, 8.1, 8.4), outdoor=True),
    )
    doors = (
        HomeDoor(id="front", room="hall", wall=0, offset=0.5, width=1.0, height=2.1, opens_into="hall", hinge="right"),
        HomeDoor(id="d-wc", room="wc", wall=3, offset=0.4, width=0.8, to="hall", opens_into="wc"),
        HomeDoor(id="d-kitchen", room="hall", wall=1, offset=2.2, width=0.9, to="kitchen", kind="sliding"),
        HomeDoor(
            id="d-living", room="living", wall=0, offset=0.4, width=1.4, to="hall", kind="double", opens_into="living"
        ),
        HomeDoor(id="d-eat", room="living", wall=0, offset=2.6, width=1.6, to="kitchen", kind="open"),
        HomeDoor(id="d-stairs", room="living", wall=0, offset=6.1, width=0.9, to="stairs", opens_into="living"),
        HomeDoor(id="d-terrace", room="living", wall=2, offset=0.6, width=2.0, to="terrace", kind="sliding"),
        HomeDoor(id="d-landing", room="landing", wall=1, offset=0.2, width=0.9, to="stairs-up", kind="open"),
        HomeDoor(id="d-bed-1", room="bed-1", wall=0, offset=2.5, width=0.8, to="landing", opens_into="bed-1"),
        HomeDoor(
            id="d-bed-2", room="bed-2", wall=0, offset=0.3, width=0.8, to="landing", opens_into="bed-2", hinge="right"
        ),
        HomeDoor(id="d-bath", room="bath", wall=1, offset=2.5, width=0.8, to="landing", opens_into="bath"),
        HomeDoor(id="d-study", room="study", wall=2, offset=1.2, width=0.8, to="landing", opens_into="study"),
        HomeDoor(id="d-balcony", room="bed-2", wall=2, offset=0.8, width=1.8, to="balcony", kind="sliding"),
    )
    windows = (
        HomeWindow(id="w-wc", room="wc", wall=0, offset=0.3, width=0.6, sill=1.4, height=0.6),
        HomeWindow(id="w-kitchen", room="kitchen", wall=0, offset=0.3, width=1.5, sill=1.0, height=1.2),
        HomeWindow(id="w-living-1", room="living", wall=5, offset=1.2, width=1.8),
        HomeWindow(id="w-living-2", room="living", wall=4, offset=1.0, width=2.4, sill=0.3, height=1.9),
        HomeWindow(id="w-stairs", room="stairs-up", wall=1, offset=1.0, width=1.0, sill=1.2, height=1.0),
        HomeWindow(id="w-bed-1", room="bed-1", wall=2, offset=1.2, width=1.6),
        HomeWindow(id="w-bed-2", room="bed-2", wall=1, offset=1.0, width=1.2),
        HomeWindow(id="w-bath", room="bath", wall=3, offset=1.4, width=0.8, sill=1.3, height=0.8),
        HomeWindow(id="w-study", room="study", wall=0, offset=0.8, width=1.6),
    )
    stair = Stair(
        id="stair",
        lower="stairs",
        upper="stairs-up",
        outline=box(*WIDE),
        up=(0.0, -1.0),
        shape="u",
        width=1.0,
        risers=16,
        going=0.22,
    )
    return Home(
        id="house",
        prompt="a small house for a family of four",
        storeys=(Storey(id=low, height=2.6), Storey(id=up, elevation=2.9, height=2.5)),
        rooms=rooms,
        doors=doors,
        windows=windows,
        stairs=(stair,),
    )
