"""Pictures of interiors with the light of the real world."""

from .lights import Lights as Lights
from .lights import Portal as Portal
from .lights import interior_lights as interior_lights
from .tracer import TracedPicture as TracedPicture
from .tracer import TraceQuality as TraceQuality
from .tracer import Tracer as Tracer
from .tracer import trace as trace

__all__ = ["Lights", "Portal", "TraceQuality", "TracedPicture", "Tracer", "interior_lights", "trace"]
