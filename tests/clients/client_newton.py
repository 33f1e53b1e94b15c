"""Newton: ``scene.xml``, stepped by its MuJoCo solver."""

from __future__ import annotations

import newton
import numpy as np
import warp as wp
from measure import Client

STEP = 0.004

wp.config.quiet = True


class Room(Client):
    """The room by MJCF."""

    @classmethod
    def version(cls):
        return newton.__version__

    def fill(self, builder, folder):
        builder.add_mjcf(f"{folder}/scene.xml")

    def __init__(self, folder):
        builder = newton.ModelBuilder()
        newton.solvers.SolverMuJoCo.register_custom_attributes(builder)
        self.fill(builder, folder)
        self.model = builder.finalize(device="cpu")
        self.names = [self.name(label) for label in builder.body_label]
        self.state = self.model.state()
        self.q = self.model.joint_q.numpy()
        self.forward()

    def name(self, label):
        """The last part of a path."""
        return label.rsplit("/", 1)[-1]

    def forward(self):
        self.model.joint_q.assign(self.q)
        newton.eval_fk(self.model, self.model.joint_q, self.model.joint_qd, self.state)

    def poses(self):
        rows = self.state.body_q.numpy().astype(float)
        return {name: (row[:3], np.roll(row[3:], 1)) for name, row in zip(self.names, rows, strict=True)}

    def hinges(self):
        """Number of the joint by name of its body, with what kind it is."""
        kinds = {int(newton.JointType.REVOLUTE): "hinge", int(newton.JointType.PRISMATIC): "slide"}
        types, child = self.model.joint_type.numpy(), self.model.joint_child.numpy()
        return {self.names[child[j]]: (j, kinds[int(t)]) for j, t in enumerate(types) if int(t) in kinds}

    def joints(self):
        start = self.model.joint_qd_start.numpy()
        low, high = self.model.joint_limit_lower.numpy(), self.model.joint_limit_upper.numpy()
        return {name: (kind, float(low[start[j]]), float(high[start[j]])) for name, (j, kind) in self.hinges().items()}

    def set_joint(self, name, value):
        self.q[self.model.joint_q_start.numpy()[self.hinges()[name][0]]] = value
        self.forward()

    def step(self, seconds):
        solver = newton.solvers.SolverMuJoCo(self.model, use_mujoco_cpu=True, nconmax=20000, njmax=60000)
        other, control = self.model.state(), self.model.control()
        for _ in range(round(seconds / STEP)):
            self.state.clear_forces()
            solver.step(self.state, other, control, None, STEP)
            self.state, other = other, self.state
