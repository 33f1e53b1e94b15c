"""The ray caster: pictures of meshes with the light of the real world, or in plain light for a draft."""

from .lights import DirectLights as DirectLights
from .lights import Lights as Lights
from .lights import Portal as Portal
from .lights import interior_lights as interior_lights
from .rays import Triangles as Triangles
from .tracer import Quality as Quality
from .tracer import TracedPicture as TracedPicture
from .tracer import Tracer as Tracer
from .tracer import trace as trace

__all__ = [
    "DirectLights",
    "Lights",
    "Portal",
    "Quality",
    "TracedPicture",
    "Tracer",
    "Triangles",
    "interior_lights",
    "trace",
]
