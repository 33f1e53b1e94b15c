"""Rooms with real furniture for the tests of tools."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from sceneweaver.assets import Library, make
from sceneweaver.assets.sources.parametric import ParametricSource
from sceneweaver.knowledge import room_type
from sceneweaver.language import SceneGraph
from sceneweaver.scene import Door, Pose, Relation, Room, Scene, Support, Window
from sceneweaver.tools.base import Context, Proposal
from sceneweaver.tools.registry import tool

Call = Callable[..., Proposal]


@pytest.fixture(scope="session")
def library() -> Library:
    """Our own assets only, so that no store on this machine matters."""
    return Library(sources=[ParametricSource()])


@pytest.fixture(scope="session")
def call(library: Library) -> Call:
    """Call a tool by name on a scene."""

    def run(
        name: str,
        scene: Scene,
        inputs: dict[str, Any] | None = None,
        *,
        room: str = "living_room",
        seed: int = 0,
        instruction: str = "",
        brief: SceneGraph | None = None,
    ) -> Proposal:
        context = Context(
            brief or SceneGraph(text=""), room_type(room), scene, library, seed, instruction, inputs or {}
        )
        return tool(name).load().propose(context)

    return run


def room_of(kind: str = "living_room", width: float = 6.0, depth: float = 5.0) -> Room:
    """A room with a door in its south wall and a window in its east wall."""
    return Room(
        type=kind,
        outline=((0, 0), (width, 0), (width, depth), (0, depth)),
        doors=(Door(id="door-0", wall=0, offset=0.3, width=0.9, height=2.1),),
        windows=(Window(id="window-0", wall=1, offset=depth / 2 - 0.9, width=1.8, sill=0.8, height=1.4),),
    )


@pytest.fixture(scope="session")
def lounge() -> Scene:
    """A sofa at the north wall, a table before it with a vase on it, an armchair, a cabinet; valid."""
    table = make("coffee_table", seed=1).object("coffee_table-0", pose=Pose.from_yaw(3.0, 3.2, 0, 1.5707963))
    top = table.surfaces[0]
    objects = (
        make("sofa", seed=1).object("sofa-0", pose=Pose.from_yaw(3.0, 4.5, 0, -1.5707963)),
        table,
        make("vase", seed=1).object(
            "vase-0",
            pose=Pose.from_yaw(3.2, 3.2, top.z, 0),
            support=Support(object="coffee_table-0", surface=top.name),
        ),
        make("armchair", seed=1).object("armchair-0", pose=Pose.from_yaw(4.9, 2.6, 0, 3.0)),
        make("sideboard", seed=1).object("sideboard-0", pose=Pose.from_yaw(0.3, 2.5, 0, 0)),
    )
    relations = (
        Relation(type="front_to_front", subject="coffee_table-0", target="sofa-0", params={"gap": [0.2, 0.9]}),
        Relation(type="facing", subject="armchair-0", target="coffee_table-0", params={"degrees": 40}),
    )
    return Scene(id="lounge", room=room_of(), objects=objects, relations=relations)
