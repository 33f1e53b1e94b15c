"""Groups of furniture that belong together, as templates: a room's file names one and says what differs in it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from pydantic import Field, model_validator

from sceneweaver.io.messages import suggest
from sceneweaver.scene import InputError
from sceneweaver.scene.base import FrozenModel

from .model import Item, Place, check_items

MORE = "also"
"""Key of a changed item whose places are added to those of the template."""


class GroupTemplate(FrozenModel):
    """A group of furniture as a file in ``groups/`` has it.

    ``items`` are those of a room (see `Item`), in which relations name only each other and the room itself.
    """

    name: str
    description: str
    sources: tuple[str, ...] = Field(description="Where distances and sizes come from")
    items: tuple[Mapping[str, Any], ...]

    @model_validator(mode="after")
    def _check(self) -> GroupTemplate:
        check_items([Item.model_validate(data) for data in self.items])
        return self


class GroupUse(FrozenModel):
    """A template that a room uses, and what is different in it there."""

    use: str = Field(description="Name of the template")
    as_: str = Field(default="", alias="as", description="Put before the ids of the items: needed for a second use")
    drop: tuple[str, ...] = Field(default=(), description="Items that the room goes without, and relations to them")
    items: Mapping[str, Mapping[str, Any]] = Field(
        default={},
        description="By item the fields that differ; ``place`` takes the place of all relations, ``also`` is added",
    )


def expanded(data: Mapping[str, Any], templates: Mapping[str, GroupTemplate]) -> dict[str, Any]:
    """The data of a room's file with the items of its groups before its own.

    Raises:
        InputError: where a template or an item of one is unknown, or an id comes twice.
    """
    plain = dict(data)
    found: list[Mapping[str, Any]] = []
    for use in plain.pop("groups", ()):
        group = GroupUse.model_validate(use)
        if group.use not in templates:
            raise InputError(f'{plain.get("name")}: group "{group.use}" is unknown{suggest(group.use, templates)}')
        found += group_items(templates[group.use], group)
    return {**plain, "items": [*found, *plain.get("items", ())]}


def group_items(template: GroupTemplate, use: GroupUse) -> list[dict[str, Any]]:
    """The items of one use of a template, as a room's file would say them.

    Raises:
        InputError: where the use names an item that the template has not, or keeps what goes with a dropped one.
    """
    ids = [item["id"] for item in template.items]
    for name in (*use.drop, *use.items):
        if name not in ids:
            raise InputError(f'group "{use.use}": there is no item "{name}"{suggest(name, ids)}')
    prefix = f"{use.as_}_" if use.as_ else ""

    def renamed(name: str | None) -> str | None:
        return f"{prefix}{name}" if name in ids else name

    made = []
    for item in template.items:
        if item["id"] in use.drop:
            continue
        change = dict(use.items.get(item["id"], {}))
        added = _places(change.pop(MORE, ()))
        data = {**item, **change}
        for name in (data.get("with"), *data.get("on", ())):
            if name in use.drop:
                raise InputError(f'group "{use.use}": {item["id"]} goes with {name}, which is dropped; drop it as well')
        said = {(place.type, place.to) for place in added}
        kept = [p for p in _places(data.get("place", ())) if p.to not in use.drop and (p.type, p.to) not in said]
        data["id"] = renamed(item["id"])
        data["group"] = prefix + template.name
        data["place"] = [p.model_copy(update={"to": renamed(p.to)}) for p in (*kept, *added)]
        if data.get("with"):
            data["with"] = renamed(data["with"])
        if data.get("on"):
            data["on"] = [renamed(name) for name in data["on"]]
        made.append(data)
    return made


def _places(lines: Sequence[Any]) -> list[Place]:
    return [Place.model_validate(line) for line in lines]
