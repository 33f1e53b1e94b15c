"""Drake model directives (``*.dmd.yaml``), as SceneSmith writes them for rooms and houses."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from sceneweaver.io import InputError, named_inside, parse_yaml, read_text, required_inside
from sceneweaver.io.messages import path_name

from ..frames import facing, yaw_matrix
from ..model import ReadOptions, SourceFormat, SourceObject, SourceRoom
from ..plans import rectangle
from ..sdf_boxes import Bounds, sdf_bounds
from ..values import Entry

MAX_NESTED = 1000
"""Directives files that one may add, at any depth."""

_AXES = facing("y")
_TAG = re.compile(r"!(AngleAxis|Rpy|Identity)\b")
_ROOM = re.compile(r"^(?:.*::)?room_(?P<name>.+)_frame$")
_SHELL = re.compile(r"^(?:.*::)?(?:room_geometry(?:_(?P<name>.+))?|floor_plan.*)$")


@dataclass
class _Model:
    """A model with its pose in a frame, which is told by the directives in any order."""

    name: str
    file: str
    folder: Path
    entry: Entry
    parent: str = ""
    pose: np.ndarray | None = None
    free: bool = False


class _Stage:
    """All frames and models that directives name."""

    def __init__(self, top: Path, options: ReadOptions):
        self.top, self.options = top, options
        self.frames: dict[str, tuple[str, np.ndarray, Entry]] = {}
        self.models: dict[str, _Model] = {}
        self.files = 0
        self.notes: list[str] = []

    def add(self, path: Path, space: str) -> None:
        """Read the directives of a file, with a namespace before their names."""
        self.files += 1
        if self.files > MAX_NESTED:
            raise InputError(f"{path_name(self.top)}: adds more than {MAX_NESTED} files, or itself")
        text = _TAG.sub("", read_text(path, max_bytes=16 * 2**20))
        root = Entry.of(path, parse_yaml(text, path_name(path)))
        for item in root["directives"].entries():
            for kind, given in item.items():
                self._one(kind, given, path, space)

    def _one(self, kind: str, given: Entry, path: Path, space: str) -> None:
        if kind == "add_frame":
            pose = given["X_PF"]
            parent = pose.word("base_frame", "world")
            self.frames[_in(space, given["name"].text())] = (_in(space, parent), _pose(pose), given)
        elif kind == "add_model":
            self._model(given, path, space)
        elif kind == "add_weld":
            child = _in(space, given["child"].text())
            model = self.models.get(child.rpartition("::")[0]) or self.models.get(child)
            pose = _pose(given["X_PC"]) if given.has("X_PC") else np.eye(4)
            parent = _in(space, given["parent"].text())
            if model is not None:
                model.parent, model.pose, model.free = parent, pose, False
            else:
                self.frames.setdefault(child, (parent, pose, given))
        elif kind == "add_directives":
            place = self._file(given["file"].text(), path.parent)
            if place is None:
                raise given["file"].error("no such file in the folder of the directives")
            self.add(place, _in(space, given.word("model_namespace")) if given.word("model_namespace") else space)
        elif kind not in ("add_model_instance", "add_collision_filter_group"):
            self.notes.append(f"{given.place}: directives of this kind are not read")

    def _model(self, given: Entry, path: Path, space: str) -> None:
        model = _Model(_in(space, given["name"].text()), given["file"].text(), path.parent, given)
        if given.has("default_free_body_pose"):
            poses = list(given["default_free_body_pose"].items())
            if poses:
                _, pose = poses[0]
                model.parent = _in(space, pose.word("base_frame", "world"))
                model.pose, model.free = _pose(pose), True
        self.models[model.name] = model

    def _file(self, name: str, folder: Path) -> Path | None:
        """A file that directives name: ``package://<name>/`` stands for their folder, or for the asset folder."""
        packed = name.startswith("package://")
        short = name.removeprefix("package://").partition("/")[2] if packed else name.removeprefix("file://")
        if not packed:
            required_inside(self.top.parent, folder / short, path_name(self.top))
        roots = [folder, self.top.parent, *([self.options.folder] if self.options.folder else [])]
        for root in roots:
            place = named_inside(root, root / short)
            if place is not None and place.is_file():
                return place
        return None

    def placed(self, name: str, deep: int = 0) -> tuple[np.ndarray, list[str]]:
        """The pose [4, 4] of a frame or a model's body in the world, and the frames on the way there."""
        if name.rpartition("::")[2] == "world" and name not in self.frames:
            return np.eye(4), []
        if deep > 100:
            raise InputError(f"{path_name(self.top)}: frame {name} hangs on itself; give it a parent")
        if name in self.frames:
            parent, pose, _ = self.frames[name]
        else:
            model = self.models.get(name) or self.models.get(name.rpartition("::")[0])
            if model is None:
                raise InputError(f"{path_name(self.top)}: frame {name!r} is not there; add it before it is used")
            parent, pose = model.parent or "world", np.eye(4) if model.pose is None else model.pose
        above, way = self.placed(parent, deep + 1)
        return above @ pose, [name, *way]

    def bounds(self, model: _Model) -> Bounds | None:
        """The box of a model in its frame [m], where its SDF is there."""
        place = self._file(model.file, model.folder)
        return sdf_bounds(place) if place is not None and place.suffix.lower() == ".sdf" else None


