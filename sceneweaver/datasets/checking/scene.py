"""One scene of a data set judged again: its files against each other, against the judge and against its row."""

from __future__ import annotations

import math
import struct
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from urllib.parse import unquote
from xml.etree import ElementTree

import numpy as np

from sceneweaver.geometry.polygons import signed_area
from sceneweaver.geometry.rotations import matrix, xyzw
from sceneweaver.io import InputError, load_mjcf, parse_json, parse_xml, read_bytes, write_atomic
from sceneweaver.physics.mjcf_file import simulate
from sceneweaver.scene import Scene
from sceneweaver.verify import Report, check

from ..samples import report_columns, scene_columns
from ..seals import kind_fault
from ..store.scene_files import SUFFIXES
from .findings import Findings

APART = 1e-3
"""How far [m] an object of an exported file may be from its pose in ``scene.json``, and any point at one metre from
its origin by a turn: rounding of its text."""

_FILES = {"mesh": "meshdir", "texture": "texturedir", "hfield": "meshdir", "model": "", "include": ""}  # in MJCF
_JSON_CHUNK = 0x4E4F534A
_Z_UP = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])  # of glTF, in which y is up


def glb_json(content: bytes) -> dict[str, Any]:
    """The JSON of a GLB file.

    Raises:
        InputError: no GLB, or a damaged one.
    """
    try:
        magic, version, size = struct.unpack_from("<4sII", content)
        length, kind = struct.unpack_from("<II", content, 12)
        if (magic, version, size, kind) != (b"glTF", 2, len(content), _JSON_CHUNK):
            raise InputError("no GLB of version 2, or cut off")
        return parse_json(content[20 : 20 + length])
    except struct.error as error:
        raise InputError(f"no GLB: {error}") from None


def glb_files(document: Mapping[str, Any]) -> Iterator[str]:
    """The files that a GLB names."""
    for part in ("buffers", "images"):
        for row in document.get(part, ()):
            uri = row.get("uri")
            if uri is not None and not uri.startswith("data:"):
                yield unquote(uri)


def glb_frames(document: Mapping[str, Any]) -> dict[str, np.ndarray]:
    """Matrices [4, 4] of the nodes by their names, the room's frame and those of the nodes with z up.

    In the file all frames are y up; files of older releases have frames with z up below a root that turns them.
    """
    nodes = document.get("nodes", [])
    local = _matrices(
        [node.get("translation", (0, 0, 0)) for node in nodes], [node.get("rotation", (0, 0, 0, 1)) for node in nodes]
    )
    for number, node in enumerate(nodes):
        if "matrix" in node:
            local[number] = np.reshape(node["matrix"], (4, 4)).T
    up = np.eye(4)
    up[:3, :3] = _Z_UP
    found = {}
    scene = document.get("scenes", [{}])[document.get("scene", 0)]
    roots = scene.get("nodes", ())
    own = np.eye(4) if any("rotation" in nodes[root] for root in roots) else up.T
    stack = [(root, up) for root in roots]
    while stack:
        number, above = stack.pop()
        frame = above @ local[number]
        found[nodes[number].get("name", "")] = frame @ own
        stack += [(child, frame) for child in nodes[number].get("children", ())]
    return found


def mjcf_tree(content: bytes) -> ElementTree.Element:
    """The elements of an MJCF file.

    Raises:
        InputError: no XML, or of something else.
    """
    root = parse_xml(content, "MJCF")
    if root.tag not in ("mujoco", "mujocoinclude"):
        raise InputError(f"no MJCF: its root is <{root.tag}>")
    return root


def mjcf_files(root: ElementTree.Element) -> Iterator[str]:
    """The files that an MJCF file names, relative to the folder of the file that is loaded."""
    compiler = root.find("compiler")
    folders = {} if compiler is None else compiler.attrib
    assets = folders.get("assetdir", "")
    for tag, key in _FILES.items():
        folder = "" if tag == "include" else folders.get(key, assets)
        for element in root.iter(tag):
            if (name := element.get("file")) is not None:
                yield f"{folder}/{name}" if folder else name


def included_files(content: bytes) -> frozenset[str]:
    """The files that an MJCF file of the store names; one that speaks of none holds numbers alone, and is not parsed.

    Raises:
        InputError: no MJCF, or cut off.
    """
    text = content.strip()
    if b"file" not in text and text.startswith(b"<mujoco") and text.endswith((b"</mujoco>", b"</mujocoinclude>")):
        return frozenset()
    return frozenset(mjcf_files(mjcf_tree(content)))


