"""What the exported files of a scene name and where they put its objects, read from their text alone."""

from __future__ import annotations

import json
import struct
from collections.abc import Iterator, Mapping, Sequence
from typing import Any
from urllib.parse import unquote
from xml.etree import ElementTree

import numpy as np

from sceneweaver.geometry.rotations import matrix, xyzw
from sceneweaver.scene import InputError, Scene

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
        return json.loads(content[20 : 20 + length])
    except (struct.error, ValueError) as error:
        raise InputError(f"no GLB: {error}") from None


def glb_files(document: Mapping[str, Any]) -> Iterator[str]:
    """The files that a GLB names."""
    for part in ("buffers", "images"):
        for row in document.get(part, ()):
            uri = row.get("uri")
            if uri is not None and not uri.startswith("data:"):
                yield unquote(uri)


def glb_frames(document: Mapping[str, Any]) -> dict[str, np.ndarray]:
    """Matrices [4, 4] of the nodes by their names, with z up."""
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
    stack = [(root, up) for root in scene.get("nodes", ())]
    while stack:
        number, above = stack.pop()
        frame = above @ local[number]
        found[nodes[number].get("name", "")] = frame
        stack += [(child, frame) for child in nodes[number].get("children", ())]
    return found


def mjcf_tree(content: bytes) -> ElementTree.Element:
    """The elements of an MJCF file.

    Raises:
        InputError: no XML, or of something else.
    """
    try:
        root = ElementTree.fromstring(content)
    except ElementTree.ParseError as error:
        raise InputError(f"no XML: {error}") from None
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
