"""The room around the furniture at eye level: joinery, trim, fittings and what is outside."""

from .build import Element as Element
from .build import build_interior as build_interior

__all__ = ["Element", "build_interior"]