def mjcf_frames(root: ElementTree.Element) -> dict[str, np.ndarray]:
    """Matrices [4, 4] of the bodies of the world by their names."""
    bodies = [body for world in root.iter("worldbody") for body in world.findall("body")]
    positions = [_numbers(body.get("pos", "0 0 0")) for body in bodies]
    turns = xyzw([_numbers(body.get("quat", "1 0 0 0")) for body in bodies]) if bodies else []
    frames = _matrices(positions, turns)
    return {body.get("name", ""): frame for body, frame in zip(bodies, frames, strict=True)}


def misplaced(scene: Scene, frames: Mapping[str, np.ndarray]) -> Iterator[str]:
    """Lines about objects of a scene that a file has elsewhere, or not at all."""
    there = [obj for obj in scene.objects if obj.id in frames]
    for obj in scene.objects:
        if obj.id not in frames:
            yield f"{obj.id} is missing"
    if not there:
        return
    wanted = _matrices([obj.pose.position for obj in there], [obj.pose.quaternion for obj in there])
    off = np.array([frames[obj.id] for obj in there]) - wanted
    apart = np.linalg.norm(off[:, :3, 3], axis=1)
    turned = np.linalg.norm(off[:, :3, :3], axis=(1, 2), ord=2)
    for obj, far, turn in zip(there, apart, turned, strict=True):
        if not far <= APART:
            yield f"{obj.id} is {far:.3f} m away from its pose in scene.json"
        elif not turn <= APART:
            yield f"{obj.id} is turned against its pose in scene.json"


def _matrices(positions: Sequence[Sequence[float]], quaternions: Any) -> np.ndarray:
    """Matrices [N, 4, 4] of positions [N, 3] and quaternions [N, 4] (x, y, z, w)."""
    found = np.tile(np.eye(4), (len(positions), 1, 1))
    if len(positions):
        found[:, :3, 3] = positions
        found[:, :3, :3] = matrix(quaternions)
    return found


def _numbers(text: str) -> list[float]:
    return [float(word) for word in text.split()]


_COUNTS = ("valid", "collisions", "out_of_bounds", "unsupported", "blocked_zones", "blocked_openings")
_CLOSE = {"area": 0.01, "walkable_share": 1e-3, "relations_satisfied": 1e-6}
"""How far a number of a row may be from what is measured."""


@dataclass
class Judge:
    """Judges the scenes of a data set, one by one.

    Attributes:
        root: the data set.
        formats: what each scene is exported to.
        seconds: how long scenes are let loose in MuJoCo, in its own time.
        still: farthest that a thing may move then [m]; None: any distance.
    """

    root: Path
    formats: tuple[str, ...] = ()
    seconds: float = 3.0
    still: float | None = None
    _there: dict[str, frozenset[str]] = field(default_factory=dict)  # files of the store, and what these name

    def judge(self, row: Mapping[str, Any], files: Mapping[str, bytes], found: Findings) -> None:
        """Judge a scene; faults and counts go to ``found``."""
        key = row["key"]
        found.counts["judged"] += 1
        try:
            scene = Scene.loads(files["scene.json"])
        except KeyError:
            return found.fault("content", key, "has no scene.json")
        except InputError as error:
            return found.fault("judge", key, f"scene.json: {error}")
        report = check(scene)
        found.judged(key, scene, report)
        recorded = (*differences(row, scene, report), *_metrics(files.get("metrics.json"), report))
        for line in (*recorded, *twin_faults(scene, files)):
            found.fault("record", key, line)
        found.counts["twins"] += len(twin_names(files))
        for name in self.formats:
            suffix = SUFFIXES.get(name)
            if suffix is not None and suffix not in files:
                found.fault("export", key, f"has no {suffix}")
        self.exports(row, files, found, lambda frames: misplaced(scene, frames))

    def simulate(self, key: str, content: bytes, seconds: float, found: Findings) -> None:
        """Compile the MJCF file of a scene and let it loose for a time; 0: only compile it."""
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "scene.xml"
            write_atomic(path, content)
            (path.parent / "assets").symlink_to((self.root / "assets").resolve())
            try:
                load_mjcf(path)
                result = simulate(path, seconds)
            except ValueError as error:
                return found.fault("compile", key, f"MuJoCo does not take it: {' '.join(str(error).split())[:200]}")
        found.counts["compiled"] += 1
        if not seconds:
            return None
        found.counts["simulated"] += 1
        found.moved(key, result["moved"])
        for name, count in result["warnings"].items():
            found.fault("stability", key, f"MuJoCo warns {count} times: {name}")
        far, name = max(((far, name) for name, far in result["moved"].items()), default=(0.0, ""))
        if not result["finite"]:
            found.fault("stability", key, "diverges")
        elif self.still is not None and far > self.still:
            found.fault("stability", key, f"{name} moves {far:.3f} m; {self.still:g} m are allowed")
        return None

    def exports(
        self,
        row: Mapping[str, Any],
        files: Mapping[str, bytes],
        found: Findings,
        misplaced: Callable[[Mapping[str, np.ndarray]], Iterator[str]],
    ) -> None:
        """Files of the store that are named, and where objects are: lines of ``misplaced`` about a file's frames."""
        key = row["key"]
        for suffix, read, names, frames in (
            ("glb", glb_json, glb_files, glb_frames),
            ("xml", mjcf_tree, mjcf_files, mjcf_frames),
        ):
            if suffix not in files:
                continue
            try:
                document: Any = read(files[suffix])
                lines = list(misplaced(frames(document)))
                self.named(row, suffix, set(names(document)), found)
            except (InputError, ArithmeticError, LookupError, TypeError, ValueError) as error:
                found.fault("export", key, f"{suffix}: {error}")
                continue
            found.counts[f"{suffix} read"] += 1
            for line in lines[:3]:
                found.fault("export", key, f"{suffix}: {line}")

    def named(self, row: Mapping[str, Any], suffix: str, names: set[str], found: Findings) -> None:
        """Files that an export names, and those that MJCF files of the store name, are there, and in the row."""
        left = set(names)
        while left:
            name = left.pop()
            if name not in self._there:
                if not name.startswith("assets/") or ".." in name or kind_fault(self.root / name):
                    found.fault("asset", row["key"], f"{suffix} names {name}, which is not in the store")
                    continue
                self._there[name] = frozenset()
                if name.endswith(".xml"):
                    self._there[name] = included_files(read_bytes(self.root / name))
            left |= self._there[name] - names
            names |= self._there[name]
        if row.get("assets") is not None and (more := names.difference(row["assets"])):
            found.fault("asset", row["key"], f"{suffix} names {min(more)}, which the index does not list")


