"""What is hollow holds: balls put into every interior of an asset, with the collision parts that simulators get.

``python -m tests.assets.insides [CATEGORY ...] [--seeds N]`` prints what does not hold, and containers without room.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from importlib import import_module
from typing import Any

import numpy as np

from sceneweaver.assets import Asset, make
from sceneweaver.assets.body import Interior
from sceneweaver.assets.category import categories
from sceneweaver.assets.parametric import makers
from sceneweaver.physics import build
from sceneweaver.scene import Pose, Room, Scene

mujoco: Any = import_module("mujoco")

ROOM = Room(outline=((-5, -5), (5, -5), (5, 5), (-5, 5)), height=4)
RADIUS = 0.02
"""Of the largest ball [m]."""
FALL = 0.4
"""How far it falls at most [m]: at 4 ms a step, what falls farther goes through thin floors."""
LEAST = 0.003
"""Of the smallest [m]."""
SLACK = 0.01
"""How far the ball's middle may lie outside the box of the interior [m]."""

CONTAINERS = frozenset(
    """
    mug cup_and_saucer drinking_glass wine_glass champagne_flute bowl mixing_bowl pot saucepan frying_pan vase
    decorative_tray utensil_holder bucket mop_bucket measuring_cup beaker
    pitcher serving_tray basket plastic_bin wooden_crate shopping_basket laundry_cart trash_can pedal_bin
    recycling_bin jewelry_box music_box colander
    laundry_hamper fridge side_by_side_fridge freezer minibar stove oven_tower microwave dishwasher
    washing_machine dryer wardrobe dresser tallboy sideboard cabinet linen_cabinet filing_cabinet
    locker safe bar_cabinet nightstand tv_stand kitchen_cabinet kitchen_counter
    corner_cabinet wall_cabinet tall_cabinet sink_cabinet kitchen_island kitchen_cart vanity double_vanity
    medicine_cabinet medical_cabinet teacher_desk secretary_desk dressing_table lab_bench
    tool_chest tool_cabinet storage_bed bathtub freestanding_bathtub wall_basin pedestal_sink laundry_sink
    ice_machine cash_register
    """.split()  # noqa: SIM905
)
"""Categories that a person would put things into."""


