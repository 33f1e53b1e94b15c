"""MJCF of MuJoCo: our own export, RoboCasa's and robosuite's compiled scenes, any model of bodies with geoms."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.io import InputError, read_spec, reason
from sceneweaver.io.messages import path_name
from sceneweaver.runtime.mujoco_module import load_mujoco

from ..model import ReadOptions, SourceFormat, SourceObject, SourceOpening, SourceRoom
from ..shells import (
    Shell,
    box_along,
    inner_rectangle,
    opening_of,
    rectangle_around,
    shell_of,
    shell_of_walls,
    upright,
)

_ROBOTS = (
    "robot",
    "gripper",
    "panda",
    "mobilebase",
    "fixed_base",
    "eef",
    "franka",
    "ur5",
    "jaco",
    "sawyer",
    "humanoid",
)
_ACTUATED = 3
"""Driven joints of a body and what hangs on it from which on it is a robot."""

_OWN = "room:"
"""What the names of our own walls and doors begin with."""

_SEEN = 2
"""Group of the geoms of our own export that are seen."""


def _matches(path: Path, head: bytes) -> bool:
    twin = path.name.lower().endswith("-sleep.xml")  # of our own export: the same room again
    return path.suffix.lower() in (".xml", ".mjcf") and b"<mujoco" in head and not twin


class _Model:
    """A compiled model at its initial pose, as arrays and by names."""

    def __init__(self, path: Path):
        self.mujoco: Any = load_mujoco()
        try:
            self.model: Any = read_spec(path).compile()
            self.data: Any = self.mujoco.MjData(self.model)
            self.mujoco.mj_kinematics(self.model, self.data)
        except (ValueError, TypeError, RuntimeError) as error:
            if isinstance(error, InputError):
                raise
            raise InputError(f"{path_name(path)}: MuJoCo refuses it ({reason(error)})") from None
        self.parents = np.asarray(self.model.body_parentid)
        self.children: dict[int, list[int]] = {}
        for body in range(1, self.model.nbody):
            self.children.setdefault(int(self.parents[body]), []).append(body)
        self.own = any(self.model.body(k).name.startswith(f"{_OWN}wall:") for k in range(self.model.nbody))
        self.geoms: dict[int, list[int]] = {}
        for geom, body in enumerate(self.model.geom_bodyid):
            self.geoms.setdefault(int(body), []).append(geom)

    def name(self, body: int) -> str:
        return self.model.body(body).name or f"body_{body}"

    def below(self, body: int) -> Iterator[int]:
        """A body and all that hang on it."""
        todo = [body]
        while todo:
            one = todo.pop()
            yield one
            todo += self.children.get(one, [])

    def joints(self, body: int) -> list[int]:
        """The joints of a body itself."""
        first, count = int(self.model.body_jntadr[body]), int(self.model.body_jntnum[body])
        return list(range(first, first + count))

    def points(self, geom: int) -> np.ndarray | None:
        """Points [n, 3] in the world that span a geom; None for planes, height fields and what has no extent."""
        kind, types = int(self.model.geom_type[geom]), self.mujoco.mjtGeom
        if kind in (int(types.mjGEOM_PLANE), int(types.mjGEOM_HFIELD)):
            return None
        turn, at = self.data.geom_xmat[geom].reshape(3, 3), self.data.geom_xpos[geom]
        mesh = int(self.model.geom_dataid[geom])
        if kind == int(types.mjGEOM_MESH) and mesh >= 0:
            first, count = int(self.model.mesh_vertadr[mesh]), int(self.model.mesh_vertnum[mesh])
            local = np.asarray(self.model.mesh_vert[first : first + count], dtype=float)
        else:
            middle, half = self.model.geom_aabb[geom][:3], self.model.geom_aabb[geom][3:]
            local = middle + half * np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
        return local @ turn.T + at

    def span(self, bodies: Iterator[int] | list[int]) -> np.ndarray | None:
        """Points [n, 3] in the world that span bodies; of our own export what is seen of them, where that is there."""
        geoms = [geom for body in bodies for geom in self.geoms.get(body, [])]
        if self.own:
            geoms = [geom for geom in geoms if int(self.model.geom_group[geom]) == _SEEN] or geoms
        found = [p for geom in geoms if (p := self.points(geom)) is not None]
        return np.concatenate(found) if found else None


def _read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    model = _Model(path)
    notes: list[str] = []
    objects: list[SourceObject] = []
    shell: dict[Shell, list[tuple[str, np.ndarray]]] = {}
    robots: list[str] = []
    own: list[int] = []
    front = _front(model, notes)
    units = _units(model)
    loose = _loose(model, units)
    for body in units:
        name = model.name(body)
        if name.startswith(f"{_OWN}wall:"):
            own.append(body)
            continue
        if model.own and name.partition(".")[0] in loose and "." in name:
            continue
        points = model.span([b for one in (body, *loose.get(name, [])) for b in model.below(one)])
        if points is None:
            continue
        part = shell_of(name)
        if _is_robot(model, body):
            robots.append(name)
        elif part is not None:
            shell.setdefault(part, []).append((name, points))
        else:
            objects.append(_object(model, body, name, points, front))
    _world(model, shell, objects)
    if robots:
        notes.append(f"robots are left out: {', '.join(robots[:10])}")
    outline, height, openings = _room(model, own, shell, notes)
    yield SourceRoom(
        path.stem if path.stem != "scene" else "", "", outline, height, openings, tuple(objects), "", tuple(notes)
    )


def _units(model: _Model) -> list[int]:
    """The bodies that are one thing each: those of the world, or what a body groups that is nothing itself."""
    found: list[int] = []
    todo = list(reversed(model.children.get(0, [])))
    while todo:
        body = todo.pop()
        children = model.children.get(body, [])
        solid = [c for c in children if model.span(list(model.below(c))) is not None]
        free = int(model.mujoco.mjtJoint.mjJNT_FREE)
        loose = all(int(model.model.jnt_type[j]) == free for c in children for j in model.joints(c))
        if not model.geoms.get(body) and not model.joints(body) and len(solid) > 1 and loose:
            todo += reversed(children)
        else:
            found.append(body)
    return found


def _loose(model: _Model, units: list[int]) -> dict[str, list[int]]:
    """In our own export, what can be taken off each thing: bodies named after it with a dot, as books of a stack."""
    names = {model.name(body) for body in units}
    found: dict[str, list[int]] = {}
    for body in units if model.own else ():
        whole, _, part = model.name(body).partition(".")
        if part and whole in names:
            found.setdefault(whole, []).append(body)
    return found


def _is_robot(model: _Model, body: int) -> bool:
    words = model.name(body).lower()
    if any(words.startswith(word) for word in _ROBOTS):
        return True
    joints = {j for one in model.below(body) for j in model.joints(one)}
    kind = int(model.mujoco.mjtTrn.mjTRN_JOINT)
    driven = {
        int(model.model.actuator_trnid[a][0])
        for a in range(model.model.nu)
        if int(model.model.actuator_trntype[a]) == kind
    }
    return len(joints & driven) >= _ACTUATED


def _front(model: _Model, notes: list[str]) -> np.ndarray:
    """The axis along which bodies face: +x, or -y in RoboCasa's models, which mark their boxes by sites."""
    names = [model.model.site(k).name for k in range(model.model.nsite)]
    if any(name.endswith("ext_p0") for name in names):
        notes.append("RoboCasa's fixtures face -y of their bodies")
        return np.array((0.0, -1.0, 0.0))
    return np.array((1.0, 0.0, 0.0))


