"""Scenes as padded arrays for models that learn: vocabulary, one batch, and a view of a whole data set."""

from .batch import Limits as Limits
from .batch import Tensors as Tensors
from .batch import collate as collate
from .view import TensorView as TensorView
from .view import tensors as tensors
from .vocabulary import Vocabulary as Vocabulary

__all__ = ["Limits", "TensorView", "Tensors", "Vocabulary", "collate", "tensors"]
