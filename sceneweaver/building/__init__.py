"""Scenes built in Python: furniture by words, places by relations, errors in one line."""

from .builder import ObjectHandle as ObjectHandle
from .builder import SceneBuilder as SceneBuilder
from .builder import build as build

__all__ = ["ObjectHandle", "SceneBuilder", "build"]
