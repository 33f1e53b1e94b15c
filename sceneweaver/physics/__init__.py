"""Scenes as MuJoCo models: does everything stay where it was put?"""

from .batch import Many as Many
from .batch import settle_many as settle_many
from .batch import settle_scenes as settle_scenes
from .batch import stability_many as stability_many
from .model import Model as Model
from .model import build as build
from .settle import Settled as Settled
from .settle import settle as settle
from .settle import stability as stability

__all__ = ["Many", "Model", "Settled", "build", "settle", "settle_many", "settle_scenes", "stability", "stability_many"]
