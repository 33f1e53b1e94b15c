"""From requests to scenes: many rooms at once."""

from .scenes import produce

__all__ = ["produce"]
