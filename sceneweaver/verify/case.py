"""One relation to judge, with all that its judge needs."""

from __future__ import annotations

from typing import NamedTuple

from sceneweaver.scene import Relation
from sceneweaver.scene.catalogue import RelationSpec
from sceneweaver.scene.errors import InputError
from sceneweaver.verify.solids import Body, Placed


class Case(NamedTuple):
    """A relation to judge: where, its subject, its target when that is an object, and the catalogue's entry."""

    placed: Placed
    relation: Relation
    subject: Body
    target: Body | None
    spec: RelationSpec

    def number(self, name: str) -> float:
        """The number called ``name``: the relation's own, else the catalogue's."""
        return float(self.spec.value(self.relation, name))

    @property
    def other(self) -> Body:
        """The target object."""
        if self.target is None:
            raise InputError(f"relation {self.relation.type} of {self.relation.subject}: needs an object as its target")
        return self.target
