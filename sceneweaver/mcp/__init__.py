"""A server of the Model Context Protocol: rooms for assistants to design, edit, check and render."""

from .start import build_server as build_server
from .start import serve as serve

__all__ = ["build_server", "serve"]
