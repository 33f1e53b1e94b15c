"""A scene and the design rules of its kind of room, as terms of design quality are made of them."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property

from sceneweaver.critic import kinds
from sceneweaver.critic.design.measure import LIGHT_SEATS
from sceneweaver.knowledge.design_rules import design_rules
from sceneweaver.layout import QualityTerm
from sceneweaver.scene import Scene, SceneObject

FLAT = 0.05
"""Height [m] up to which things are walked on."""


@dataclass(frozen=True)
class Rules:
    """A scene as terms are made for it, and the design rules of its kind of room."""

    scene: Scene
    room: str

    @cached_property
    def standing(self) -> list[SceneObject]:
        """What stands on the floor and is no rug, the largest first."""
        found = [o for o in self.scene.objects if o.mount == "floor" and o.size[2] > FLAT]
        return sorted(found, key=lambda o: -round(o.size[0] * o.size[1], 6))

    def of_kind(self, *categories: Iterable[str]) -> list[SceneObject]:
        """The objects of some categories, in the scene's order."""
        wanted = frozenset().union(*categories)
        return [o for o in self.scene.objects if o.category in wanted]

    @cached_property
    def ties(self) -> dict[str, list[str]]:
        """For each object those that a relation names with it, either way."""
        found: dict[str, list[str]] = defaultdict(list)
        for relation in self.scene.relations:
            for target in relation.targets:
                if target in self._index:
                    found[relation.subject].append(target)
                    found[target].append(relation.subject)
        return {name: list(dict.fromkeys(others)) for name, others in found.items()}

    @cached_property
    def _index(self) -> dict[str, SceneObject]:
        return {o.id: o for o in self.scene.objects}

    def tied(self, o: SceneObject, *categories: Iterable[str]) -> list[SceneObject]:
        """What a relation ties to an object, of some categories."""
        wanted = frozenset().union(*categories)
        others = [self._index[name] for name in self.ties.get(o.id, ())]
        return [other for other in others if other.category in wanted]

    @cached_property
    def movable(self) -> tuple[str, ...]:
        """Seats that whoever passes moves aside, and what is walked on."""
        return tuple(
            o.id
            for o in self.scene.objects
            if o.category in LIGHT_SEATS or kinds.upright_seat(o.category) or (o.mount == "floor" and o.size[2] <= FLAT)
        )

    def term(
        self,
        rule: str,
        kind: str,
        *objects: str,
        low: float | None = None,
        high: float | None = None,
        span: float,
        share: float = 1.0,
        **params: float,
    ) -> Iterator[QualityTerm]:
        """A term of a rule with a share of its points, where the rule is one for the room."""
        known = design_rules()[rule]
        if known.applies(self.room) and known.points > 0:
            bounds = {name: value for name, value in (("low", low), ("high", high)) if value is not None}
            yield QualityTerm(
                kind,
                objects,
                span=span,
                weight=share * known.points,
                params=params,
                rule=rule,
                most=known.most,
                **bounds,
            )
