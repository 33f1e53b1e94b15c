"""Whether what lies in and on drawn things rests where it is drawn: alone on a floor in MuJoCo.

``python -m tests.assets.items [CATEGORY ...] [--seeds N]`` prints items that move more than a centimetre in 3 s, and
those that are drawn into something else.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from importlib import import_module
from typing import Any

import numpy as np

from sceneweaver.assets.asset import Asset
from sceneweaver.assets.parametric import make, makers
from sceneweaver.physics import build
from sceneweaver.scene import Pose, Room, Scene

SECONDS = 3.0
FAR = 0.01
"""What moves farther [m] does not rest where it is drawn."""

DEEP = 0.002
"""How far parts may reach into each other [m]."""


ROOM = Room(outline=((-3, -3), (3, -3), (3, 3), (-3, 3)), height=3)


def shifts_of(asset: Asset, seconds: float = SECONDS) -> tuple[dict[str, float], float]:
    """How far the middle of the mass of each body moves [m], by its name, and the deepest contact at the start [m]."""
    mujoco: Any = import_module("mujoco")
    thing = asset.object("o", pose=Pose.from_yaw(0, 0, 0, 0), mount="floor")
    scene = Scene(id="s", room=ROOM, objects=(thing,))
    model = mujoco.MjModel.from_xml_string(build(scene, {asset.id: asset}.__getitem__).xml)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    deep = -min((contact.dist for contact in data.contact), default=0.0)
    names = [name for k in range(model.nbody) if (name := model.body(k).name).partition(".")[0] == "o"]
    before = {name: data.body(name).xipos.copy() for name in names}
    while data.time < seconds:
        mujoco.mj_step(model, data)
    return {name[2:] or "base": float(np.linalg.norm(data.body(name).xipos - at)) for name, at in before.items()}, deep


def faults_of(asset: Asset) -> Iterator[str]:
    """What does not rest, and what is drawn into something else."""
    moved, deep = shifts_of(asset)
    for name, shift in moved.items():
        if shift > FAR:
            yield f"{name} moves {shift * 1e3:.0f} mm"
    if deep > DEEP:
        yield f"parts reach {deep * 1e3:.1f} mm into each other"


def main() -> int:
    """Examine categories and print the faults."""
    parser = argparse.ArgumentParser(description=main.__doc__)
    parser.add_argument("categories", nargs="*")
    parser.add_argument("--seeds", type=int, default=3)
    options = parser.parse_args()
    bad = kinds = items = 0
    for name in options.categories or sorted(makers()):
        for seed in range(options.seeds):
            asset = make(name, seed)
            loose = sum(link.joint == "free" for link in asset.links)
            if not loose:
                break
            items += loose
            kinds += seed == 0
            for fault in faults_of(asset):
                print(f"{name} seed {seed}: {fault}")
                bad += 1
    print(f"{items} items of {kinds} kinds, {bad} faults")
    return 1 if bad else 0


if __name__ == "__main__":
    raise SystemExit(main())
