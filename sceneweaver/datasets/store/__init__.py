"""The files that all scenes of a data set share, by their content."""

from .content import AssetStore

__all__ = ["AssetStore"]
