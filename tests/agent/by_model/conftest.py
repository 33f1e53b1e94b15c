"""A small room with real furniture, and what a tool may look at in it."""

from __future__ import annotations

from collections.abc import Callable
from math import pi

import pytest

from sceneweaver.assets import Library, make
from sceneweaver.assets.sources.parametric import ParametricSource
from sceneweaver.knowledge import room_type
from sceneweaver.language import SceneGraph, read_request
from sceneweaver.scene import Door, Intent, Pose, Relation, Room, Scene, Support, Window
from sceneweaver.tools.base import Context

REQUEST = "a living room with a sofa, a coffee table and two armchairs, without a television"


@pytest.fixture(scope="session")
def library() -> Library:
    """Our own assets only, so that no store on this machine matters."""
    return Library(sources=[ParametricSource()])


@pytest.fixture(scope="session")
def lounge() -> Scene:
    """Valid: a sofa at the north wall, a table before it with a vase on it, two armchairs, a sideboard, a bookcase."""
    asked = {name: Intent(priority="asked", request=name) for name in ("sofa", "coffee_table", "armchair")}

    def put(category: str, name: str, x: float, y: float, yaw: float):
        made = make(category, seed=1).object(name, pose=Pose.from_yaw(x, y, 0, yaw))
        return made.model_copy(update={"intent": asked.get(category, Intent())})

    table = put("coffee_table", "coffee_table-0", 3.0, 3.2, pi / 2)
    top = table.surfaces[0]
    return Scene(
        id="lounge",
        room=Room(
            type="living_room",
            outline=((0, 0), (6, 0), (6, 5), (0, 5)),
            doors=(Door(id="door-0", wall=0, offset=0.3, width=0.9, height=2.1),),
            windows=(Window(id="window-0", wall=1, offset=1.6, width=1.8, sill=0.8, height=1.4),),
        ),
        objects=(
            put("sofa", "sofa-0", 3.0, 4.5, -pi / 2),
            table,
            make("vase", seed=1).object(
                "vase-0",
                pose=Pose.from_yaw(3.2, 3.2, top.z, 0),
                support=Support(object="coffee_table-0", surface=top.name),
            ),
            put("armchair", "armchair-0", 4.9, 2.6, 3.0),
            put("armchair", "armchair-1", 1.4, 2.4, 0.2),
            put("sideboard", "sideboard-0", 3.4, 0.3, pi / 2),
            put("bookcase", "bookcase-0", 0.25, 4.0, 0),
        ),
        relations=(
            Relation(type="front_to_front", subject="coffee_table-0", target="sofa-0", params={"gap": [0.2, 0.9]}),
            Relation(type="against_wall", subject="sofa-0"),
        ),
    )


@pytest.fixture(scope="session")
def context_of(library: Library) -> Callable[..., Context]:
    """What a tool may look at in a scene that stands for a request."""

    def made(scene: Scene, brief: SceneGraph | str = REQUEST, room: str = "living_room") -> Context:
        graph = read_request(brief) if isinstance(brief, str) else brief
        return Context(graph, room_type(room), scene, library, seed=3)

    return made
