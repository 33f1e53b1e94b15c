"""The simulation of all worlds: by MuJoCo Warp in one launch, or by MuJoCo C on the cores of this machine.

Both have the same arrays for kernels: fields of the model that differ by world, and the state. MuJoCo Warp steps these
arrays themselves; for MuJoCo C they are copied to a model and a state of each world and back.
"""

from __future__ import annotations

from copy import copy
from importlib import import_module
from types import SimpleNamespace
from typing import Any

import numpy as np
import warp as wp

from sceneweaver.runtime.compiling import start_warp
from sceneweaver.runtime.mujoco_module import load_mujoco
from sceneweaver.runtime.threads import cores, map_threads

from .bank import UNUSED

FIELDS = (*UNUSED, "geom_aabb", "geom_rbound", "body_pos", "body_quat")
"""Fields of the model that differ by world."""

STATE = ("qpos", "qvel", "qacc_warmstart", "ctrl", "xpos", "xquat", "geom_xpos", "geom_xmat", "site_xpos", "site_xmat")
"""What kernels read and write of the state."""

_VECTORS = {"quat": wp.quat, "pos": wp.vec3, "size": wp.vec3, "aabb": wp.vec3, "axis": wp.vec3, "inertia": wp.vec3}
_VECTORS |= {"friction": wp.vec3, "body_invweight0": wp.vec2, "range": wp.vec2, "xmat": wp.mat33}


class WarpPhysics:
    """Worlds in one launch of MuJoCo Warp.

    Args:
        template: The MjModel.
        worlds: W.
        contacts: Room for contacts (and pairs of boxes that are near) of a world, on average.
        rows: Room for constraint rows of a world.
        device: A Warp device.
    """

    def __init__(self, template: Any, worlds: int, contacts: int, rows: int, device: str) -> None:
        """Make room on the device."""
        start_warp()
        self._mjw: Any = import_module("mujoco_warp")
        self.device = device
        with wp.ScopedDevice(device):
            self.model = self._mjw.put_model(template, batch_sizes=dict.fromkeys(FIELDS, worlds))
            self.model.opt.warn_overflow = 0  # it would print; we report
            most = contacts * worlds  # two boxes that touch mostly do so in four points
            self.data = self._mjw.make_data(template, nworld=worlds, naconmax=most, naccdmax=most // 2, njmax=rows)

    def step(self, count: int) -> None:
        """So many steps."""
        for _ in range(count):
            self._mjw.step(self.model, self.data)

    def refresh(self, fresh: wp.array) -> None:
        """Where everything is by ``qpos``; ``fresh`` [W] worlds have other models and states than before."""
        del fresh  # all arrays are its own
        self._mjw.kinematics(self.model, self.data)

    def overflow(self) -> np.ndarray:
        """[W] worlds that ever had no room for all their contacts or rows."""
        return self.data.overflow.numpy() != 0

    def load(self) -> dict[str, int]:
        """Contacts and near pairs of all worlds, and the most constraint rows of a world, at the last step."""
        data = self.data
        return {
            "contacts": int(data.nacon.numpy()[0]),
            "near": int(data.ncollision.numpy()[0]),
            "rows": int(data.nefc.numpy().max()),
        }


class ThreadPhysics:
    """Worlds stepped by MuJoCo C, a share of them on each thread; for machines without a GPU.

    Args:
        template: The MjModel.
        worlds: W.
        threads: None: as many as there are cores.
    """

    device = "cpu"

    def __init__(self, template: Any, worlds: int, threads: int | None = None) -> None:
        """A model and a state for each world."""
        mujoco = load_mujoco()
        self._mujoco = mujoco
        self._models = [copy(template) for _ in range(worlds)]
        for model in self._models:  # boxes of a slot differ by world, so that no tree of bounds within a body is true
            model.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_MIDPHASE)
        self._states = [mujoco.MjData(model) for model in self._models]
        self.model = SimpleNamespace(**{name: _array(name, getattr(template, name), worlds) for name in FIELDS})
        state = mujoco.MjData(template)
        mujoco.mj_kinematics(template, state)
        self.data = SimpleNamespace(**{name: _array(name, getattr(state, name), worlds) for name in STATE})
        self._parts = [part for part in np.array_split(np.arange(worlds), threads or cores()) if len(part)]
        self._full = np.zeros(worlds, dtype=bool)

    def step(self, count: int) -> None:
        """So many steps."""
        control, kinds = self.data.ctrl.numpy(), self._mujoco.mjtWarning
        full = int(kinds.mjWARN_CONTACTFULL), int(kinds.mjWARN_CNSTRFULL)
        bad = int(kinds.mjWARN_BADQPOS), int(kinds.mjWARN_BADQVEL), int(kinds.mjWARN_BADQACC)
        astray = np.zeros(len(self._states), dtype=bool)

        def run(worlds: np.ndarray) -> None:
            for k in worlds:
                state = self._states[k]
                state.ctrl[:] = control[k]
                self._mujoco.mj_step(self._models[k], state, count)
                self._full[k] |= any(state.warning[kind].number for kind in full)
                astray[k] = any(state.warning[kind].number for kind in bad)

        map_threads(run, self._parts, len(self._parts))
        for name in ("qpos", "qvel", "qacc_warmstart"):
            self._read(name)
        self.data.qpos.numpy()[astray] = np.nan  # MuJoCo begins anew after such a warning, and numbers look well

    def refresh(self, fresh: wp.array) -> None:
        """Where everything is by ``qpos``; ``fresh`` [W] worlds have other models and states than before."""
        for k in np.flatnonzero(fresh.numpy()):
            model, state = self._models[k], self._states[k]
            for name in FIELDS:
                field = getattr(model, name)
                field[:] = getattr(self.model, name).numpy()[k].reshape(field.shape)
            _bound(model)
            self._mujoco.mj_resetData(model, state)
            state.qpos[:], state.ctrl[:] = self.data.qpos.numpy()[k], self.data.ctrl.numpy()[k]
        for model, state in zip(self._models, self._states, strict=True):
            self._mujoco.mj_kinematics(model, state)
        for name in ("xpos", "xquat", "geom_xpos", "geom_xmat", "site_xpos", "site_xmat"):
            self._read(name)

    def overflow(self) -> np.ndarray:
        """[W] worlds that ever had no room for all their contacts or rows."""
        return self._full

    def load(self) -> dict[str, int]:
        """Contacts of all worlds, and the most constraint rows of a world, at the last step."""
        contacts = sum(int(state.ncon) for state in self._states)
        return {"contacts": contacts, "near": contacts, "rows": max(int(state.nefc) for state in self._states)}

    def _read(self, name: str) -> None:
        into = getattr(self.data, name).numpy()
        for k, state in enumerate(self._states):
            into[k] = getattr(state, name).reshape(into[k].shape)


