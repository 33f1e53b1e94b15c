"""An exported room measured in a client: ``python measure.py CLIENT FOLDER EXPECTED.JSON SECONDS``, one line of JSON.

This runs in the python of the client, which has numpy and nothing of sceneweaver. ``client_<name>.py`` beside this file
knows how the client loads a room; what is measured is here, the same for all.
"""

from __future__ import annotations

import json
import re
import sys
import time
from abc import ABC, abstractmethod
from importlib import import_module

import numpy as np

FAR, LITTLE = 0.1, 0.01  # [m]
OPEN = 0.9  # share of a joint's range


class Client(ABC):
    """A room in a client. Bodies and joints have the names of the client; `plain` makes them those of the room.

    A joint has the name of the body that hangs on it. Poses are (position [3], quaternion w x y z [4]).
    """

    frames = "object"
    """Where the frame of a link stands: "object", as all of an object, or "link", at the anchor of its joint."""

    bodies_fixed = True
    """Whether what stands still and has no joints is a body."""

    simulates = True
    """Whether time can pass in it."""

    rests_first = False
    """Whether joints leave traces, so that rest has to be measured before them."""

    @classmethod
    @abstractmethod
    def version(cls):
        """Of the package."""

    @abstractmethod
    def __init__(self, folder):
        """Load the room of a folder."""

    @abstractmethod
    def poses(self):
        """Of all bodies by name."""

    def joints(self):
        """Kind ("hinge" or "slide") and limits of all joints by name."""
        return {}

    def set_joint(self, name, value):
        """Put a joint somewhere, without a step of time."""
        raise NotImplementedError

    def step(self, seconds):
        """Let time pass."""
        raise NotImplementedError


def plain(name):
    """A name as every client has it: what is no letter or digit is "_"."""
    return re.sub(r"[^A-Za-z0-9]", "_", name)


def usd_name(path):
    """The name of the body at a path of a USD stage: objects have their links below them, doors a frame and a leaf.

    Joints have the name of their body and "_joint". In a home, objects are below their rooms.
    """
    _, _, group, *names = path.split("/")
    if group == "Rooms" and len(names) > 2:
        _, group, *names = names
    if not names:
        return path
    name = names[-1].removesuffix("_joint")
    if group == "Objects":
        return names[0] if name == f"{names[0]}_base" else name
    return name.removesuffix("_leaf") if name.endswith("_leaf") or names[-1].endswith("_joint") else path


def rotation(q):
    """Matrix [3, 3] of a quaternion w x y z."""
    w, x, y, z = np.asarray(q, dtype=float) / np.linalg.norm(q)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def moved(pose, joint, value):
    """A pose (position [3], matrix [3, 3]) after its joint went from 0 to a value."""
    position, turn = pose
    axis, anchor = np.array(joint["axis"]), np.array(joint["anchor"])
    if joint["kind"] == "slide":
        return position + axis * value, turn
    cross = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    by = np.eye(3) + np.sin(value) * cross + (1 - np.cos(value)) * cross @ cross
    return anchor + by @ (position - anchor), by @ turn


def apart(found, wanted):
    """Distance [m] and angle [rad] between a pose of a client and one of (position, matrix)."""
    chord = np.linalg.norm(rotation(found[1]) - wanted[1]) / np.sqrt(8)
    return float(np.linalg.norm(np.asarray(found[0]) - wanted[0])), float(2 * np.arcsin(min(1.0, chord)))


