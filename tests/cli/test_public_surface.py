"""What ``import sceneweaver`` offers, and that it costs little."""

from __future__ import annotations

import importlib.metadata
import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

import sceneweaver
from sceneweaver.runtime.package import DISTRIBUTION

PUBLIC = [
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
    "ImportedHome",
    "ImportedScene",
    "InputError",
    "LayoutPrior",
    "LearnedWeights",
    "MissingDependencyError",
    "ObjectHandle",
    "ObjectiveTerm",
    "ParetoFront",
    "PlanRepair",
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
    "read_homes",
    "read_scenes",
    "refine",
    "refine_many",
    "repair",
    "repair_many",
    "repair_plan",
    "repair_report",
    "residual_cost",
    "undefine_check",
    "undefine_relation",
    "undefine_term",
]


def test_the_public_names_are_these():
    assert sceneweaver.__all__ == PUBLIC
    assert set(PUBLIC) <= set(dir(sceneweaver))


@pytest.mark.parametrize("name", PUBLIC)
def test_every_public_name_is_there(name):
    value = getattr(sceneweaver, name)
    assert value is getattr(sceneweaver, name)
    if name != "__version__":
        assert value.__name__ == name and value.__doc__


def test_type_checkers_see_the_same_names():
    text = Path(sceneweaver.__file__).read_text()
    block = text.partition("if TYPE_CHECKING:")[2].partition("__all__")[0]
    parts = {"datasets", "problems"}  # modules that are there without an import of their own
    assert sorted({*re.findall(r"import (\w+) as \1", block), "__version__"} - parts) == PUBLIC
    assert sorted({*sceneweaver._HOME, "__version__"} - parts) == PUBLIC


def test_an_unknown_name_is_an_attribute_error():
    with pytest.raises(AttributeError, match="no attribute 'refin'"):
        _ = sceneweaver.refin


def test_the_version_is_that_of_the_distribution():
    assert sceneweaver.__version__ == importlib.metadata.version(DISTRIBUTION)


def test_importing_is_light(tmp_path):
    code = "import json, sys; import sceneweaver; print(json.dumps(sorted({m.partition('.')[0] for m in sys.modules})))"
    ended = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, check=True)
    modules = json.loads(ended.stdout)
    heavy = {"warp", "shapely", "jax", "mujoco", "pxr", "trimesh", "numpy", "pydantic", "PIL", "typer", "rich"}
    assert not heavy & set(modules)
