"""Scenes and homes in the formats of other tools. Writers are imported when they are first used."""

from importlib import import_module as _import_module
from typing import TYPE_CHECKING

from .formats import FORMATS as FORMATS
from .formats import export_file as export_file
from .formats import export_home as export_home
from .formats import export_scene as export_scene
from .formats import format_named as format_named
from .formats import formats_named as formats_named

if TYPE_CHECKING:
    from .glb import glb_bytes as glb_bytes
    from .glb import write_glb as write_glb
    from .mjcf import write_mjcf as write_mjcf
    from .scenestate import write_scenestate as write_scenestate
    from .urdf import write_urdf as write_urdf
    from .usd import write_usd as write_usd

__all__ = [
    "FORMATS",
    "export_file",
    "export_home",
    "export_scene",
    "format_named",
    "formats_named",
    "glb_bytes",
    "write_glb",
    "write_mjcf",
    "write_scenestate",
    "write_urdf",
    "write_usd",
]


def __getattr__(name: str) -> object:
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(_import_module(f"{__name__}.{name.removeprefix('write_').removesuffix('_bytes')}"), name)