def _object(model: _Model, body: int, name: str, points: np.ndarray, front: np.ndarray) -> SourceObject:
    turn = upright(model.data.xmat[body].reshape(3, 3), front)
    centre, size = box_along(points, turn)
    moves = bool(model.joints(body))
    return SourceObject(
        name,
        name,
        (float(centre[0]), float(centre[1]), float(centre[2])),
        turn,
        size,
        keep={"free": moves, "joints": sum(len(model.joints(b)) for b in model.below(body)) - len(model.joints(body))},
    )


def _world(model: _Model, shell: dict[Shell, list[tuple[str, np.ndarray]]], objects: list[SourceObject]) -> None:
    """The geoms of the world itself: parts of the room by name or shape, else things that stand still."""
    for geom in model.geoms.get(0, []):
        name, points = model.model.geom(geom).name or f"geom_{geom}", model.points(geom)
        if points is None:
            continue
        part = shell_of(name) or _by_shape(points)
        if part is not None:
            shell.setdefault(part, []).append((name, points))
            continue
        centre, size = box_along(points, turn := upright(model.data.geom_xmat[geom].reshape(3, 3), np.eye(3)[0]))
        place = (float(centre[0]), float(centre[1]), float(centre[2]))
        objects.append(SourceObject(name, name, place, turn, size, fixed=True))


