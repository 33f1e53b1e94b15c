"""Plans of homes, practices and offices: what they are to hold, the rules that they keep, and whether they do."""

from importlib import import_module as _import_module
from typing import TYPE_CHECKING as _TYPE_CHECKING

from .check import check_plan as check_plan
from .envelope import Envelope as Envelope
from .envelope import envelope_for as envelope_for
from .profile import MEASURES as MEASURES
from .profile import Profile as Profile
from .profile import Rule as Rule
from .profile import profile_names as profile_names
from .programme import Programme as Programme
from .programme import programme_names as programme_names
from .report import PlanReport as PlanReport
from .report import PlanViolation as PlanViolation
from .room_specs import Adjacency as Adjacency
from .room_specs import RoomSpec as RoomSpec
from .room_types import RoomType as RoomType
from .room_types import room_type as room_type
from .room_types import room_types as room_types

if _TYPE_CHECKING:
    from .feasibility import feasible as feasible
    from .feasibility import totalled as totalled
    from .solve import solve_plans as solve_plans
    from .solve_solution import PlanSolution as PlanSolution

_SOLVER = {
    "feasible": "feasibility",
    "totalled": "feasibility",
    "solve_plans": "solve",
    "PlanSolution": "solve_solution",
}
"""Names that bring Warp along, with their modules: imported when they are first used."""


def __getattr__(name: str) -> object:
    if name in _SOLVER:
        return getattr(_import_module(f"{__name__}.{_SOLVER[name]}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


__all__ = [
    "MEASURES",
    "Adjacency",
    "Envelope",
    "PlanReport",
    "PlanSolution",
    "PlanViolation",
    "Profile",
    "Programme",
    "RoomSpec",
    "RoomType",
    "Rule",
    "check_plan",
    "envelope_for",
    "feasible",
    "profile_names",
    "programme_names",
    "room_type",
    "room_types",
    "solve_plans",
    "totalled",
]
