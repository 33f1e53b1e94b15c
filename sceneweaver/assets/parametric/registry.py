from ..drawing.registry import MAKERS, Maker, draws

__all__ = ["MAKERS", "Maker", "draws"]
