"""What a scene is: the typed form of ``scene.json`` (schema ``sceneweaver.scene/1``).

Units are metres and radians, z is up, yaw is counter-clockwise about +z and the front of an object is +x at yaw 0.
An object's origin is the bottom centre of its box; ``size`` is (depth along the front, width, height).
Polygons of parts, zones and surfaces are in the object's frame, counter-clockwise.

Making a model checks it and raises InputError with one line; models are frozen, edits return new ones. The
dictionaries in them (``params``, ``attributes``, ``provenance``) are to be read only, too.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any, Literal, Self

from pydantic import Field, model_validator

from sceneweaver.io import InputError
from sceneweaver.io.messages import quote, suggest

from .fields import JsonDict, Name, Text
from .free_area import FreeArea
from .io import SceneFile
from .limits import MAX_FREE_AREAS, MAX_OBJECTS, MAX_RELATIONS, MAX_SHAPES
from .messages import FieldError
from .migrate import SCHEMA
from .objects import Dropped, Pose, SceneObject
from .palette import Palette
from .references import check_free_areas, check_references
from .relation import Relation
from .room import Room


class SceneContent(SceneFile):
    """What a scene holds, checked as a whole; `Scene` adds the edits as methods."""

    schema_: Literal["sceneweaver.scene/1"] = Field(default=SCHEMA, alias="schema")
    id: Name = Field(description="Name of the scene")
    prompt: Text = Field(default="", description="The request that it answers")
    room: Room = Field(description="Outline, doors, windows")
    objects: Annotated[tuple[SceneObject, ...], Field(fail_fast=True, max_length=MAX_OBJECTS)] = Field(
        default=(), description="What is in the room"
    )
    relations: Annotated[tuple[Relation, ...], Field(fail_fast=True, max_length=MAX_RELATIONS)] = Field(
        default=(), description="What has to hold between its things"
    )
    free_areas: Annotated[tuple[FreeArea, ...], Field(fail_fast=True, max_length=MAX_FREE_AREAS)] = Field(
        default=(), description="Floor that stays free"
    )
    palette: Palette | None = Field(default=None, description="The look that its things follow; null: each its own")
    provenance: JsonDict = Field(default_factory=dict, description="Free data: where the scene comes from")
    dropped: Annotated[tuple[Dropped, ...], Field(fail_fast=True, max_length=MAX_OBJECTS)] = Field(
        default=(), description="What was asked for and could not be placed; anything here makes the scene invalid"
    )

    @model_validator(mode="after")
    def _check(self) -> Self:
        shapes = sum(len(o.parts or ()) + len(o.zones) + len(o.surfaces) for o in self.objects)
        if shapes > MAX_SHAPES:
            raise FieldError(("objects",), f": have {shapes} parts, zones and surfaces; give at most {MAX_SHAPES}")
        check_references(self.room, self.objects, self.relations)
        check_free_areas(self.free_areas)
        return self

    @classmethod
    def _prefix(cls, data: Any) -> str:
        return ""

    @property
    def ids(self) -> tuple[str, ...]:
        """The ids of the objects, in order."""
        return tuple(self._positions())

    def index(self, object_id: str) -> int:
        """The position of an object in ``objects``; InputError when there is none of that id."""
        lookup = self._positions()
        if object_id not in lookup:
            raise InputError(
                f"{quote(object_id)} is no object of scene {quote(self.id)}{suggest(object_id, lookup, mark=chr(39))}"
            )
        return lookup[object_id]

    def object(self, object_id: str) -> SceneObject:
        """The object of that id; InputError when there is none."""
        return self.objects[self.index(object_id)]

    def replace_poses(self, poses: Mapping[str, Pose]) -> Self:
        """The scene with some objects elsewhere; quick, as nothing but the ids is checked again.

        Raises:
            InputError: for an id that is no object of the scene.
        """
        objects = list(self.objects)
        for object_id, pose in poses.items():
            at = self.index(object_id)
            objects[at] = objects[at].model_copy(update={"pose": pose})
        return self.model_copy(update={"objects": tuple(objects)})

    def replace_area_poses(self, poses: Mapping[str, Pose]) -> Self:
        """The scene with some of its free areas elsewhere, by their ids."""
        areas = [a.model_copy(update={"pose": poses[a.id]}) if a.id in poses else a for a in self.free_areas]
        return self.model_copy(update={"free_areas": tuple(areas)})

    def _positions(self) -> dict[str, int]:
        """Position in ``objects`` by id, kept with them, as copies of a model share what it keeps."""
        kept = self.__dict__.get("_kept_lookup")
        if kept is None or kept[0] is not self.objects:
            kept = (self.objects, {o.id: i for i, o in enumerate(self.objects)})
            object.__setattr__(self, "_kept_lookup", kept)
        return kept[1]
