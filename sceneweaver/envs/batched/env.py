"""Many worlds with different rooms and the same robot as one vector environment."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Literal

import numpy as np
import warp as wp

from sceneweaver.envs.control import LEAD
from sceneweaver.envs.env import PERIOD
from sceneweaver.envs.joining import PREFIX, indices_of
from sceneweaver.envs.robots import Robot, robot_named
from sceneweaver.envs.tasks import KINDS
from sceneweaver.physics.batch import device_named
from sceneweaver.runtime.package import missing_extra
from sceneweaver.scene import InputError, MissingDependencyError, Scene

from . import reset_kernels, task_kernels
from .bank import Bank
from .physics import FIELDS, ThreadPhysics, WarpPhysics, kind_of
from .structs import Episodes, Goal, Layouts, Observations, RobotArrays, Simulation, filled
from .template import FIRST, template_of

try:
    import gymnasium
    from gymnasium.vector import AutoresetMode, VectorEnv
except ImportError:
    raise MissingDependencyError(missing_extra("envs", "gymnasium is not installed")) from None

Backend = Literal["c", "warp"]

_TRIED = 16  # worlds whose contacts are counted to find out how much room is needed


class BatchedRoomEnv(VectorEnv):
    """W worlds, each with a room of its own, stepped at once.

    Worlds take layouts of a `Bank`, another at each episode. All worlds are one model of MuJoCo Warp on a GPU, and one
    of MuJoCo C in threads elsewhere; observations, rewards and resets are kernels on the same device. Actions are those
    of `sceneweaver.envs.Controller` with "joint". An episode that ended begins anew in the next step, whose action
    counts for nothing (Gymnasium's ``AutoresetMode.NEXT_STEP``).

    Observations are a dict of float32 arrays [W, n]: ``robot`` [2 D] positions and velocities of the driven joints,
    ``base`` [3] x, y, yaw, ``tool`` [7], ``gripper`` [1] how far it is open, ``subject`` [7] the pose of what the task
    is about, ``goal`` [3] where it, or the base, is to go, ``objects`` [F, 7] free bodies, ``doors`` [L] positions of
    doors and drawers, ``task`` [6] which kind of task it is. Poses are position [m] and quaternion (w, x, y, z).

    Args:
        bank: Rooms and layouts, or scenes.
        num_envs: W.
        robot: "mobile" or a `Robot` that drives; the one that the bank was made for.
        device: "auto" (the first GPU, else the CPU), "cpu", "cuda:0" ...
        backend: "warp" or "c"; None: MuJoCo Warp on a GPU, MuJoCo C on a CPU.
        seed: Of all that is random.
        max_steps: After which an episode is cut off.
        contacts, rows: Room for contacts of a world on average and for constraint rows of a world; None: by a trial.
        threads: Of MuJoCo C; None: as many as there are cores.

    Raises:
        InputError: something of this is wrong.
    """

    metadata = {"autoreset_mode": AutoresetMode.NEXT_STEP, "render_modes": []}

    # Options of an environment are keyword arguments, as those of `RoomEnv`, hence more than ten.
    def __init__(
        self,
        bank: Bank | Sequence[Scene],
        num_envs: int,
        *,
        robot: str | Robot = "mobile",
        device: str = "auto",
        backend: Backend | None = None,
        seed: int = 0,
        max_steps: int = 500,
        contacts: int | None = None,
        rows: int | None = None,
        threads: int | None = None,
    ) -> None:
        """Build the shared model and put the bank on the device."""
        if num_envs < 1:
            raise InputError(f"num_envs: {num_envs} is none; give 1 or more")
        self.robot = robot_named(robot)
        if len(self.robot.base) != 3:
            raise InputError(f"robot: {self.robot.name} has no base that drives; use mobile")
        self.bank = bank if isinstance(bank, Bank) else Bank.of(bank, robot=self.robot)
        self.device = device_named(device)
        kind = backend or ("c" if self.device == "cpu" else "warp")
        if kind not in ("c", "warp") or (kind == "c" and self.device != "cpu"):
            raise InputError(f'backend: "{kind}" is not for {self.device}; use warp, or c on a CPU')
        slots = self.bank.slots
        self.num_envs, self.max_steps, self._seed = num_envs, max_steps, seed
        self.template = template_of(slots, self.robot)
        self._find = indices_of(self.template, self.robot)
        self._substeps = max(round(PERIOD / self.template.opt.timestep), 1)
        with wp.ScopedDevice(self.device):
            self._put_bank()
            self._make_buffers()
        if kind == "c":
            self.physics: WarpPhysics | ThreadPhysics = ThreadPhysics(self.template, num_envs, threads)
        else:
            if contacts is None or rows is None:
                contacts, rows = self._room(contacts, rows)
            self.physics = WarpPhysics(self.template, num_envs, contacts, rows, self.device)
        names = ("qpos", "qvel", "ctrl", "xpos", "xquat", "site_xpos", "site_xmat")
        self._sim = filled(Simulation, **{name: getattr(self.physics.data, name) for name in names})
        self._graph: Any = None
        self._spaces()

    def reset(
        self, *, seed: int | None = None, options: Mapping[str, Any] | None = None
    ) -> tuple[dict[str, np.ndarray], dict[str, Any]]:
        """Begin an episode in every world.

        Args:
            seed: Of all that is random from now on; None: go on as before.
            options: ``layout``: numbers [W] of layouts of the bank, -1 for any, for these episodes and those after.
        """
        wanted = np.full(self.num_envs, -1) if options is None else np.asarray(options.get("layout", -1))
        wanted = np.broadcast_to(wanted, (self.num_envs,)).astype(np.int32)
        if (wanted >= self.bank.layouts).any():
            raise InputError(f"layout: {int(wanted.max())} is not there; the bank has {self.bank.layouts}")
        with wp.ScopedDevice(self.device):
            self._episodes.wanted.assign(wanted)
            if seed is not None:
                self._seed = seed
                self._episodes.number.zero_()
                self._graph = None  # the seed is an argument of its launches
            self._episodes.done.fill_(1)
            self._begin()
            self._look()
        return self._numpy(self.observations), self.info()

    def step(self, actions: Any) -> tuple[dict[str, np.ndarray], np.ndarray, np.ndarray, np.ndarray, dict[str, Any]]:
        """One action [W, A] in every world; NumPy in and out. See `step_device` for what stays on the device."""
        given = np.asarray(actions, dtype=np.float32)
        if given.shape != self.action.shape:
            raise InputError(f"actions: shape {given.shape}; give {self.action.shape}")
        self.action.assign(given)
        self.step_device()
        rewards, terminated, truncated = (a.numpy().copy() for a in (self.rewards, self.terminated, self.truncated))
        return self._numpy(self.observations), rewards, terminated, truncated, self.info()

    def step_device(self, actions: Any = None) -> None:
        """One action in every world, without a copy to the host.

        What comes of it stands in ``observations`` (by name), ``rewards``, ``terminated`` and ``truncated``, which are
        the same Warp arrays at every step; ``wp.to_torch`` and ``wp.to_jax`` show them to others without a copy.

        Args:
            actions: [W, A] on the device: a Warp array, or whatever has ``__cuda_array_interface__`` or
                ``__array_interface__``; None: what stands in ``action``.
        """
        if actions is not None and actions is not self.action:
            wp.copy(self.action, actions if isinstance(actions, wp.array) else wp.array(actions, copy=False))
        with wp.ScopedDevice(self.device):
            if self._graph is None:
                self._advance()
                if wp.get_device(self.device).is_cuda:
                    with wp.ScopedCapture() as capture:
                        self._advance()
                    self._graph = capture.graph
            else:
                wp.capture_launch(self._graph)

    def info(self) -> dict[str, Any]:
        """By world: numbers of layout, room and goal of the bank, the instruction, how many boxes were left out."""
        layout: np.ndarray = self._episodes.layout.numpy().copy()
        goal: np.ndarray = self._episodes.goal.numpy().copy()
        room = self.bank.layout["room"][layout]
        words = np.array([self.bank.instructions[r][g] for r, g in zip(room, goal, strict=True)], dtype=object)
        dropped = np.array(self.bank.dropped)[room]
        return {"layout": layout, "room": room, "goal": goal, "instruction": words, "dropped": dropped}

    def overflow(self) -> np.ndarray:
        """[W] worlds that ever had too little room for their contacts: nothing can be said of them."""
        return self.physics.overflow()

    def close_extras(self, **kwargs: Any) -> None:
        """Nothing is open."""

    def _advance(self) -> None:
        inputs = [PERIOD, LEAD, self._robot, self.action]
        wp.launch(task_kernels.apply_actions, dim=self.num_envs, inputs=inputs, outputs=[self._sim], device=self.device)
        self.physics.step(self._substeps)
        self._begin()
        self._look()

    def _begin(self) -> None:
        """Begin episodes in worlds that are done."""
        slots, worlds, episodes = self.bank.slots, self.num_envs, self._episodes
        model, data, k = self.physics.model, self.physics.data, reset_kernels
        wp.launch(
            k.begin_episodes, dim=worlds, inputs=[self._seed, self._layouts], outputs=[episodes], device=self.device
        )
        for name in FIELDS:
            if name in self._bank:
                first = FIRST.get(name.partition("_")[0], 0)
                self._copy(name, episodes.room, getattr(model, name), first)
        # Boxes that stand still have their places by layout, after those of the room were written to all.
        for kind, what in (("geom", "still"), ("body", "link")):
            for part in ("pos", "quat"):
                self._copy(f"{what}_{part}", episodes.layout, getattr(model, f"{kind}_{part}"), FIRST[kind])
        wp.launch(
            k.bound_boxes,
            dim=(worlds, slots.geoms),
            inputs=[FIRST["geom"], slots.still, episodes.fresh, model.geom_size, model.geom_pos, model.geom_quat],
            outputs=[model.geom_rbound, model.geom_aabb, data.geom_xpos, data.geom_xmat],
            device=self.device,
        )
        rest = [data.qvel, data.qacc_warmstart]
        wp.launch(k.stop, dim=(worlds, self.template.nv), inputs=[episodes.fresh], outputs=rest, device=self.device)
        inputs = [self._robot, self._layouts, episodes]
        wp.launch(
            k.reset_positions, dim=(worlds, self.template.nq), inputs=inputs, outputs=[self._sim], device=self.device
        )
        inputs = [self._robot, episodes]
        wp.launch(
            k.reset_controls, dim=(worlds, self.template.nu), inputs=inputs, outputs=[self._sim], device=self.device
        )
        self.physics.refresh(episodes.fresh)

    def _copy(self, name: str, row: wp.array, out: Any, first: int) -> None:
        """Copy a field of the bank into the model of worlds that begin."""
        source = self._bank[name]
        inputs = [first, source, self._episodes.fresh, row]
        wp.launch(
            reset_kernels.copy_rows,
            dim=(self.num_envs, source.shape[1]),
            inputs=inputs,
            outputs=[out],
            device=self.device,
        )

    def _look(self) -> None:
        """Judge the tasks and write observations."""
        wp.launch(
            task_kernels.judge,
            dim=self.num_envs,
            inputs=[self.max_steps, self._robot, self._layouts, self._sim, self._episodes],
            outputs=[self.rewards, self.terminated, self.truncated, self._seen],
            device=self.device,
        )
        inputs = [self._robot, self._layouts, self._episodes, self._sim]
        wp.launch(task_kernels.observe, dim=self.num_envs, inputs=inputs, outputs=[self._seen], device=self.device)

    def _put_bank(self) -> None:
        """The bank on the device: fields by name, and its layouts for kernels."""
        self._bank: dict[str, Any] = {}
        for name, values in (self.bank.room | self.bank.layout).items():
            kind = Goal if name == "goals" else kind_of(name) or wp.dtype_from_numpy(values.dtype)
            self._bank[name] = wp.array(np.ascontiguousarray(values), dtype=kind)
        used = wp.array(np.array([[bool(n) for n in row] for row in self.bank.names], dtype=np.int32))
        shared = ("room", "goals", "goal_count", "free_pose", "spawns")
        self._layouts = filled(Layouts, used=used, **{name: self._bank[name] for name in shared})

    def _make_buffers(self) -> None:
        """The robot, episodes, actions and observations on the device."""
        worlds, model, find, slots = self.num_envs, self.template, self._find, self.bank.slots
        home = np.array(model.qpos0)
        for joint, value in self.robot.home.items():
            home[model.joint(PREFIX + joint).qposadr[0]] = value
        home[find.finger_position] = model.actuator_ctrlrange[find.fingers, 1]  # the hand begins open
        span = np.where(model.actuator_ctrllimited[:, None].astype(bool), model.actuator_ctrlrange, [-1e9, 1e9])
        numbers = ("drive", "drive_position", "drive_dof", "fingers", "finger_position")
        self._robot = filled(
            RobotArrays,
            base=wp.vec3i(*find.base.tolist()),
            tool=find.tool,
            speeds=wp.array(find.speeds, dtype=float),
            ctrl_range=wp.array(span, dtype=wp.vec2),
            position=wp.array(model.jnt_qposadr[model.actuator_trnid[:, 0]], dtype=int),
            home=wp.array(home[slots.links + 7 * len(slots.free) :], dtype=float),
            **{name: wp.array(getattr(find, name), dtype=int) for name in numbers},
        )
        counts = ("wanted", "done", "fresh", "number", "layout", "room", "goal", "steps")
        self._episodes = filled(
            Episodes,
            start_goal=wp.zeros(worlds, dtype=wp.vec3),
            **{name: wp.zeros(worlds, dtype=int) for name in counts},
            **{name: wp.zeros(worlds, dtype=float) for name in ("draw", "potential", "start_height")},
        )
        self._episodes.wanted.fill_(-1)
        self.rewards = wp.zeros(worlds, dtype=float)
        self.terminated, self.truncated = wp.zeros(worlds, dtype=bool), wp.zeros(worlds, dtype=bool)
        self.action = wp.zeros((worlds, len(find.drive) + bool(len(find.fingers))), dtype=float)
        shapes = {"robot": (2 * len(find.drive),), "base": (3,), "tool": (7,), "gripper": (1,), "subject": (7,)}
        shapes |= {"goal": (3,), "objects": (len(slots.free), 7), "doors": (slots.links,), "task": (len(KINDS),)}
        self.observations = {name: wp.zeros((worlds, *shape), dtype=float) for name, shape in shapes.items()}
        self._seen = filled(Observations, **self.observations)

    def _spaces(self) -> None:
        box = gymnasium.spaces.Box
        one: dict[str, Any] = {n: box(-np.inf, np.inf, a.shape[1:], np.float32) for n, a in self.observations.items()}
        self.single_observation_space = gymnasium.spaces.Dict(one)
        self.single_action_space = box(-1.0, 1.0, self.action.shape[1:], np.float32)
        batch = gymnasium.vector.utils.batch_space
        self.observation_space = batch(self.single_observation_space, self.num_envs)
        self.action_space = batch(self.single_action_space, self.num_envs)

    def _room(self, contacts: int | None, rows: int | None) -> tuple[int, int]:
        """Room for contacts and rows, from some worlds stepped by MuJoCo C: twice what they need."""
        tried = min(_TRIED, self.bank.layouts)
        trial = BatchedRoomEnv(self.bank, tried, robot=self.robot, device="cpu", backend="c")
        trial.reset(options={"layout": np.linspace(0, self.bank.layouts - 1, tried).astype(int)})
        trial.step_device()
        load = trial.physics.load()
        return contacts or 2 * load["contacts"] // tried + 64, rows or 2 * load["rows"] + 64

    @staticmethod
    def _numpy(arrays: dict[str, wp.array]) -> dict[str, np.ndarray]:
        return {name: array.numpy().copy() for name, array in arrays.items()}
