"""dm_control: ``scene.xml`` through PyMJCF."""

from importlib.metadata import version

import client_mujoco
from dm_control import mjcf


class Room(client_mujoco.Room):
    """The room as PyMJCF writes it."""

    @classmethod
    def version(cls):
        return version("dm_control")

    def __init__(self, folder):
        root = mjcf.from_path(f"{folder}/scene.xml")
        self.physics = mjcf.Physics.from_mjcf_model(root)
        self.load(self.physics.model.ptr)
