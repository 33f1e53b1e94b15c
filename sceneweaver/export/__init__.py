"""Scenes in the formats of other tools."""

from .glb import glb_bytes as glb_bytes
from .glb import write_glb as write_glb
from .mjcf import write_mjcf as write_mjcf

__all__ = ["glb_bytes", "write_glb", "write_mjcf"]
