"""Scenes in the formats of other tools."""

from .glb import glb_bytes as glb_bytes
from .glb import write_glb as write_glb

__all__ = ["glb_bytes", "write_glb"]