def _in(space: str, name: str) -> str:
    return f"{space}::{name}" if space and name != "world" else name


def _pose(given: Entry) -> np.ndarray:
    """A Drake transform: translation [m], rotation as {angle_deg, axis} or {deg: [roll, pitch, yaw]}."""
    matrix = np.eye(4)
    if given.has("translation"):
        matrix[:3, 3] = given["translation"].numbers(3)
    if not given.has("rotation"):
        return matrix
    turn = given["rotation"]
    if turn.has("angle_deg"):
        axis = np.array(turn["axis"].numbers(3))
        if not np.linalg.norm(axis) > 0:
            raise turn["axis"].error("has no length; give a direction")
        matrix[:3, :3] = _about(axis / np.linalg.norm(axis), math.radians(turn["angle_deg"].number(-1e6, 1e6)))
    elif turn.has("deg"):
        roll, pitch, yaw = (math.radians(v) for v in turn["deg"].numbers(3, -1e6, 1e6))
        x, y = _about(np.array((1.0, 0.0, 0.0)), roll), _about(np.array((0.0, 1.0, 0.0)), pitch)
        matrix[:3, :3] = yaw_matrix(yaw) @ y @ x
    elif turn.mapping():
        raise turn.error("give angle_deg and axis (!AngleAxis), or deg (!Rpy); random poses are not read")
    return matrix


def _about(axis: np.ndarray, angle: float) -> np.ndarray:
    """The rotation [3, 3] about a unit axis, by Rodrigues' formula."""
    x, y, z = axis
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + math.sin(angle) * k + (1 - math.cos(angle)) * k @ k


def _matches(path: Path, head: bytes) -> bool:
    return path.name.lower().endswith((".yaml", ".yml")) and b"directives:" in head


def _read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    stage = _Stage(path, options)
    stage.add(path, "")
    rooms: dict[str, list[SourceObject]] = {}
    outlines: dict[str, tuple[tuple[tuple[float, float], ...], float]] = {}
    for name in (m["name"] for f in stage.frames if (m := _ROOM.match(f))):
        rooms.setdefault(name, [])
    notes = list(stage.notes)
    bare = 0
    for model in stage.models.values():
        pose, way = stage.placed(model.name)
        room = next((m["name"] for f in way if (m := _ROOM.match(f))), "")
        box = stage.bounds(model)
        if shell := _SHELL.match(model.name):
            if box is not None:
                outlines[shell["name"] or room] = _outline(pose, box)
            continue
        bare += box is None
        rooms.setdefault(room, []).append(_object(model, pose, box))
    if bare:
        notes.append(f"the SDF files of {bare} models are not there; give their folder as --asset-folder")
    if not stage.models:
        raise InputError(f"{path_name(path)}: directives: no add_model in it; nothing stands there")
    if "" in rooms and not rooms[""] and len(rooms) > 1:
        del rooms[""]
    for name, things in (rooms or {"": []}).items():
        outline, height = outlines.get(name, (None, None))
        yield SourceRoom(name, "", outline, height, (), tuple(things), notes=tuple(notes))


def _outline(pose: np.ndarray, box: Bounds) -> tuple[tuple[tuple[float, float], ...], float]:
    """The floor rectangle and the height of a room's shell, whose walls are in it."""
    low, high = box
    x, y, tall = (float(v) for v in high - low)
    corners = np.array([(*c, 0.0) for c in rectangle(x, y, float(low[0]), float(low[1]))])
    return tuple((float(p[0]), float(p[1])) for p in corners @ pose[:3, :3].T + pose[:3, 3]), tall + min(
        float(low[2]), 0
    )


def _object(model: _Model, pose: np.ndarray, box: Bounds | None) -> SourceObject:
    position, size = pose[:3, 3], None
    if box is not None:
        low, high = box
        width, depth, tall = (float(v) for v in high - low)
        position, size = position + pose[:3, :3] @ (low + high) / 2, (depth, width, tall)
    carrier = model.parent.rpartition("::")[0]
    return SourceObject(
        model.name,
        Path(model.file).stem if model.name.startswith("model") else model.name.rpartition("::")[2],
        (float(position[0]), float(position[1]), float(position[2])),
        pose[:3, :3] @ _AXES.T,
        size,
        "origin" if size is None else "centre",
        asset=model.file,
        support=carrier or None,
        keep={"free": model.free},
    )


FORMAT = SourceFormat(
    "drake",
    "Drake model directives (scene.dmd.yaml, house.dmd.yaml)",
    _matches,
    _read,
    notes=(
        "Read: add_frame, add_model with default_free_body_pose, add_weld (X_PC) and add_directives; rotations as "
        "!AngleAxis and !Rpy. Models under a frame `room_<name>_frame` are of that room.",
        "Boxes are those of the visuals in the SDF files, from the folder of the directives or --asset-folder "
        "(`package://<name>/` stands for either); without them the size is looked up by the model's name.",
        "Assumed: models are z up and face +y; a body that is welded has its model's frame; the outline of a room is "
        "the box of its `room_geometry` model, walls included.",
        "Lost: openings (SceneSmith's own state has them), masses, joints, collision filters.",
    ),
)
