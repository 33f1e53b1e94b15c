"""Scenes as MuJoCo models: does everything stay where it was put?"""

from .model import Model as Model
from .model import build as build
from .settle import Settled as Settled
from .settle import settle as settle
from .settle import stability as stability

__all__ = ["Model", "Settled", "build", "settle", "stability"]