def measure(client, expected, seconds):
    """All measurements of a loaded room."""
    frame = {plain(n): b[client.frames] for n, b in expected["bodies"].items()}
    wanted = {n: (np.array(p), rotation(q)) for n, (p, q) in frame.items()}
    bodies = {plain(n): b for n, b in expected["bodies"].items()}
    joints = {plain(n): j for n, j in expected["joints"].items()}
    poses = {plain(n): p for n, p in client.poses().items()}
    off = {n: apart(poses[n], wanted[n]) for n in wanted if n in poses}
    result = {
        "bodies": len(off),
        "bodies_expected": len(wanted),
        "bodies_missing": sorted(n for n in set(wanted) - set(off) if client.bodies_fixed or bodies[n]["moves"])[:8],
        "pose_m": max((d for d, _ in off.values()), default=0.0),
        "pose_rad": max((a for _, a in off.values()), default=0.0),
        "pose_worst": max(off, key=lambda n: max(off[n]), default=""),
    }
    resting = client.simulates and seconds > 0
    if resting and client.rests_first:
        result |= rest(client, bodies, seconds)
    names = {plain(n): n for n in client.joints()}
    result |= {"joints_expected": len(joints), "joints": len(names.keys() & joints.keys())}
    result["joints_missing"] = sorted(joints.keys() - names.keys())[:8]
    if names:
        result |= joint_measures(client, joints, names, wanted, LITTLE if client.rests_first else 1e-4)
    if resting and not client.rests_first:
        result |= rest(client, bodies, seconds)
    return result


def joint_measures(client, joints, names, wanted, slack):
    """Limits, and where each door and drawer is at 90 % and back at 0, within ``slack`` [m] and [rad]."""
    found = client.joints()
    wrong, opened = [], 0
    for name, joint in joints.items():
        if name not in names:
            continue
        kind, *limits = found[names[name]]
        if kind != joint["kind"] or np.abs(np.array(limits) - joint["limits"]).max() > 1e-4:
            wrong.append([name, kind, *limits, *joint["limits"]])
            continue
        value = OPEN * max(joint["limits"], key=abs)
        right = True
        for at in (value, 0.0):
            client.set_joint(names[name], at)
            pose = {plain(n): p for n, p in client.poses().items()}[name]
            right &= max(apart(pose, moved(wanted[name], joint, at))) < slack
        opened += right
    return {"joints_wrong": wrong[:4], "joints_opened": opened}


def rest(client, bodies, seconds):
    """How far the middles of things that may move go by themselves."""

    def middles():
        poses = {plain(n): p for n, p in client.poses().items()}
        free = [n for n, b in bodies.items() if b["free"] and n in poses]
        return {n: np.asarray(poses[n][0]) + rotation(poses[n][1]) @ bodies[n]["middle"] for n in free}

    before = middles()
    began, busy = time.perf_counter(), time.process_time()
    client.step(seconds)
    spent, busy = time.perf_counter() - began, time.process_time() - busy
    after = middles()
    shift = {n: float(np.linalg.norm(after[n] - before[n])) for n in before}
    far = np.array(list(shift.values()) or [0.0])
    far = np.where(np.isfinite(far), far, np.inf)
    worst = sorted(shift, key=lambda n: -shift[n])[:6]
    return {
        "free": len(shift),
        "far": float((far > FAR).mean()),
        "little": float((far > LITTLE).mean()),
        "most_m": float(far.max()),
        "mean_m": float(far.mean()),
        "worst": {n: shift[n] for n in worst},
        "rest_s": spent,
        "rest_cpu_s": busy,
        "real_time": seconds / spent,
    }


def main(name, folder, expected, seconds):
    """The line of a client and a folder."""
    with open(expected, encoding="utf-8") as file:
        wanted = json.load(file)
    began = time.perf_counter()
    kind = import_module(f"client_{name}").Room
    imported = time.perf_counter()
    client = kind(folder)
    loaded = time.perf_counter()
    result = {"client": name, "version": kind.version(), "import_s": imported - began, "load_s": loaded - imported}
    return result | measure(client, wanted, float(seconds))


if __name__ == "__main__":
    sys.modules["measure"] = sys.modules["__main__"]  # clients import it under this name
    line = json.dumps(main(*sys.argv[1:5]))
    print("\n" + line, flush=True)
