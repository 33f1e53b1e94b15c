"""PhysX by ovphysx: ``scene.usdc``, on a CPU."""

from __future__ import annotations

from importlib import metadata
from pathlib import Path

import numpy as np
import ovphysx
import ovstage
from measure import Client, usd_name
from ovphysx.types import SimObjectType, TensorType
from pxr import Usd

STEP = 1 / 60


def schemas():
    """Folders of the USD schemas that PhysX reads."""
    found = set()
    for name in ("physx-usd-schemas", "newton-usd-schemas"):
        files = metadata.distribution(name)
        found |= {str(Path(files.locate_file(f)).parent) for f in files.files if f.name == "generatedSchema.usda"}
    return sorted(found)


class Room(Client):
    """The stage as it is."""

    bodies_fixed = False
    rests_first = True

    @classmethod
    def version(cls):
        return metadata.version("ovphysx")

    def __init__(self, folder):
        ovphysx.PhysX.set_cpu_mode(True)
        self.physx = ovphysx.PhysX()
        ovstage.population.register_usd_schemas(schemas())
        self.stage = ovstage.Stage("room")
        domains = ovstage.PopulationDomain.ALL
        ovstage.population.open_usd(self.stage, f"{folder}/scene.usdc", ordinal=1, domains=domains)
        self.stage.advance_write_floor(ordinal=1).wait()
        self.physx.wait_task(self.physx.attach_ovstage(self.stage, read_ordinal=1))
        roots = sorted({path.rpartition("/")[0] for path in self.read(SimObjectType.ARTICULATION_LINK)})
        kinds = {"PhysicsRevoluteJoint": "hinge", "PhysicsPrismaticJoint": "slide"}
        layer = Usd.Stage.Open(f"{folder}/scene.usdc")
        joints = [prim for prim in layer.Traverse() if prim.GetTypeName() in kinds]
        self.kinds = {usd_name(str(p.GetPath()).replace("/joints/", "/")): kinds[p.GetTypeName()] for p in joints}
        self.hinges = {}
        for root in roots:
            position, limit = (
                self.physx.create_tensor_binding(prim_paths=[root], tensor_type=kind)
                for kind in (TensorType.ARTICULATION_DOF_POSITION, TensorType.ARTICULATION_DOF_LIMIT)
            )
            for k, name in enumerate(position.dof_names):
                self.hinges[usd_name(f"{root}/{name}")] = (position, limit, k)

    def read(self, kind):
        rows = {}
        with self.physx.read_sync(kind, ["position", "orientation"]) as result:
            for group in result.groups:
                if not group.tensors:
                    continue
                paths, values = result.dictionary.get_path_strings(group.prim_list), group.tensors[0].numpy()
                first, count = group.prim_offset, group.prim_count
                index = (
                    group.prim_index_map.numpy() if group.prim_index_map is not None else range(first, first + count)
                )
                what = result.dictionary.token_to_string(group.attribute)
                for k, value in zip(index, values, strict=False):
                    rows.setdefault(paths[int(k)], {})[what.rpartition(":")[2]] = np.array(value, dtype=float)
        return rows

    def poses(self):
        rows = self.read(SimObjectType.RIGID_BODY) | self.read(SimObjectType.ARTICULATION_LINK)
        found = {}
        for path, row in rows.items():
            at, turn = (next(v for k, v in row.items() if word in k.lower()) for word in ("position", "orient"))
            found[usd_name(path)] = (at, np.roll(turn, 1))
        return found

    def joints(self):
        found = {}
        for name, (_, limit, k) in self.hinges.items():
            values = np.zeros(limit.shape, np.float32)
            limit.read(values)
            found[name] = (self.kinds[name], *values[0, k].tolist())
        return found

    def set_joint(self, name, value):
        position, _, k = self.hinges[name]
        values = np.zeros(position.shape, np.float32)
        values[0, k] = value
        position.write(values)
        self.physx.update_articulations_kinematic()

    def step(self, seconds):
        for _ in range(round(seconds / STEP)):
            self.physx.step_sync(STEP)
