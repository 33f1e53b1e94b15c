"""What the relations of a variant name stays known when something of a scene is left out."""

from __future__ import annotations

from sceneweaver.agent.executor import remaining
from sceneweaver.scene import Relation, Room, Scene, SceneObject


def box(name: str) -> SceneObject:
    return SceneObject(id=name, category="cabinet", size=(0.6, 0.6, 0.9))


def test_walls_of_a_variant_stay():
    room = Room(outline=((0, 0), (4, 0), (4, 3), (0, 3)))
    pinned = Relation(type="against_wall", subject="a", target="wall:2")
    beside = Relation(type="run_on", subject="b", target="a")
    scene = Scene(id="s", room=room, objects=(box("a"),))
    assert remaining(scene, [(pinned, beside)]) == [(pinned,)]
