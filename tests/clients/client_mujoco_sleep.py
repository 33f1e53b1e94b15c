"""MuJoCo 3.4 and newer: ``scene-sleep.xml``, in which what is at rest sleeps."""

import client_mujoco
import mujoco


class Room(client_mujoco.Room):
    """The room, sleeping."""

    def __init__(self, folder):
        self.load(mujoco.MjModel.from_xml_path(f"{folder}/scene-sleep.xml"))
