"""The files that all scenes of a data set share, by their content, and the drawings that they choose from."""

from .content import AssetStore
from .pool import dataset_library

__all__ = ["AssetStore", "dataset_library"]
