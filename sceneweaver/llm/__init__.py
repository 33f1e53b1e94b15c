"""Language and vision models: endpoints, budgets, records and replay. Nothing here knows what a room is."""

from .budget import Limits as Limits
from .budget import Usage as Usage
from .client import ModelClient as ModelClient
from .endpoint import Endpoint as Endpoint
from .errors import BudgetSpent as BudgetSpent
from .errors import ModelError as ModelError
from .errors import ModelFailed as ModelFailed
from .errors import ModelUnreachable as ModelUnreachable
from .errors import ReplayError as ReplayError
from .opening import open_client as open_client
from .prices import Prices as Prices
from .reply import Picture as Picture
from .reply import Reply as Reply
from .secrets import redact as redact

__all__ = [
    "BudgetSpent",
    "Endpoint",
    "Limits",
    "ModelClient",
    "ModelError",
    "ModelFailed",
    "ModelUnreachable",
    "Picture",
    "Prices",
    "ReplayError",
    "Reply",
    "Usage",
    "open_client",
    "redact",
]
