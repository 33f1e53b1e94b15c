"""USD stages: our own export, and any other whose prims show things."""

# pxr has no stubs:
# pyright: reportAttributeAccessIssue=false

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.io import InputError, open_stage
from sceneweaver.io.messages import clean, path_name

from ..frames import Y_UP
from ..model import Mount, ReadOptions, SourceFormat, SourceObject, SourceOpening, SourceRoom
from ..shells import (
    Part,
    Shell,
    box_along,
    inner_rectangle,
    opening_of,
    rectangle_around,
    shell_of,
    shell_of_walls,
    upright,
)

SUFFIXES = (".usd", ".usda", ".usdc", ".usdz")

MAX_PRIMS = 2_000_000
"""Prims of a stage, those of instances included."""

_OWN = "sceneweaver"
_MOUNTS: dict[str, Mount] = {"floor": "floor", "wall": "wall", "ceiling": "ceiling", "surface": "surface"}
_CUBE = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], dtype=float)


@dataclass
class _Stage:
    """A stage with what is needed to place its points in our frame."""

    stage: Any
    path: Path
    cache: Any
    frame: np.ndarray
    metres: float
    seen: int = 0
    notes: list[str] = field(default_factory=list)

    def matrix(self, prim: Any) -> np.ndarray:
        """The matrix [4, 4] that puts points of a prim's frame into the room [m], for column vectors."""
        to_world = np.array(self.cache.GetLocalToWorldTransform(prim), dtype=float).T
        matrix = np.eye(4)
        matrix[:3, :3] = self.frame * self.metres
        matrix = matrix @ to_world
        if not np.isfinite(matrix).all():
            raise InputError(
                f"{path_name(self.path)}: {prim.GetPath()}: its transform is not finite; mend its xformOps"
            )
        return matrix

    def points(self, prim: Any) -> np.ndarray | None:
        """Points [n, 3] in the room [m] that span all that a prim and those below it show."""
        from pxr import Usd, UsdGeom

        found: list[np.ndarray] = []
        for one in Usd.PrimRange(prim, Usd.TraverseInstanceProxies(Usd.PrimDefaultPredicate)):
            self.seen += 1
            if self.seen > MAX_PRIMS:
                raise InputError(f"{path_name(self.path)}: more than {MAX_PRIMS} prims; split the stage")
            if one.IsA(UsdGeom.PointInstancer):
                self.notes.append(f"{one.GetPath()}: point instancers are left out")
            if not one.IsA(UsdGeom.Boundable) or one.IsA(UsdGeom.PointInstancer):
                continue
            shown = UsdGeom.Imageable(one)
            if shown.ComputePurpose() == "guide" or shown.ComputeVisibility() == "invisible":
                continue
            local = _local(one)
            if local is not None and len(local):
                matrix = self.matrix(one)
                found.append(local @ matrix[:3, :3].T + matrix[:3, 3])
                if not np.isfinite(found[-1]).all():
                    raise InputError(f"{path_name(self.path)}: {one.GetPath()}: a point is not finite; mend the mesh")
        return np.concatenate(found) if found else None


def _local(prim: Any) -> np.ndarray | None:
    """Points [n, 3] of a boundable prim in its own frame: those of a mesh, else the corners of its extent."""
    from pxr import Usd, UsdGeom

    if prim.IsA(UsdGeom.Mesh):
        values = UsdGeom.Mesh(prim).GetPointsAttr().Get()
        return None if values is None else np.asarray(values, dtype=float).reshape(-1, 3)
    if not prim.IsA(UsdGeom.Gprim):
        return None
    extent = UsdGeom.Boundable.ComputeExtentFromPlugins(UsdGeom.Boundable(prim), Usd.TimeCode.Default())
    if not extent:
        return None
    low, high = np.asarray(extent, dtype=float)
    return (low + high) / 2 + _CUBE * (high - low) / 2


def _matches(path: Path, head: bytes) -> bool:
    return path.suffix.lower() in SUFFIXES


