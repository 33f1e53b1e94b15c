"""What the agent lays out first when it designs a kind of room: furniture, relations and the terms it is chosen by."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from benchmarks.designs import LIBRARY, request
from sceneweaver.agent.choice import choice_terms
from sceneweaver.agent.loop import empty_scene
from sceneweaver.agent.riders import searched, with_riders
from sceneweaver.critic import Review, review_scene
from sceneweaver.knowledge import RoomType, room_type
from sceneweaver.language import SceneGraph, read_request
from sceneweaver.layout import QualityTerm
from sceneweaver.scene import Scene
from sceneweaver.scene.edits import apply_all
from sceneweaver.tools.base import Context
from sceneweaver.tools.registry import tools
from sceneweaver.verify import Report, check


@dataclass(frozen=True)
class Draft:
    """A furnished room before its layout is searched: ``scene`` with all objects, ``plain`` as the search sees it."""

    scene: Scene
    room_type: RoomType
    brief: SceneGraph

    @cached_property
    def plain(self) -> Scene:
        """The scene in plainer shapes, without what stands on furniture."""
        return searched(self.scene)

    @cached_property
    def terms(self) -> list[QualityTerm]:
        """What its layouts are chosen by."""
        return choice_terms(self.plain, self.room_type)

    def judged(self, layout: Scene) -> tuple[Report, Review]:
        """What judge and critic say of a layout of the plain scene."""
        scene = with_riders(self.scene, layout)
        report = check(scene)
        return report, review_scene(scene, report, self.room_type, self.brief)


def draft(room: str, seed: int) -> Draft:
    """The first draft for the request of a kind of room."""
    kind, brief = room_type(room), read_request(request(room))
    context = Context(brief, kind, empty_scene(brief, kind), LIBRARY, seed)
    proposal = tools()["init_prior"].load().propose(context)
    assert proposal.scene is not None
    scene = apply_all(proposal.scene, proposal.edits)[0]
    if proposal.variants:
        scene = scene.model_copy(update={"relations": (*scene.relations, *proposal.variants[0])})
    return Draft(scene, kind, brief)
