"""One room as arrays that fit into slots: boxes that stand still, links on a hinge or a slide, free bodies.

A batch steps worlds with different rooms as one MuJoCo model, so that a room has to become numbers. All is made of
boxes (`sceneweaver.physics.boxes`). What is heavy or has doors and drawers stands still, as in most simulators for
robots that manipulate; what is light is a free body. Rugs and mats touch nothing and are left out.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from typing import Any
from xml.etree import ElementTree as Xml

import numpy as np

from sceneweaver.assets.placed import Load
from sceneweaver.envs.predicates import product
from sceneweaver.geometry.rotations import matrix, xyzw
from sceneweaver.io import parse_xml
from sceneweaver.physics.batch import model_of
from sceneweaver.physics.boxes import boxed
from sceneweaver.physics.model import COVERING
from sceneweaver.runtime.mujoco_module import load_mujoco
from sceneweaver.scene import Scene

ANCHORED = 15.0
"""Mass [kg] from which a body stands still in a batch."""

HINGE, SLIDE, FREE = 3, 2, 0
"""Kinds of joints, numbered as MuJoCo does."""

MOST_PARTS = 8
"""Boxes of a body that moves, at most; what has more has some of them joined."""


@dataclass(frozen=True)
class Boxes:
    """K boxes.

    Attributes:
        owner: [K] the object that they belong to, by its number in the scene; -1: the room.
        pos, quat: [K, 3] [m] and [K, 4] (w, x, y, z) in the frame of the body; of what stands still: of the owner.
        size: [K, 3] half extents [m].
        friction: [K, 3] as MuJoCo has it.
    """

    owner: np.ndarray
    pos: np.ndarray
    quat: np.ndarray
    size: np.ndarray
    friction: np.ndarray

    def __len__(self) -> int:
        return len(self.owner)

    @classmethod
    def joined(cls, parts: Sequence[Boxes]) -> Boxes:
        """All boxes of at least one part, in their order."""
        return cls(*(np.concatenate([getattr(part, each.name) for part in parts]) for each in fields(cls)))

    def take(self, rows: np.ndarray) -> Boxes:
        """Those rows."""
        return Boxes(*(getattr(self, each.name)[rows] for each in fields(self)))


@dataclass(frozen=True)
class MovingBody:
    """A free body, or a link on a hinge or a slide.

    Attributes:
        name: As in ``physics``: the object's id, or ``<id>.<link>``.
        kind: ``HINGE``, ``SLIDE`` or ``FREE``.
        owner: Number of its object; -1: the leaf of a door of the room.
        pos, quat: [3] [m], [4] (w, x, y, z) of its frame in the owner's (of a leaf: in the world).
        mass: In kg.
        body: Fields of a body of the MuJoCo model by name, as ``body_inertia``.
        joint: Fields of its joint and degree of freedom by name; empty for a free body.
        boxes: Its parts, the largest first.
    """

    name: str
    kind: int
    owner: int
    pos: np.ndarray
    quat: np.ndarray
    mass: float
    body: dict[str, np.ndarray]
    joint: dict[str, np.ndarray]
    boxes: Boxes


@dataclass(frozen=True)
class RoomBodies:
    """A room: what stands still and what moves."""

    scene: Scene
    still: Boxes
    links: tuple[MovingBody, ...]
    free: tuple[MovingBody, ...]


BODY_FIELDS = ("body_ipos", "body_iquat", "body_mass", "body_inertia", "body_invweight0", "body_subtreemass")
JOINT_FIELDS = ("jnt_pos", "jnt_axis", "jnt_range")
DOF_FIELDS = ("dof_frictionloss", "dof_damping", "dof_armature", "dof_invweight0")


def bodies_of(scene: Scene, load: Load | None = None, anchored: float = ANCHORED) -> RoomBodies:
    """The bodies of a room.

    Args:
        scene: The scene.
        load: From asset id to asset; None: the library of this user.
        anchored: Mass [kg] from which things stand still.
    """
    mujoco = load_mujoco()
    whole = model_of(scene, load)
    boxes = boxed(replace(whole, xml=_anchored(whole.xml, anchored)), MOST_PARTS)
    model = mujoco.MjModel.from_xml_string(boxes.xml, boxes.files)
    number = {o.id: k for k, o in enumerate(scene.objects)}
    names = [model.body(int(top)).name for top in model.body_rootid]
    owner = np.array([number.get(name, -1) for name in names])
    flat = {k for k, o in enumerate(scene.objects) if o.mount == "floor" and o.size[2] <= COVERING}
    links, free = [], []
    for b in range(1, model.nbody):
        if not model.body_jntnum[b] or owner[b] in flat:
            continue
        moving = _moving(model, b, int(owner[b]))
        (free if moving.kind == FREE else links).append(moving)
    still = np.flatnonzero(
        (model.body_weldid[model.geom_bodyid] == 0) & (model.geom_type != mujoco.mjtGeom.mjGEOM_PLANE)
    )
    still = np.array([g for g in still if owner[model.geom_bodyid[g]] not in flat], dtype=int)
    return RoomBodies(scene, _still(model, still, owner), tuple(links), tuple(free))


def _anchored(xml: str, heaviest: float) -> str:
    """The model without the free joints of what is heavy or has links."""
    root = parse_xml(xml, "room")
    for body in root.iterfind("worldbody/body"):
        joint = body.find("freejoint")
        if joint is None:
            continue
        mass = sum(float(g.get("mass", 0)) for g in body.iter("geom"))
        if mass >= heaviest or body.find("body") is not None:
            body.remove(joint)
            # What is part of the world is not left out as a parent is; links of a batch do not touch what stands still.
    return Xml.tostring(root, encoding="unicode")


def _moving(model: Any, b: int, owner: int) -> MovingBody:
    j = int(model.body_jntadr[b])
    kind, dof = int(model.jnt_type[j]), int(model.jnt_dofadr[j])
    parts = np.arange(model.body_geomadr[b], model.body_geomadr[b] + model.body_geomnum[b])
    boxes = _boxes(model, parts, owner)
    boxes = boxes.take(np.argsort(-np.prod(boxes.size, axis=1), kind="stable")[:MOST_PARTS])

    def read(names: Sequence[str], rows: Any) -> dict[str, np.ndarray]:
        return {name: np.array(getattr(model, name)[rows], dtype=np.float32) for name in names}

    body = read(BODY_FIELDS, b)
    # Of a free body the six numbers of its degrees of freedom.
    joint = read(DOF_FIELDS, slice(dof, dof + 6)) if kind == FREE else read(DOF_FIELDS, slice(dof, dof + 1))
    if kind != FREE:
        joint |= read(JOINT_FIELDS, j)
    # The base of a link stands at its object's frame; a leaf of the room is a body of the world.
    top = int(model.body_parentid[b]) == 0
    on_object = kind == FREE or (owner >= 0 and not top)
    pos = np.zeros(3) if kind == FREE else np.array(model.body_pos[b])
    quat = np.array([1.0, 0, 0, 0]) if kind == FREE else np.array(model.body_quat[b])
    name, owner = str(model.body(b).name), owner if on_object else -1
    return MovingBody(name, kind, owner, pos, quat, float(body["body_mass"]), body, joint, boxes)


def _boxes(model: Any, geoms: np.ndarray, owner: int) -> Boxes:
    """Geoms in the frame of their body; what is no box becomes the one around it."""
    centre, half = model.geom_aabb[geoms, :3], model.geom_aabb[geoms, 3:]
    quat = np.array(model.geom_quat[geoms]).reshape(-1, 4)
    pos = np.array(model.geom_pos[geoms]) + np.einsum("kij,kj->ki", matrix(xyzw(quat)), centre)
    return Boxes(np.full(len(geoms), owner), pos, quat, np.array(half), np.array(model.geom_friction[geoms]))


def _still(model: Any, geoms: np.ndarray, owner: np.ndarray) -> Boxes:
    """Boxes that stand still, in the frames of their objects; those of the room in the world's."""
    rows = []
    for g in geoms:
        b = int(model.geom_bodyid[g])
        one = _boxes(model, np.array([g]), int(owner[b]))
        if owner[b] < 0:  # walls: one body each, in the world
            turn = matrix(xyzw(np.array(model.body_quat[b])))
            pos = model.body_pos[b] + one.pos[0] @ turn.T
            quat = product(np.array(model.body_quat[b]), one.quat[0])
            one = Boxes(one.owner, pos[None], quat[None], one.size, one.friction)
        rows.append(one)
    return Boxes.joined(rows)
