"""An exported scene let loose in plain MuJoCo: ``python -I mjcf_file.py SCENE.XML SECONDS`` prints a line of JSON.

It imports nothing of sceneweaver: a free body is one with a free joint. Its shift [m] is that of the middle of the box
around its collision parts (those of its doors included), so that what tips over has moved. Joints of doors and drawers
report the share of their range by which they moved.
"""

import json
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.runtime.mujoco_module import load_mujoco


def simulate(path: str | Path, seconds: float) -> dict[str, Any]:
    """Load a file and let it loose.

    Args:
        path: the MJCF file.
        seconds: how long, in its own time.

    Returns:
        ``moved``: shift [m] by name of each free body; ``doors`` and ``ajar``: joints of doors and the largest share
        of a range that one moved by; ``parts`` that collide, most ``contacts``; ``warnings`` of MuJoCo by name;
        ``finite``: whether it did not diverge; ``load_s`` and ``run_s``: wall time.
    """
    mujoco = load_mujoco()
    began = time.perf_counter()
    model = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(model)
    loaded = time.perf_counter()
    mujoco.mj_kinematics(model, data)
    inside = _middles(mujoco, model, data)
    before, contacts = _places(data, inside), 0
    for _ in range(round(seconds / model.opt.timestep)):
        mujoco.mj_step(model, data)
        contacts = max(contacts, int(data.ncon))
    done = time.perf_counter()
    mujoco.mj_kinematics(model, data)
    far = np.linalg.norm(_places(data, inside) - before, axis=1)
    doors = np.flatnonzero(model.jnt_type != mujoco.mjtJoint.mjJNT_FREE)
    span = model.jnt_range[doors, 1] - model.jnt_range[doors, 0]
    ajar = np.abs(data.qpos[model.jnt_qposadr[doors]]) / span
    warnings = {str(mujoco.mjtWarning(k).name): int(w.number) for k, w in enumerate(data.warning) if w.number}
    return {
        "moved": {model.body(b).name: float(v) for b, v in zip(inside, far, strict=True)},
        "doors": len(doors),
        "ajar": float(ajar.max(initial=0.0)),
        "parts": int((model.geom_contype > 0).sum()),
        "contacts": contacts,
        "warnings": warnings,
        "finite": bool(np.isfinite(data.qpos).all()),
        "load_s": loaded - began,
        "run_s": done - loaded,
    }


def _middles(mujoco, model, data):
    """The middle [3] of each free body's box in the body's frame, by id of the body."""
    found = {}
    for body in model.jnt_bodyid[model.jnt_type == mujoco.mjtJoint.mjJNT_FREE]:
        mine = (model.body_rootid[model.geom_bodyid] == body) & (model.geom_contype > 0)
        turn, low, high = data.xmat[body].reshape(3, 3), np.full(3, np.inf), np.full(3, -np.inf)
        for geom in np.flatnonzero(mine):
            centre, half = model.geom_aabb[geom, :3], model.geom_aabb[geom, 3:]
            world = data.geom_xmat[geom].reshape(3, 3)
            at = turn.T @ (data.geom_xpos[geom] + world @ centre - data.xpos[body])
            reach = np.abs(turn.T @ world) @ half
            low, high = np.minimum(low, at - reach), np.maximum(high, at + reach)
        found[int(body)] = (low + high) / 2
    return found


def _places(data, inside):
    """Where those points are in the world, [N, 3]."""
    return np.array([data.xpos[b] + data.xmat[b].reshape(3, 3) @ p for b, p in inside.items()]).reshape(-1, 3)


if __name__ == "__main__":
    sys.stdout.write(json.dumps(simulate(sys.argv[1], float(sys.argv[2]))) + "\n")