def _by_shape(points: np.ndarray) -> Shell | None:
    """A slab below everything is a floor, a high thin one a wall: geoms of the world have no names often."""
    x, y, z = np.ptp(points, axis=0)
    if z < 0.3 and min(x, y) > 1.5 and points[:, 2].max() < 0.05:
        return "floor"
    return "wall" if z > 1.8 and min(x, y) < 0.35 and max(x, y) > 0.5 else None


def _room(
    model: _Model, own: list[int], shell: dict[Shell, list[tuple[str, np.ndarray]]], notes: list[str]
) -> tuple[tuple[tuple[float, float], ...] | None, float | None, tuple[SourceOpening, ...]]:
    if own:
        walls = []
        for body in sorted(own, key=lambda b: int(model.name(b).rpartition(":")[2] or 0)):
            matrix = np.eye(4)
            matrix[:3, :3], matrix[:3, 3] = model.data.xmat[body].reshape(3, 3), model.data.xpos[body]
            parts = [(model.model.geom_pos[g], model.model.geom_size[g]) for g in model.geoms.get(body, [])]
            walls.append((matrix, parts))
        made = shell_of_walls(walls)
        if made is not None:
            notes.append("doors are read from the walls: which way they open is lost")
            return made
    walls, floors = [p for _, p in shell.get("wall", [])], [p for _, p in shell.get("floor", [])]
    outline = inner_rectangle(walls) if walls else None
    if outline is None and floors:
        outline = rectangle_around(np.concatenate(floors))
    if outline is not None:
        notes.append(f"the room is the rectangle of its {'walls' if walls else 'floor'}")
    height = float(max(p[:, 2].max() for p in walls)) if walls else None
    kinds: tuple[Shell, ...] = ("door", "window")
    openings = tuple(opening_of(name, kind, points) for kind in kinds for name, points in shell.get(kind, []))
    return outline, height, openings if outline is not None else ()


FORMAT = SourceFormat(
    "mjcf",
    "MJCF of MuJoCo (ours, RoboCasa, robosuite, any)",
    _matches,
    _read,
    notes=(
        "Read: each body of the world, with all that hangs on it, as one thing in its initial pose; a body without "
        "geoms and joints that only holds others is a group. Boxes are of all geoms along the body's axes.",
        "Walls, floors, ceilings, doors and windows are told by their names (every word of it), geoms of the world "
        "also by shape; the room is the rectangle between the walls, exact where the model is our own export.",
        "Assumed: a body faces its +x (RoboCasa's, told by their sites, -y); what of its axes points up is up.",
        "Lost: robots (three driven joints, or by name), which are named; joints, masses, materials, planes, height "
        "fields. Categories are guessed from the names of bodies.",
    ),
    written=True,
)
