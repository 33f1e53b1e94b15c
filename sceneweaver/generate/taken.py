"""Take a scene of somebody else as it is: nothing goes or moves, but what the request asks for is known in it."""

from __future__ import annotations

from sceneweaver.knowledge.kin import is_one
from sceneweaver.language import Entity
from sceneweaver.scene import Scene, SceneObject

from .given_room import with_openings
from .library import begun_with, related, with_intent
from .setup import Setup


def taken(setup: Setup, scene: Scene, tool: str, name: str) -> tuple[Scene, list[str], list[str]]:
    """The scene for this request, what was decided, and what could not be done.

    Objects that stand for something asked say so, and the relations that were asked for are added. A room without any
    opening gets a door and windows; its walls stay.

    Args:
        setup: the request.
        scene: of any origin.
        tool: who takes it.
        name: what it is called.
    """
    notes, unmet = list[str](), list[str]()
    if scene.dropped:
        notes.append(f"{len(scene.dropped)} things that had no place where it comes from are not looked for")
    kind = setup.room_type.name
    scene = begun_with(setup, scene, tool, name)
    scene = scene.model_copy(update={"room": scene.room.model_copy(update={"type": kind})})
    scene, said = with_openings(setup, scene)
    if said:
        notes.append(said)
    made: dict[str, list[str]] = {}
    for asked in setup.brief.entities:
        scene, made[asked.id] = _linked(scene, asked)
    return related(scene, setup.brief, made, unmet), notes, unmet


def _linked(scene: Scene, asked: Entity) -> tuple[Scene, list[str]]:
    """The scene in which those objects stand for something asked that a person would call so, and their ids."""
    free = [o for o in scene.objects if o.intent.request is None]
    fitting = [o for o in free if o.category == asked.category]
    fitting += [o for o in free if o.category != asked.category and is_one(o.category, asked.category, asked.noun)]
    most = asked.count[1] if asked.count else len(fitting)
    ids = [o.id for o in fitting[:most]]

    def marked(o: SceneObject) -> SceneObject:
        return with_intent(o, request=asked.id, priority="asked") if o.id in ids else o

    return scene.model_copy(update={"objects": tuple(marked(o) for o in scene.objects)}), ids
