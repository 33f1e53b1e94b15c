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
from .minimise_steps import MinimiseSteps as MinimiseSteps
from .objective import ObjectiveTerm as ObjectiveTerm
from .objective import terms_from as terms_from
from .objective_values import objective_of as objective_of
from .optimize import VariableSolution as VariableSolution
from .optimize import optimize_variables as optimize_variables
from .parameters import KINDS as PARAMETER_KINDS
from .parameters import Parameters as Parameters
from .pareto import ParetoFront as ParetoFront
from .pareto import hypervolume as hypervolume
from .pareto import pareto_front as pareto_front
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
from .variables import Variable as Variable

__all__ = [
    "PARAMETER_KINDS",
    "BuiltIn",
    "ObjectiveTerm",
    "MinimiseSteps",
    "ParetoFront",
    "Functional",
    "Joint",
    "Parameters",
    "Problem",
    "Progress",
    "QualityTerm",
    "Solution",
    "StepOptimizer",
    "Terms",
    "Variable",
    "VariableSolution",
    "bits_of",
    "compile",
    "difference",
    "find_optimizer",
    "hypervolume",
    "improve",
    "joined",
    "kinds_from",
    "numbered",
    "objective_of",
    "optimize_variables",
    "pareto_front",
    "rate",
    "refine",
    "refine_many",
    "step_optimizer",
    "terms_from",
]
