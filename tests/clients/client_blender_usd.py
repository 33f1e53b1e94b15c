"""Blender as a module: ``scene.usdc``."""

import re

import bpy
import client_blender
from measure import usd_name


class Room(client_blender.Room):
    """The prims of a USD stage."""

    frames = "object"
    bodies_fixed = False

    def load(self, folder):
        bpy.ops.wm.usd_import(filepath=f"{folder}/scene.usdc")

    def name(self, item):
        """By the path of the prim; Blender puts numbers behind names that are there twice."""
        path = []
        while item is not None:
            path.insert(0, re.sub(r"\.\d\d\d$", "", item.name))
            item = item.parent
        if "Objects" not in path and "Doors" not in path:
            return "/".join(path)
        start = path.index("Objects" if "Objects" in path else "Doors")
        return usd_name("/World/" + "/".join(path[start:] if path[start] == "Objects" else path[start - 1 :]))
