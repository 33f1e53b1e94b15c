"""Drafts of rooms from a sentence, as a design begins."""

from __future__ import annotations

from sceneweaver.agent.design import chosen_room
from sceneweaver.agent.loop import empty_scene
from sceneweaver.assets import Library
from sceneweaver.generate.people import with_people
from sceneweaver.language import SceneGraph, read_request
from sceneweaver.scene import Scene
from sceneweaver.tools.base import Context
from sceneweaver.tools.init_prior import InitPrior


def brief_of(text: str) -> SceneGraph:
    """What a sentence asks for, with the places that its people need."""
    brief = read_request(text)
    return with_people(brief, chosen_room(brief)[0])


def drawn(text: str, library: Library) -> Scene:
    """The first scene of a sentence, its objects not laid out yet."""
    brief = brief_of(text)
    room = chosen_room(read_request(text))[0]
    scene = InitPrior().propose(Context(brief, room, empty_scene(brief, room), library, 0, text)).scene
    assert scene is not None
    return scene
