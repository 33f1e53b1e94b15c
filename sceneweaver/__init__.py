"""Batched, differentiable layout optimiser for indoor scenes, compiled to NVIDIA Warp kernels.

Names are imported when they are first used, so that ``import sceneweaver`` itself is quick.
"""

from importlib import import_module as _import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sceneweaver import datasets as datasets
    from sceneweaver import problems as problems
    from sceneweaver.agent import Result as Result
    from sceneweaver.agent import design as design
    from sceneweaver.building import ObjectHandle as ObjectHandle
    from sceneweaver.building import SceneBuilder as SceneBuilder
    from sceneweaver.building import build as build
    from sceneweaver.critic import Fault as Fault
    from sceneweaver.critic import define_check as define_check
    from sceneweaver.critic import undefine_check as undefine_check
    from sceneweaver.editing import EditResult as EditResult
    from sceneweaver.editing import EditSession as EditSession
    from sceneweaver.evaluation import Comparison as Comparison
    from sceneweaver.evaluation import Evaluation as Evaluation
    from sceneweaver.evaluation import compare as compare
    from sceneweaver.evaluation import evaluate as evaluate
    from sceneweaver.explain import refine as refine
    from sceneweaver.explain import refine_many as refine_many
    from sceneweaver.export import export_home as export_home
    from sceneweaver.extend import check_gradient as check_gradient
    from sceneweaver.extend import define_relation as define_relation
    from sceneweaver.extend import define_term as define_term
    from sceneweaver.extend import residual_cost as residual_cost
    from sceneweaver.extend import undefine_relation as undefine_relation
    from sceneweaver.extend import undefine_term as undefine_term
    from sceneweaver.furnish import FurnishedHome as FurnishedHome
    from sceneweaver.furnish import HomeResult as HomeResult
    from sceneweaver.furnish import design_home as design_home
    from sceneweaver.furnish import furnish_home as furnish_home
    from sceneweaver.home import Home as Home
    from sceneweaver.importers import ImportedScene as ImportedScene
    from sceneweaver.importers import read_scenes as read_scenes
    from sceneweaver.layout import ObjectiveTerm as ObjectiveTerm
    from sceneweaver.layout import ParetoFront as ParetoFront
    from sceneweaver.layout import Problem as Problem
    from sceneweaver.layout import QualityTerm as QualityTerm
    from sceneweaver.layout import Solution as Solution
    from sceneweaver.layout import Variable as Variable
    from sceneweaver.layout import VariableSolution as VariableSolution
    from sceneweaver.layout import compile as compile
    from sceneweaver.layout import hypervolume as hypervolume
    from sceneweaver.layout import improve as improve
    from sceneweaver.layout import objective_of as objective_of
    from sceneweaver.layout import optimize_variables as optimize_variables
    from sceneweaver.layout import pareto_front as pareto_front
    from sceneweaver.learning import LearnedWeights as LearnedWeights
    from sceneweaver.learning import learn_weights as learn_weights
    from sceneweaver.prior import LayoutPrior as LayoutPrior
    from sceneweaver.render import draw_top as draw_top
    from sceneweaver.repairs import Repair as Repair
    from sceneweaver.repairs import repair as repair
    from sceneweaver.repairs import repair_many as repair_many
    from sceneweaver.repairs import repair_report as repair_report
    from sceneweaver.scene import Dropped as Dropped
    from sceneweaver.scene import InputError as InputError
    from sceneweaver.scene import MissingDependencyError as MissingDependencyError
    from sceneweaver.scene import Pose as Pose
    from sceneweaver.scene import Relation as Relation
    from sceneweaver.scene import Room as Room
    from sceneweaver.scene import Scene as Scene
    from sceneweaver.scene import SceneObject as SceneObject
    from sceneweaver.scene import SceneWeaverError as SceneWeaverError
    from sceneweaver.tools.scene_model import SceneModel as SceneModel
    from sceneweaver.tools.scene_model import SceneRequest as SceneRequest
    from sceneweaver.verify import Report as Report
    from sceneweaver.verify import Violation as Violation
    from sceneweaver.verify import check as check
    from sceneweaver.verify.home import HomeReport as HomeReport
    from sceneweaver.verify.home import check_home as check_home

    __version__: str

