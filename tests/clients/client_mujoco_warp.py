"""MuJoCo Warp: ``scene.xml``, one world on the GPU where there is one."""

import client_mujoco
import mujoco
import mujoco_warp as mjw
import numpy as np
import warp as wp

wp.config.quiet = True

_SPARE = 2
"""Times the contacts and constraints at the start, that there is room for."""


class Room(client_mujoco.Room):
    """The room, stepped by MuJoCo Warp; compiling and the first step are no part of the time at rest."""

    @classmethod
    def version(cls):
        return mjw.__version__

    def __init__(self, folder):
        super().__init__(folder)
        model, data = self.model, self.data
        self.warp = mjw.put_model(model)
        contacts, rows = _SPARE * data.ncon + 1000, _SPARE * data.nefc + 2000
        self.room = mjw.put_data(model, data, nworld=1, nconmax=contacts, njmax=rows)
        self.start = [mjw.put_data(model, data, nworld=1, nconmax=contacts, njmax=rows) for _ in range(2)]
        mjw.step(self.warp, self.start[0])
        wp.synchronize()
        self.graph = None
        if wp.get_device().is_cuda:
            with wp.ScopedCapture() as capture:
                mjw.step(self.warp, self.room)
            self.graph = capture.graph

    def step(self, seconds):
        for name in ("qpos", "qvel", "qacc_warmstart", "time"):
            wp.copy(getattr(self.room, name), getattr(self.start[1], name))
        for _ in range(round(seconds / self.model.opt.timestep)):
            if self.graph is None:
                mjw.step(self.warp, self.room)
            else:
                wp.capture_launch(self.graph)
        wp.synchronize()
        self.data.qpos[:] = self.room.qpos.numpy()[0]
        mujoco.mj_kinematics(self.model, self.data)
        if not np.isfinite(self.data.qpos).all():
            raise RuntimeError("positions are not finite")
