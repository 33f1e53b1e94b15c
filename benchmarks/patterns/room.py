"""A designed room as the patterns look at it, and how often it has one."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from sceneweaver.critic import Fault, Review, review_scene
from sceneweaver.critic.survey import Survey
from sceneweaver.knowledge import room_type
from sceneweaver.language import read_request
from sceneweaver.scene import Scene
from sceneweaver.verify import check


class Hits(NamedTuple):
    """How often a pattern is there, out of how many, and on which objects."""

    found: int
    of: int
    objects: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class Room:
    """A designed room as the patterns look at it."""

    survey: Survey
    review: Review

    @classmethod
    def of(cls, scene: Scene) -> Room:
        """Judge a scene that was designed for its prompt, and review it."""
        report, kind, brief = check(scene), room_type(scene.room.type), read_request(scene.prompt)
        return cls(Survey.of(scene, report, kind, brief), review_scene(scene, report, kind, brief))

    @property
    def kind(self) -> str:
        """The kind of room."""
        return self.survey.room_type.name

    @cached_property
    def faults(self) -> Mapping[str, list[Fault]]:
        """The critic's faults by kind."""
        found: dict[str, list[Fault]] = {}
        for fault in self.review.faults:
            found.setdefault(fault.kind, []).append(fault)
        return found

    def named(self, *rules: str) -> list[str]:
        """The objects of the faults of some rules; an empty name for one that is about the room."""
        faults = [f for rule in rules for f in self.faults.get(rule, ())]
        return list(dict.fromkeys(name for f in faults for name in (f.objects or ("",))))