__all__ = [
    "Comparison",
    "Dropped",
    "EditResult",
    "EditSession",
    "Evaluation",
    "Fault",
    "FurnishedHome",
    "Home",
    "HomeReport",
    "HomeResult",
    "ImportedScene",
    "InputError",
    "LayoutPrior",
    "LearnedWeights",
    "MissingDependencyError",
    "ObjectHandle",
    "ObjectiveTerm",
    "ParetoFront",
    "Pose",
    "Problem",
    "QualityTerm",
    "Relation",
    "Repair",
    "Report",
    "Result",
    "Room",
    "Scene",
    "SceneBuilder",
    "SceneModel",
    "SceneObject",
    "SceneRequest",
    "SceneWeaverError",
    "Solution",
    "Variable",
    "VariableSolution",
    "Violation",
    "__version__",
    "build",
    "check",
    "check_gradient",
    "check_home",
    "compare",
    "compile",
    "define_check",
    "define_relation",
    "define_term",
    "design",
    "design_home",
    "draw_top",
    "evaluate",
    "export_home",
    "furnish_home",
    "hypervolume",
    "improve",
    "learn_weights",
    "objective_of",
    "optimize_variables",
    "pareto_front",
    "read_scenes",
    "refine",
    "refine_many",
    "repair",
    "repair_many",
    "repair_report",
    "residual_cost",
    "undefine_check",
    "undefine_relation",
    "undefine_term",
]

_HOME = {
    "Comparison": "evaluation",
    "Dropped": "scene",
    "EditResult": "editing",
    "EditSession": "editing",
    "Evaluation": "evaluation",
    "Fault": "critic",
    "FurnishedHome": "furnish",
    "Home": "home",
    "HomeReport": "verify.home",
    "HomeResult": "furnish",
    "ImportedScene": "importers",
    "InputError": "scene",
    "LayoutPrior": "prior",
    "LearnedWeights": "learning",
    "MissingDependencyError": "scene",
    "ObjectHandle": "building",
    "ObjectiveTerm": "layout",
    "ParetoFront": "layout",
    "Pose": "scene",
    "Problem": "layout",
    "QualityTerm": "layout",
    "Relation": "scene",
    "Repair": "repairs",
    "Report": "verify",
    "Result": "agent",
    "Room": "scene",
    "Scene": "scene",
    "SceneBuilder": "building",
    "SceneModel": "tools.scene_model",
    "SceneObject": "scene",
    "SceneRequest": "tools.scene_model",
    "SceneWeaverError": "scene",
    "Solution": "layout",
    "Variable": "layout",
    "VariableSolution": "layout",
    "Violation": "verify",
    "build": "building",
    "check": "verify",
    "check_gradient": "extend",
    "check_home": "verify.home",
    "compare": "evaluation",
    "compile": "layout",
    "define_check": "critic",
    "define_relation": "extend",
    "define_term": "extend",
    "design": "agent",
    "design_home": "furnish",
    "furnish_home": "furnish",
    "draw_top": "render",
    "evaluate": "evaluation",
    "export_home": "export",
    "hypervolume": "layout",
    "improve": "layout",
    "learn_weights": "learning",
    "objective_of": "layout",
    "optimize_variables": "layout",
    "pareto_front": "layout",
    "read_scenes": "importers",
    "refine": "explain",
    "refine_many": "explain",
    "repair": "repairs",
    "repair_many": "repairs",
    "repair_report": "repairs",
    "residual_cost": "extend",
    "undefine_check": "critic",
    "undefine_relation": "extend",
    "undefine_term": "extend",
}


def __getattr__(name: str) -> object:
    if name == "__version__":
        value: object = _import_module(f"{__name__}.runtime.package").package_version()
    elif name in ("datasets", "problems"):  # modules of their own, as `sceneweaver.jax` is
        value = _import_module(f"{__name__}.{name}")
    elif name in _HOME:
        value = getattr(_import_module(f"{__name__}.{_HOME[name]}"), name)
    else:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
