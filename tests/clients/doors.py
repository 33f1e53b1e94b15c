"""Do all doors open? ``python -m tests.clients.doors HOME.JSON`` drives each leaf of a home, one after the other.

A leaf is pulled by what a hand can do until it is open, in MuJoCo with all things around it, and held there.
"""

from __future__ import annotations

import math
import sys
import tempfile
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.export import export_home
from sceneweaver.home import Home

mujoco: Any = import_module("mujoco")

SECONDS = 3.0
"""How long a leaf is pulled."""

PULL = {3: 15.0, 2: 60.0}
"""[N m] of hinges and [N] of slides, by the type of the joint: a tenth of what a person can."""


def opened(model: Any, prefix: str) -> dict[str, tuple[float, float, list[str]]]:
    """For each joint whose name starts so: how far it came, how far it can go [rad] or [m], and what touched its body
    on the way, but for its own end of travel."""
    found = {}
    for joint in range(model.njnt):
        name = model.joint(joint).name
        if name.startswith(prefix) and int(model.jnt_type[joint]) in PULL:
            found[name] = _driven(model, joint)
    return found


def _driven(model: Any, joint: int) -> tuple[float, float, list[str]]:
    data = mujoco.MjData(model)
    at, dof, body = (int(a[joint]) for a in (model.jnt_qposadr, model.jnt_dofadr, model.jnt_bodyid))
    end, most = float(model.jnt_range[joint][1]), PULL[int(model.jnt_type[joint])]
    touched = set()
    for step in range(round(SECONDS / model.opt.timestep)):
        # Towards where a hand would have it by now, which is open after two thirds of the time.
        wanted = end * min(1.0, 1.5 * step * model.opt.timestep / SECONDS)
        pull = 200.0 * (wanted - float(data.qpos[at])) - 20.0 * float(data.qvel[dof])
        data.qfrc_applied[dof] = float(np.clip(pull, -most, most)) + float(np.sign(pull)) * model.dof_frictionloss[dof]
        mujoco.mj_step(model, data)
        for k in range(data.ncon):
            pair = [int(model.geom_bodyid[g]) for g in data.contact[k].geom]
            if body in pair and data.contact[k].dist < -1e-4:
                touched.add(model.body(pair[1 - pair.index(body)]).name)
    return float(data.qpos[at]), end, sorted(touched)


def main(paths: list[str]) -> int:
    """The command line: a line for each leaf, and 1 where one does not open."""
    shut = 0
    for path in paths:
        with tempfile.TemporaryDirectory() as place:
            files = export_home(Home.load(path), Path(place) / "out", ["mjcf"], textures=False)
            sleeping = files["mjcf"].with_name("home-sleep.xml")
            model = mujoco.MjModel.from_xml_path(str(sleeping))
        for name, (at, end, touched) in opened(model, "home:door:").items():
            slides = int(model.joint(name).type[0]) == 2
            shut += not at > 0.98 * end
            text = (
                f"{at:.3f} of {end:.3f} m" if slides else f"{math.degrees(at):.1f} of {math.degrees(end):.1f} degrees"
            )
            print(f"{path}: {name}: {text}" + (f", touches {', '.join(touched)}" if touched else ""))
    return int(shut > 0)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
