"""PyBullet: the robots of ``scene.urdf.json``."""

import json
from importlib.metadata import version

import numpy as np
import pybullet as p
from measure import Client

STEP = 1 / 240


class Room(Client):
    """One body a robot."""

    frames = "link"

    @classmethod
    def version(cls):
        return version("pybullet")

    def __init__(self, folder):
        p.connect(p.DIRECT)
        p.setGravity(0, 0, -9.81)
        p.setPhysicsEngineParameter(fixedTimeStep=STEP, numSolverIterations=100)
        self.bodies = self.load(folder)
        self.links()

    def load(self, folder):
        """Numbers of bodies by name."""
        with open(f"{folder}/scene.urdf.json", encoding="utf-8") as file:
            robots = json.load(file)["robots"]
        flags = p.URDF_USE_INERTIA_FROM_FILE
        return {
            r["name"]: p.loadURDF(
                f"{folder}/{r['file']}", r["position"], r["quaternion"], useFixedBase=r["fixed"], flags=flags
            )
            for r in robots
        }

    def links(self):
        """Numbers of body and joint by the name of what hangs on it; motors that Bullet starts in joints are off."""
        self.hinges, self.friction = {}, {}
        for name, body in self.bodies.items():
            for j in range(p.getNumJoints(body)):
                info = p.getJointInfo(body, j)
                self.hinges[f"{name}.{info[12].decode()}"] = (body, j)
                p.setJointMotorControl2(body, j, p.VELOCITY_CONTROL, targetVelocity=0, force=info[7])

    def poses(self):
        found = {}
        for name, body in self.bodies.items():
            at, turn = p.getBasePositionAndOrientation(body)  # of the centre of mass
            info = p.getDynamicsInfo(body, -1)
            at, turn = p.multiplyTransforms(at, turn, *p.invertTransform(info[3], info[4]))
            found[name] = (at, np.roll(turn, 1))
        for name, (body, j) in self.hinges.items():
            state = p.getLinkState(body, j, computeForwardKinematics=True)
            found[name] = (state[4], np.roll(state[5], 1))
        return found

    def joints(self):
        kinds, found = {p.JOINT_REVOLUTE: "hinge", p.JOINT_PRISMATIC: "slide"}, {}
        for name, (body, j) in self.hinges.items():
            info = p.getJointInfo(body, j)
            found[name] = (kinds[info[2]], info[8], info[9])
        return found

    def set_joint(self, name, value):
        p.resetJointState(*self.hinges[name], value)

    def step(self, seconds):
        for _ in range(round(seconds / STEP)):
            p.stepSimulation()