def differences(row: Mapping[str, Any], scene: Scene, report: Report) -> list[str]:
    """Lines about columns of a row that are not what the scene is. Columns that are null say nothing."""
    measured = {"prompt": scene.prompt, "area": signed_area(scene.room.outline)}
    lines = []
    for name, value in (measured | scene_columns(scene) | report_columns(report)).items():
        said = row.get(name)
        if said is None or value is None:
            continue
        if name == "categories":
            if set(said) != set(value):
                lines.append("its categories are not those of the index")
            continue
        close = math.isclose(said, value, rel_tol=1e-6, abs_tol=_CLOSE[name]) if name in _CLOSE else said == value
        if not close:
            lines.append(f"{name} is {value!r}; the index says {said!r}")
    return lines


def _metrics(content: bytes | None, report: Report) -> list[str]:
    """Lines about counts of ``metrics.json`` that are not what is measured."""
    if content is None:
        return []
    try:
        said = parse_json(content)
        return [
            f"{name} is {getattr(report, name)!r}; metrics.json says {said[name]!r}"
            for name in _COUNTS
            if name in said and said[name] != getattr(report, name)
        ]
    except (ValueError, TypeError) as error:
        return [f"metrics.json: {error}"]


SCENE, DIFFERENCE = ".scene.json", ".difference.json"

_MEASURED = ("valid", "collisions", "out_of_bounds")


def twin_names(files: Mapping[str, bytes]) -> list[str]:
    """The names of the twins among the files of a scene, by suffix: twin-0, twin-1 ..."""
    return sorted({suffix.partition(".")[0] for suffix in files if suffix.startswith("twin-")})


def twin_faults(scene: Scene, files: Mapping[str, bytes]) -> Iterator[str]:
    """Lines about twins that are not what is stated of them."""
    for name in twin_names(files):
        try:
            twin = Scene.loads(files[name + SCENE])
            stated = parse_json(files[name + DIFFERENCE])
            changed, report = {stated["object"], *stated["carried"]}, check(twin, walkable=False)
            for key in _MEASURED:
                said, measured = stated["measured"][key][1], getattr(report, key)
                if said != measured:
                    yield f"{name}: {key} is {measured!r}; its difference says {said!r}"
        except (InputError, ValueError, TypeError, LookupError) as error:
            yield f"{name}: {type(error).__name__}: {error}"
            continue
        old, new = ({obj.id: obj for obj in one.objects} for one in (scene, twin))
        differ = {i for i in old.keys() | new.keys() if old.get(i) != new.get(i)}
        if differ - changed or twin.room != scene.room:
            more = ", ".join(sorted(differ - changed)) or "the room"
            yield f"{name}: {more} differs as well, which is not stated"
        if stated["object"] not in differ and twin.relations == scene.relations:
            yield f"{name}: nothing differs"
