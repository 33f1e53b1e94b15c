"""One relation to judge, with all that its judge needs."""

from __future__ import annotations

from typing import Any, NamedTuple

from sceneweaver.io import InputError
from sceneweaver.scene import Relation
from sceneweaver.scene.catalogue import CATALOGUE, RelationSpec
from sceneweaver.verify.solids import Body, Placed


class Case(NamedTuple):
    """A relation to judge: where, its subject, its target when that is an object, and the catalogue's entry."""

    placed: Placed
    relation: Relation
    subject: Body
    target: Body | None
    spec: RelationSpec

    @classmethod
    def of(cls, placed: Placed, relation: Relation) -> Case:
        """The case of a relation whose subject and target are in the scene."""
        spec, target = CATALOGUE[relation.type], relation.target
        other = placed.by_id[target] if spec.target_kind == "object" and isinstance(target, str) else None
        return cls(placed, relation, placed.by_id[relation.subject], other, spec)

    def number(self, name: str) -> float:
        """The number called ``name``: the relation's own, else the catalogue's."""
        return float(self.spec.value(self.relation, name))

    @property
    def other(self) -> Body:
        """The target object."""
        if self.target is None:
            raise InputError(f"relation {self.relation.type} of {self.relation.subject}: needs an object as its target")
        return self.target

    @property
    def scope(self) -> dict[str, Any]:
        """The names that expressions of its rows know: params, and the two things as ``a`` and ``b``."""
        return {**self.spec.scope(self.relation, self.subject.size[0]), "a": self.subject, "b": self.target}
