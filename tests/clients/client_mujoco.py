"""MuJoCo: ``scene.xml``."""

import mujoco
import numpy as np
from measure import Client


class Room(Client):
    """The room as it is."""

    @classmethod
    def version(cls):
        return mujoco.__version__

    def __init__(self, folder):
        self.load(mujoco.MjModel.from_xml_path(f"{folder}/scene.xml"))

    def load(self, model):
        self.model, self.data = model, mujoco.MjData(model)
        mujoco.mj_forward(self.model, self.data)

    def name(self, body):
        return self.model.body(body).name

    def poses(self):
        d = self.data
        return {self.name(b): (d.xpos[b].copy(), d.xquat[b].copy()) for b in range(1, self.model.nbody)}

    def joints(self):
        m, kinds = self.model, {3: "hinge", 2: "slide"}
        return {
            self.name(m.jnt_bodyid[j]): (kinds[int(m.jnt_type[j])], *m.jnt_range[j].tolist())
            for j in range(m.njnt)
            if int(m.jnt_type[j]) in kinds
        }

    def set_joint(self, name, value):
        body = next(b for b in range(self.model.nbody) if self.name(b) == name)
        self.data.qpos[self.model.jnt_qposadr[self.model.body_jntadr[body]]] = value
        mujoco.mj_forward(self.model, self.data)

    def step(self, seconds):
        mujoco.mj_resetData(self.model, self.data)
        mujoco.mj_step(self.model, self.data, round(seconds / self.model.opt.timestep))
        mujoco.mj_kinematics(self.model, self.data)
        if not np.isfinite(self.data.qpos).all() or any(w.number for w in self.data.warning):
            raise RuntimeError(f"warnings: {[w.number for w in self.data.warning]}")
