"""SAPIEN: the robots of ``scene.urdf.json``."""

import json
import re

import numpy as np
import sapien
from measure import Client

STEP = 1 / 200


class Room(Client):
    """An articulation a piece with doors, an actor for all else."""

    frames = "link"

    @classmethod
    def version(cls):
        return sapien.__version__

    def __init__(self, folder):
        scene = self.scene = sapien.Scene([sapien.physx.PhysxCpuSystem()])
        scene.set_timestep(STEP)
        with open(f"{folder}/scene.urdf.json", encoding="utf-8") as file:
            robots = json.load(file)["robots"]
        self.bodies, self.hinges = {}, {}
        for r in robots:
            loader = scene.create_urdf_loader()
            loader.fix_root_link = r["fixed"]
            loader.set_material(r["friction"], r["friction"], 0.0)
            articulations, actors = self.builders(loader, f"{folder}/{r['file']}")
            pose = sapien.Pose(r["position"], np.roll(r["quaternion"], 1))
            for builder in (*articulations, *actors):
                builder.initial_pose = pose
            for builder in actors:
                self.bodies[r["name"]] = builder.build_kinematic() if r["fixed"] else builder.build()
            for builder in articulations:
                made = builder.build(fix_root_link=r["fixed"])
                made.set_root_pose(pose)
                for link in made.links:
                    name = r["name"] if link.name == "base" else f"{r['name']}.{link.name}"
                    self.bodies[name] = link.entity
                for k, joint in enumerate(made.active_joints):
                    self.hinges[f"{r['name']}.{joint.child_link.name}"] = (made, k, joint)

    def builders(self, loader, path):
        """Of articulations and of actors; without what is seen where nothing can draw it."""
        try:
            return loader.parse(path)[:2]
        except RuntimeError:
            with open(path, encoding="utf-8") as file:
                robot = re.sub(r"<visual>.*?</visual>|<material.*?</material>", "", file.read(), flags=re.DOTALL)
            return loader._parse_urdf(robot)[:2]

    def poses(self):
        return {name: (entity.pose.p, entity.pose.q) for name, entity in self.bodies.items()}

    def joints(self):
        found = {}
        for name, (_, _, joint) in self.hinges.items():
            kind = "slide" if joint.type == "prismatic" else "hinge"
            found[name] = (kind, *joint.limits[0].tolist())
        return found

    def set_joint(self, name, value):
        made, k, _ = self.hinges[name]
        qpos = made.qpos
        qpos[k] = value
        made.set_qpos(qpos)

    def step(self, seconds):
        for _ in range(round(seconds / STEP)):
            self.scene.step()
