"""Grades for a scene, with reasons and with what would mend it."""

from .model import CRITERIA as CRITERIA
from .model import STATUSES as STATUSES
from .model import Alignment as Alignment
from .model import Fault as Fault
from .model import ItemOutcome as ItemOutcome
from .model import Review as Review
from .model import VisualFault as VisualFault
from .model import VisualReview as VisualReview
from .own import define_check as define_check
from .own import undefine_check as undefine_check
from .phrases import Phrase as Phrase
from .phrases import phrases as phrases
from .review import review_scene as review_scene

__all__ = [
    "CRITERIA",
    "STATUSES",
    "Alignment",
    "Fault",
    "ItemOutcome",
    "Phrase",
    "Review",
    "VisualFault",
    "VisualReview",
    "define_check",
    "phrases",
    "review_scene",
    "undefine_check",
]
