"""The files that all scenes of a data set share, by their content, and the drawings that they choose from."""

from .content import AssetStore

__all__ = ["AssetStore"]
