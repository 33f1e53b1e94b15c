"""robosuite: ``scene.xml`` as an arena in an empty world."""

from importlib.metadata import version

import client_mujoco
from robosuite.models.arenas import Arena
from robosuite.models.world import MujocoWorldBase


class Room(client_mujoco.Room):
    """The room merged into a world, as robosuite's tasks do."""

    @classmethod
    def version(cls):
        return version("robosuite")

    def __init__(self, folder):
        world = MujocoWorldBase()
        world.merge(Arena(f"{folder}/scene.xml"))
        self.load(world.get_model(mode="mujoco"))