def _read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    from pxr import UsdGeom

    opened = open_stage(path)
    up = str(UsdGeom.GetStageUpAxis(opened))
    frame = Y_UP if up == "Y" else np.eye(3)
    stage = _Stage(opened, path, UsdGeom.XformCache(), frame, float(UsdGeom.GetStageMetersPerUnit(opened)))
    layer = opened.GetRootLayer().customLayerData or {}
    own = layer.get(_OWN) if isinstance(layer.get(_OWN), dict) else None
    objects: list[SourceObject] = []
    shell: dict[Shell, list[tuple[str, np.ndarray]]] = {}
    walls: list[Any] = []
    front = np.array((1.0, 0.0, 0.0)) if own is not None or up == "Z" else np.array((0.0, 0.0, 1.0))
    for prim in _units(stage):
        name, part = _name(prim), _part(prim)
        if part == "wall" and own is not None:
            walls.append(prim)
        points = _pane(stage, prim) if part == "window" and own is not None else stage.points(prim)
        if points is None:
            continue
        if part is not None:
            shell.setdefault(part, []).append((name, points))
        else:
            objects.append(_object(stage, prim, name, points, front))
    notes = stage.notes
    for error in opened.GetCompositionErrors()[:5] if hasattr(opened, "GetCompositionErrors") else ():
        notes.append(f"USD: {clean(str(error).strip())[:160]}")
    if own is None:
        notes.append(f"things are taken to face {'+x' if up == 'Z' else '+z'} of their own frames: USD says no front")
    outline, height, openings = _room(stage, walls, shell, notes)
    facts = own or {}
    yield SourceRoom(
        "",
        str(facts.get("room", "")),
        outline,
        height,
        openings,
        tuple(objects),
        str(facts.get("prompt", "")),
        tuple(dict.fromkeys(notes)),
    )


def _units(stage: _Stage) -> list[Any]:
    """The prims that are one thing each: of kind component or subcomponent's parent, else as the stage nests them."""
    from pxr import Kind, Usd

    root = stage.stage.GetDefaultPrim() or stage.stage.GetPseudoRoot()
    named: list[Any] = []
    walk = iter(Usd.PrimRange(root, Usd.TraverseInstanceProxies(Usd.PrimDefaultPredicate)))
    for prim in walk:
        if Kind.Registry.IsA(Usd.ModelAPI(prim).GetKind(), Kind.Tokens.component) and prim != root:
            named.append(prim)
            walk.PruneChildren()
    if len(named) > 1:
        return named
    return _nested(stage, root)


def _nested(stage: _Stage, root: Any) -> list[Any]:
    """Without kinds: the children of the first prim with several that show something; scopes and groups are opened."""
    from pxr import Usd, UsdGeom

    level = [p for p in root.GetFilteredChildren(Usd.TraverseInstanceProxies(Usd.PrimDefaultPredicate))]
    shown = [p for p in level if stage.points(p) is not None]
    if len(shown) == 1 and not shown[0].IsA(UsdGeom.Gprim):
        inner = _nested(stage, shown[0])
        return inner if len(inner) > 1 else shown
    found: list[Any] = []
    for prim in shown:
        if _is_group(prim):
            found += _nested(stage, prim)
        else:
            found.append(prim)
    return found


def _is_group(prim: Any) -> bool:
    """Whether a prim only holds things: a scope, of kind group, or named as a list of them."""
    from pxr import Kind, Usd, UsdGeom

    if prim.IsA(UsdGeom.Scope):
        return True
    if Kind.Registry.IsA(Usd.ModelAPI(prim).GetKind(), Kind.Tokens.group):
        return True
    words = ("objects", "furniture", "props", "assets", "room", "rooms", "walls", "windows", "doors", "structure")
    return not prim.IsA(UsdGeom.Gprim) and prim.GetName().lower() in words and bool(prim.GetChildren())


def _facts(prim: Any) -> dict[str, Any]:
    facts = prim.GetCustomDataByKey(_OWN)
    return facts if isinstance(facts, dict) else {}


def _name(prim: Any) -> str:
    facts = _facts(prim)
    return str(facts.get("id") or prim.GetDisplayName() or prim.GetName())


def _label(prim: Any) -> str:
    """What a prim is: of our facts, of its semantic labels, else its name."""
    facts = _facts(prim)
    if facts.get("category"):
        return str(facts["category"])
    for attribute in prim.GetAttributes():
        name = attribute.GetName()
        if name == "semantics:labels:class" or name.endswith(":params:semanticData"):
            value = attribute.Get()
            if isinstance(value, str) and value:
                return value
            if value is not None and not isinstance(value, str) and len(value):
                return str(value[0])
    return str(prim.GetName())


def _part(prim: Any) -> Shell | None:
    """Which part of the room a prim is: by its label, or by its name."""
    if _facts(prim).get("category"):
        return None
    label = _label(prim)
    return shell_of(label) or (shell_of(prim.GetName()) if label == prim.GetName() else None)


