"""Blender as a module: ``scene.usdc``."""

import bpy
import client_blender
from mathutils import Quaternion


class Room(client_blender.Room):
    """The prims of a USD stage."""

    frames = "object"
    bodies_fixed = False
    turn = Quaternion((1, 0, 0, 0))

    def load(self, folder):
        bpy.ops.wm.usd_import(filepath=f"{folder}/scene.usdc")

    def name(self, item):
        parent = item.parent.name if item.parent is not None else ""
        if item.name.split(".")[0] == "leaf":
            return f"room:door:{parent}"
        return item.name
