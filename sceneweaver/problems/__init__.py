"""A zoo of constrained layout problems: frozen, with witnesses or proofs, for optimisers to be compared on.

Every problem is a scene at a bad start with a layout that is known to be valid, its *witness*, or with a *certificate*
that there is none. Problems have a version and a hash; results on equal hashes are comparable. `generate` makes more.

Examples:
    >>> from sceneweaver import problems
    >>> case = problems.load("packing/n005-t60")
    >>> poses = case.start("random", 8, seed=0)
    >>> case.compile("cpu").energy(poses).shape
    (8,)
"""

from . import layout_bench as layout_bench
from .case import ProblemCase as ProblemCase
from .case import canonical as canonical
from .certificates import prove as prove
from .generator import generate as generate
from .infeasible import generate_infeasible as generate_infeasible
from .recipes import families as families
from .store import load as load
from .store import names as names
from .store import verify as verify

__all__ = [
    "ProblemCase",
    "canonical",
    "families",
    "generate",
    "generate_infeasible",
    "layout_bench",
    "load",
    "names",
    "prove",
    "verify",
]