@dataclass
class Trial:
    """An asset that stands still in an empty room of MuJoCo, with a ball."""

    asset: Asset
    model: Any
    data: Any

    @classmethod
    def of(cls, asset: Asset) -> Trial:
        """The model, as `physics.build` makes it."""
        thing = asset.object("o", pose=Pose.from_yaw(0, 0, 0.5, 0.0), mount="floor").model_copy(update={"fixed": True})
        made = build(Scene(id="s", room=ROOM, objects=(thing,)), {asset.id: asset}.__getitem__)
        ball = (
            '<body name="ball"><freejoint name="ball"/><geom name="ball" type="sphere" size="0.02" mass="0.02"/></body>'
        )
        text = made.xml.replace("</worldbody>", f"{ball}</worldbody>")
        model = mujoco.MjModel.from_xml_string(text, made.files)
        return cls(asset, model, mujoco.MjData(model))

    def _radius(self, radius: float) -> None:
        geom = self.model.geom("ball").id
        self.model.geom_size[geom, 0] = self.model.geom_rbound[geom] = radius
        self.model.geom_aabb[geom, 3:] = radius

    def _open(self, room: Interior) -> None:
        """All doors and lids open, drawers closed, what can be taken far away."""
        mujoco.mj_resetData(self.model, self.data)
        for number, link in enumerate(self.asset.links, start=1):
            names = [self.model.joint(j).name for j in range(self.model.njnt)]
            if f"o.{link.name}" not in names:
                continue
            at = self.model.joint(f"o.{link.name}").qposadr[0]
            if link.joint == "free":
                self.data.qpos[at] += 3.0 + 0.2 * number
            elif link.role in ("door", "lid") and number != room.link:
                self.data.qpos[at] = max(link.limits, key=abs)

    @property
    def _ball(self) -> np.ndarray:
        at = self.model.joint("ball").qposadr[0]
        return self.data.qpos[at : at + 3]

    def _inside(self, room: Interior, shift: np.ndarray) -> bool:
        point = self._ball - np.array([0, 0, 0.5]) - shift
        return bool((point > np.array(room.low) - SLACK).all() and (point < np.array(room.high) + SLACK).all())

    def _touch(self) -> float:
        """How deep the ball is in something [m]."""
        mujoco.mj_forward(self.model, self.data)
        ball = self.model.geom("ball").id
        return max([-float(c.dist) for c in self.data.contact[: self.data.ncon] if ball in c.geom], default=0.0)

    def hold(self, room: Interior) -> str:
        """What goes wrong with a ball in an interior; empty when it stays."""
        low, high = np.array(room.low), np.array(room.high)
        size, entry = high - low, np.array(room.entry)
        link = self.asset.links[room.link - 1] if room.link else None
        if link is not None and link.joint != "slide":
            return ""
        self._open(room)
        at = (low + high) / 2
        travel, shift = 0.0, np.zeros(3)
        if link is not None:
            travel = 0.7 * max(link.limits, key=abs)
            shift = travel * np.array(link.axis)
            out = int(np.argmax(np.abs(link.axis)))
            side = 1.0 if link.axis[out] * travel > 0 else -1.0
            free = min(abs(travel), size[out])
            size[out] = free
            at[out] = (high[out] if side > 0 else low[out]) - side * free / 2
        across = [k for k in range(3) if abs(entry[k]) < 0.5]
        radius = min(RADIUS, 0.35 * min(size[k] for k in across), 0.45 * max(size))
        if radius < LEAST:
            return f"{room.name}: no room for a ball"
        self._radius(radius)
        joint = self.model.joint("ball")
        if link is not None:
            self.data.qpos[self.model.joint(f"o.{link.name}").qposadr[0]] = travel
        axis = int(np.argmax(np.abs(entry)))
        far = high[axis] if entry[axis] > 0 else low[axis]
        place = int(joint.qposadr[0])
        blocked = []
        for way in self._ways(room, at, size, far, axis, radius):
            for step in way:
                self.data.qpos[place : place + 3] = step + shift + [0, 0, 0.5]
                if (deep := self._touch()) > 1e-3:
                    blocked.append(deep)
                    break
            else:
                break
        else:
            return f"{room.name}: closed ({1e3 * min(blocked):.0f} mm in the way)"
        self.data.qvel[:] = 0.0
        self._run(2.0, link, travel, travel)
        if not self._inside(room, shift):
            return f"{room.name}: falls out, to {np.round(self._ball - shift - [0, 0, 0.5], 3).tolist()}"
        if link is not None:
            self._run(1.0, link, travel, 0.0)
            if not self._inside(room, 0 * shift):
                return f"{room.name}: lost as it closes, at {np.round(self._ball - [0, 0, 0.5], 3).tolist()}"
            self._run(1.0, link, 0.0, travel)
            if not self._inside(room, shift):
                return (
                    f"{room.name}: lost as it opens again, at {np.round(self._ball - shift - [0, 0, 0.5], 3).tolist()}"
                )
        return ""

    @staticmethod
    def _ways(
        room: Interior, at: np.ndarray, size: np.ndarray, far: float, axis: int, radius: float
    ) -> list[np.ndarray]:
        """Ways [N, 3] for the ball's middle into an interior, through its middle first."""
        low, entry = np.array(room.low), np.array(room.entry)
        ways = []
        if axis == 2:
            for u, v in ((0.0, 0.0), (0.25, 0.0), (-0.25, 0.0), (0.0, 0.25), (0.0, -0.25)):
                heights = np.linspace(far + radius + 0.01, min(far + radius + 0.01, low[2] + FALL), 6)
                ways.append(np.array([[at[0] + u * size[0], at[1] + v * size[1], z] for z in heights]))
            return ways
        other = 1 - axis
        for high in (radius + 0.005, radius + 0.06, 0.5 * size[2], 0.8 * size[2]):
            for side in (0.0, 0.25, -0.25, 0.4, -0.4):
                if not radius < high < size[2] - radius:
                    continue
                start = at.copy()
                start[2], start[other] = low[2] + high, at[other] + side * size[other]
                start[axis] = far + entry[axis] * radius
                ways.append(start - np.linspace(0, 0.6 * size[axis], 12)[:, None] * entry)
        return ways

    def _run(self, seconds: float, link: Any, start: float, end: float) -> None:
        """Step on, with the drawer moved from one place to another by hand; the rest is held."""
        mine = self.model.joint("ball")
        held = [k for k in range(self.model.nq) if not mine.qposadr[0] <= k < mine.qposadr[0] + 7]
        hold = [k for k in range(self.model.nv) if not mine.dofadr[0] <= k < mine.dofadr[0] + 6]
        fixed = self.data.qpos[held].copy()
        count = round(seconds / self.model.opt.timestep)
        for k in range(count):
            self.data.qpos[held], self.data.qvel[hold] = fixed, 0.0
            if link is not None:
                at = self.model.joint(f"o.{link.name}")
                self.data.qpos[at.qposadr[0]] = start + (end - start) * (k + 1) / count
                self.data.qvel[at.dofadr[0]] = (end - start) / seconds
            mujoco.mj_step(self.model, self.data)


def faults(asset: Asset) -> list[str]:
    """What is wrong with the insides of an asset."""
    if not asset.interiors:
        return ["no interior"] if asset.category in CONTAINERS else []
    trial = Trial.of(asset)
    return [fault for room in asset.interiors if (fault := trial.hold(room))]


def main() -> int:
    """Try categories and print what does not hold."""
    parser = argparse.ArgumentParser(description=main.__doc__)
    parser.add_argument("categories", nargs="*")
    parser.add_argument("--seeds", type=int, default=1)
    options = parser.parse_args()
    tried = bad = 0
    for name in options.categories or sorted(makers()):
        if categories()[name].size is None:
            continue
        for seed in range(options.seeds):
            asset = make(name, seed)
            found = faults(asset)
            tried += len(asset.interiors)
            bad += len(found)
            for fault in found:
                print(f"{name} seed {seed}: {fault}", flush=True)
    print(f"{tried} interiors, {bad} faults")
    return 1 if bad else 0


if __name__ == "__main__":
    raise SystemExit(main())
