"""Plain English in, a typed scene graph out; no model is needed."""

from .grounding import Grounded as Grounded
from .grounding import carrier_of as carrier_of
from .grounding import grounded as grounded
from .meaning import Meaning as Meaning
from .meaning import meaning as meaning
from .meaning import meanings as meanings
from .model import Attribute as Attribute
from .model import Entity as Entity
from .model import Exclusion as Exclusion
from .model import SceneGraph as SceneGraph
from .model import Span as Span
from .model import StatedFinish as StatedFinish
from .model import StatedLook as StatedLook
from .model import StatedMeasure as StatedMeasure
from .model import StatedRelation as StatedRelation
from .model import Unread as Unread
from .pairs import Thing as Thing
from .read import read_request as read_request

__all__ = [
    "Attribute",
    "Entity",
    "Exclusion",
    "Grounded",
    "Meaning",
    "SceneGraph",
    "Span",
    "StatedFinish",
    "StatedLook",
    "StatedMeasure",
    "StatedRelation",
    "Thing",
    "Unread",
    "carrier_of",
    "grounded",
    "meaning",
    "meanings",
    "read_request",
]
