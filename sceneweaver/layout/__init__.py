"""Compile a scene to a layout problem, refine many candidates of it, select."""

from sceneweaver.optimizers.batch import Progress as Progress

from .differences import difference as difference
from .engine import refine as refine
from .engine import refine_many as refine_many
from .functional import Functional as Functional
from .functional import Joint as Joint
from .functional import bits_of as bits_of
from .functional import kinds_from as kinds_from
from .improve import improve as improve
from .parameters import KINDS as PARAMETER_KINDS
from .parameters import Parameters as Parameters
from .problem import Problem as Problem
from .problem import Terms as Terms
from .problem import compile as compile
from .problem import numbered as numbered
from .quality import QualityTerm as QualityTerm
from .rate import rate as rate
from .solution import Solution as Solution
from .solution import joined as joined
from .stepwise import BuiltIn as BuiltIn
from .stepwise import StepOptimizer as StepOptimizer
from .stepwise import find_optimizer as find_optimizer
from .stepwise import step_optimizer as step_optimizer

__all__ = [
    "PARAMETER_KINDS",
    "BuiltIn",
    "Functional",
    "Joint",
    "Parameters",
    "Problem",
    "Progress",
    "QualityTerm",
    "Solution",
    "StepOptimizer",
    "Terms",
    "bits_of",
    "compile",
    "difference",
    "find_optimizer",
    "improve",
    "joined",
    "kinds_from",
    "numbered",
    "rate",
    "refine",
    "refine_many",
    "step_optimizer",
]
