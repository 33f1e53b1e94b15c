"""The command line: ``sceneweaver`` and ``python -m sceneweaver.cli``."""

from .app import main as main

__all__ = ["main"]
