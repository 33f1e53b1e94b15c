"""Plain English in, a typed scene graph out; no model is needed."""

from .meaning import Meaning as Meaning
from .meaning import meaning as meaning
from .meaning import meanings as meanings
from .model import Attribute as Attribute
from .model import Entity as Entity
from .model import Exclusion as Exclusion
from .model import SceneGraph as SceneGraph
from .model import Span as Span
from .model import StatedRelation as StatedRelation
from .model import Unread as Unread
from .read import read_request as read_request

__all__ = [
    "Attribute",
    "Entity",
    "Exclusion",
    "Meaning",
    "SceneGraph",
    "Span",
    "StatedRelation",
    "Unread",
    "meaning",
    "meanings",
    "read_request",
]
