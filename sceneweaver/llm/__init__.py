"""Language and vision models: endpoints, budgets, records and replay. Nothing here knows what a room is."""

from .client import ModelClient as ModelClient
from .errors import BudgetSpent as BudgetSpent
from .errors import ModelError as ModelError
from .errors import ModelFailed as ModelFailed
from .errors import ModelUnreachable as ModelUnreachable
from .reply import Picture as Picture
from .reply import Reply as Reply

__all__ = ["BudgetSpent", "ModelClient", "ModelError", "ModelFailed", "ModelUnreachable", "Picture", "Reply"]
