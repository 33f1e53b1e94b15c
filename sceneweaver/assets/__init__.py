"""Furniture with bodies: meshes, collision parts, support surfaces and the libraries that they come from."""

from .asset import Asset as Asset
from .asset import Origin as Origin
from .body import Grasp as Grasp
from .body import Hull as Hull
from .body import Interior as Interior
from .body import Link as Link
from .body import Material as Material
from .body import Mesh as Mesh
from .category import Category as Category
from .category import categories as categories
from .drawable import Look as Look
from .drawable import drawable as drawable
from .parametric import Request as Request
from .parametric import draws as draws
from .parametric import make as make
from .sources import Card as Card
from .sources import Library as Library
from .sources import Source as Source
from .sources.base import Wish as Wish
from .store import Store as Store
from .taxonomy import Match as Match
from .taxonomy import resolve as resolve

__all__ = [
    "Asset",
    "Card",
    "Category",
    "Grasp",
    "Hull",
    "Interior",
    "Library",
    "Link",
    "Look",
    "Match",
    "Material",
    "Mesh",
    "Origin",
    "Request",
    "Source",
    "Store",
    "Wish",
    "categories",
    "drawable",
    "draws",
    "make",
    "resolve",
]