def _object(stage: _Stage, prim: Any, name: str, points: np.ndarray, front: np.ndarray) -> SourceObject:
    facts = _facts(prim)
    matrix = stage.matrix(prim)[:3, :3]
    lengths = np.linalg.norm(matrix, axis=0)
    turn = matrix / np.where(lengths > 0, lengths, 1.0)
    skew = np.abs(turn.T @ turn - np.eye(3)).max()
    if lengths.min() < 1e-12 or skew > 0.01:
        stage.notes.append(f"{name}: its matrix shears or flattens; its box is along the axes of the room")
        turn = np.eye(3)
    elif np.linalg.det(turn) < 0:
        stage.notes.append(f"{name}: it is mirrored; its box is that of the mirrored shape")
        turn = turn * np.where(np.abs(front) > 0.5, 1.0, np.where(np.roll(np.abs(front), 1) > 0.5, -1.0, 1.0))
    else:
        u, _, vt = np.linalg.svd(turn)
        turn = u @ vt
    turn = upright(turn, front)
    centre, size = box_along(points, turn)
    support = facts.get("support")
    return SourceObject(
        name,
        _label(prim),
        (float(centre[0]), float(centre[1]), float(centre[2])),
        turn,
        size,
        asset=str(facts["asset"]) if facts.get("asset") else None,
        support=str(support["object"]) if isinstance(support, dict) and support.get("object") else None,
        mount=_MOUNTS.get(str(facts.get("mount", ""))),
        keep={"prim": str(prim.GetPath())},
    )


def _room(
    stage: _Stage, own: list[Any], shell: dict[Shell, list[tuple[str, np.ndarray]]], notes: list[str]
) -> tuple[tuple[tuple[float, float], ...] | None, float | None, tuple[SourceOpening, ...]]:
    made = shell_of_walls([(stage.matrix(prim), _boxes(stage, prim)) for prim in own]) if own else None
    if made is not None:
        panes = [opening_of(name, "window", points) for name, points in shell.get("window", [])]
        notes.append("doors are read from the walls: which way they open is lost")
        return made.outline, made.height, (*made.openings, *panes)
    walls, floors = [p for _, p in shell.get("wall", [])], [p for _, p in shell.get("floor", [])]
    outline = inner_rectangle(walls) if walls else None
    if outline is None and floors:
        outline = rectangle_around(np.concatenate(floors))
    if outline is not None:
        notes.append(f"the room is the rectangle of its {'walls' if walls else 'floor'}")
    kinds: tuple[Shell, ...] = ("door", "window")
    openings = tuple(opening_of(name, kind, points) for kind in kinds for name, points in shell.get(kind, []))
    height = float(max(p[:, 2].max() for p in walls)) if walls else None
    return outline, height, openings if outline is not None else ()


def _pane(stage: _Stage, window: Any) -> np.ndarray | None:
    """The corners [8, 3] of what fills a window of our own: its collider, without frame and sill."""
    matrix = stage.matrix(window)
    corners = [c + _CUBE * half for c, half in _boxes(stage, window)]
    return np.concatenate(corners) @ matrix[:3, :3].T + matrix[:3, 3] if corners else stage.points(window)


def _boxes(stage: _Stage, wall: Any) -> list[Part]:
    """The colliders of a wall of our own, in its frame."""
    from pxr import Usd, UsdGeom

    inverse = np.linalg.inv(stage.matrix(wall))
    found: list[Part] = []
    for prim in Usd.PrimRange(wall):
        if prim.IsA(UsdGeom.Cube):
            matrix = inverse @ stage.matrix(prim)
            half = np.abs(matrix[:3, :3]).sum(axis=1) * float(UsdGeom.Cube(prim).GetSizeAttr().Get()) / 2
            found.append((matrix[:3, 3], half))
    return found


FORMAT = SourceFormat(
    "usd",
    "USD stages (ours, Isaac Sim's, any)",
    _matches,
    _read,
    notes=(
        "Read: prims of kind component, each as one thing; without kinds the stage's own nesting (children of the "
        "first prim with several that show something; scopes and groups are opened). Boxes are of all visible points "
        "along the prim's own axes, instances and references within the folder included; upAxis and metersPerUnit.",
        "Categories come from our facts, from semantic labels, else from the prim's name. Walls, floors, ceilings, "
        "doors and windows are told by label or name; the room is the rectangle between the walls, exact where the "
        "stage is our own export.",
        "Assumed: things face +x of their frame in stages that are z up, +z in those that are y up; what of their axes "
        "points up is up.",
        "Lost: point instancers, animation (the default time is read), physics, materials.",
    ),
    written=True,
)
