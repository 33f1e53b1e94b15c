"""Floor that a scene keeps free: room to turn, to play, to walk, to open and to pass."""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

from pydantic import Field

from .base import FrozenModel
from .fields import Id, Length, Name
from .limits import MAX_OBJECTS
from .objects import Pose

FreeAreaKind = Literal["rectangle", "circle", "clearance", "gap", "path"]


class FreeArea(FrozenModel):
    """Floor that nothing taller than a rug stands on.

    A ``rectangle`` or ``circle`` lies at its pose, at its targets if it has some: the layout moves it with the
    furniture. A ``clearance`` is a strip along sides of each target, a ``gap`` lies between any two targets (or between
    a target and the walls), a ``path`` leads from its first target to the others, or from the doors to everything.
    Targets that are not in the scene do not count, so things may come and go.

    Examples:
        >>> import sceneweaver as sw
        >>> turning = sw.scene.FreeArea(id="turning", kind="circle", size=(1.5, 1.5))
        >>> turning.targets
        ()
    """

    _noun: ClassVar[str] = "free area"

    id: Id = Field(description="Unique among free areas")
    kind: FreeAreaKind
    size: tuple[Length, Length] = Field(
        description="Along its front and across [m]; the diameter of a circle or the least width of other kinds, twice"
    )
    most: Length | None = Field(default=None, description="Largest width of a gap or path [m]; null: any")
    pose: Pose = Field(
        default=Pose.model_construct(position=(0.0, 0.0, 0.0), quaternion=(0.0, 0.0, 0.0, 1.0)),
        description="Middle of a rectangle or circle, on the floor",
    )
    targets: Annotated[tuple[Name, ...], Field(max_length=MAX_OBJECTS)] = Field(
        default=(), description='Ids of objects, doors or windows, or "wall" or "middle"'
    )
    side: Literal["front", "back", "left", "right", "sides", "long", "around", "any"] = Field(
        default="any", description="Which sides of the targets; sides: left and right, long: both that are longer"
    )
    request: Name | None = Field(default=None, description="Id of what the request states; null: of nothing")
