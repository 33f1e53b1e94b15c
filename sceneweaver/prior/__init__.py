"""A learned prior of layouts: poses to start from, drawn by a network that was trained on valid layouts.

The network (`network`) is written once for NumPy, which draws with it, and JAX, which trains it (`training`, extra
``prior``).
"""

from .model import LayoutPrior as LayoutPrior

__all__ = ["LayoutPrior"]