def _bound(model: Any) -> None:
    """Make the bounds of bodies, by which MuJoCo C finds pairs, those of their geoms as they are now."""
    reach = np.linalg.norm(model.geom_pos - model.body_ipos[model.geom_bodyid], axis=1) + model.geom_rbound
    most = np.zeros(model.nbody)
    np.maximum.at(most, model.geom_bodyid, reach)
    most[0] = 1e4  # the world, with the floor
    root = model.body_bvhadr[model.body_bvhadr >= 0]
    model.bvh_aabb[root, :3], model.bvh_aabb[root, 3:] = 0.0, most[model.body_bvhadr >= 0, None]


def kind_of(name: str) -> Any:
    """The type of the vectors in a field, as MuJoCo Warp has it; None: it holds numbers."""
    return next((kind for end, kind in _VECTORS.items() if name.endswith(end) and name != "qpos"), None)


def _array(name: str, values: np.ndarray, worlds: int) -> wp.array:
    """An array [W, ...] on the CPU of the type that MuJoCo Warp gives it, with equal rows."""
    kind: Any = kind_of(name) or float
    shape = tuple(getattr(kind, "_shape_", ()))
    rows = np.asarray(values, dtype=np.float32)
    rows = rows.reshape(*rows.shape[:1], *((2,) if name == "geom_aabb" else ()), *shape)
    return wp.array(np.tile(rows, (worlds, *[1] * rows.ndim)), dtype=kind, device="cpu")
