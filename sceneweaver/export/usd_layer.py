"""Writing a USD layer spec by spec: far quicker than through schema classes, and nothing is composed meanwhile."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from types import SimpleNamespace
from typing import Any, Literal

import numpy as np

from sceneweaver.geometry.rotations import wxyz

from .names import Names

Prim = Any
"""A ``pxr.Sdf.PrimSpec``."""

_OPS = ("xformOp:translate", "xformOp:orient", "xformOp:scale")


@cache
def usd() -> Any:
    """The modules of usd-core that are used here; they tell a type checker nothing."""
    from pxr import Gf, Sdf, Tf, Vt

    return SimpleNamespace(Gf=Gf, Sdf=Sdf, Tf=Tf, Vt=Vt)


def prim_names(*taken: str) -> Names:
    """Gives valid USD names from any text, each once."""
    return Names(usd().Tf.MakeValidIdentifier, *taken)


def prim(
    parent: Prim,
    name: str,
    type_name: str = "Xform",
    apis: Iterable[str] = (),
    *,
    abstract: bool = False,
    **fields: Any,
) -> Prim:
    """A new prim below another (or the layer): its type, its applied schemas, and fields such as ``kind``."""
    made = usd().Sdf.PrimSpec(parent, name, usd().Sdf.SpecifierClass if abstract else usd().Sdf.SpecifierDef, type_name)
    for key, value in fields.items():
        made.SetInfo(key, value)
    apply(made, *apis)
    return made


def apply(target: Prim, *apis: str) -> None:
    """Apply schemas to a prim, after those that it has."""
    if not apis:
        return
    had = list(target.GetInfo("apiSchemas").prependedItems) if target.HasInfo("apiSchemas") else []
    items = [*had, *(api for api in apis if api not in had)]
    target.SetInfo("apiSchemas", usd().Sdf.TokenListOp.Create(prependedItems=items))


def attribute(target: Prim, name: str, type_name: str, value: Any, *, uniform: bool = False) -> Any:
    """A new attribute of a prim; ``type_name`` is one of ``Sdf.ValueTypeNames``. Returns its spec."""
    variability = usd().Sdf.VariabilityUniform if uniform else usd().Sdf.VariabilityVarying
    made = usd().Sdf.AttributeSpec(target, name, getattr(usd().Sdf.ValueTypeNames, type_name), variability)
    if value is not None:
        made.default = value
    return made


def attributes(target: Prim, values: Mapping[str, tuple[str, Any]]) -> None:
    """Several attributes: type and value by name."""
    for name, (type_name, value) in values.items():
        attribute(target, name, type_name, value)


def relate(target: Prim, name: str, *paths: Any) -> None:
    """Add targets to a relationship of a prim, which is made when it is not there; a path is kept once."""
    made = target.relationships.get(name)
    if made is None:
        made = usd().Sdf.RelationshipSpec(target, name, False, usd().Sdf.VariabilityUniform)
    had = set(made.targetPathList.explicitItems)
    for path in paths:
        if path not in had:
            had.add(path)
            made.targetPathList.explicitItems.append(path)


def place(
    target: Prim,
    position: Sequence[float] = (0.0, 0.0, 0.0),
    quaternion: Sequence[float] = (0.0, 0.0, 0.0, 1.0),
    scale: Sequence[float] = (1.0, 1.0, 1.0),
) -> None:
    """Translation [m], rotation (x, y, z, w) and scale of a prim, as the three operations that Isaac Sim expects."""
    attribute(target, _OPS[0], "Double3", triple(position))
    attribute(target, _OPS[1], "Quatd", rotation("Quatd", quaternion))
    attribute(target, _OPS[2], "Double3", triple(scale))
    attribute(target, "xformOpOrder", "TokenArray", list(_OPS), uniform=True)


def triple(values: Sequence[float] | np.ndarray) -> tuple[float, float, float]:
    """Three numbers as a vector's value."""
    x, y, z = (float(v) for v in values)
    return x, y, z


def rotation(type_name: Literal["Quatf", "Quatd"], quaternion: Sequence[float]) -> Any:
    """A quaternion (x, y, z, w) as a value of that type; USD has its real part first."""
    return getattr(usd().Gf, type_name)(*map(float, wxyz(quaternion)))


def vectors(values: np.ndarray) -> Any:
    """Rows [N, 3] as an array of vectors of single precision."""
    return usd().Vt.Vec3fArray.FromNumpy(np.ascontiguousarray(values, dtype=np.float32))


def pairs(values: np.ndarray) -> Any:
    """Rows [N, 2] as an array of texture coordinates."""
    return usd().Vt.Vec2fArray.FromNumpy(np.ascontiguousarray(values, dtype=np.float32))


def integers(values: np.ndarray) -> Any:
    """Whole numbers [N]."""
    return usd().Vt.IntArray.FromNumpy(np.ascontiguousarray(values, dtype=np.int32))


def label(target: Prim, category: str, instance: str = "") -> None:
    """Say what a prim and all below it is, and which one, for segmentation.

    ``SemanticsLabelsAPI`` is USD's own schema, which Isaac Sim reads since 5.0; releases before it, and the renderer
    by itself, read the older attributes.
    """
    apply(target, "SemanticsLabelsAPI:class", "SemanticsAPI:Semantics")
    attribute(target, "semantics:labels:class", "TokenArray", [category])
    if instance:
        apply(target, "SemanticsLabelsAPI:instance")
        attribute(target, "semantics:labels:instance", "TokenArray", [instance])
    attribute(target, "semantic:Semantics:params:semanticType", "String", "class")
    attribute(target, "semantic:Semantics:params:semanticData", "String", category)
