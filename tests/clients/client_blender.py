"""Blender as a module: ``scene.glb``."""

import math

import bpy
from mathutils import Quaternion
from measure import Client


class Room(Client):
    """The nodes of a glTF file; Blender turns y up to z up."""

    frames = "node"
    simulates = False
    turn = Quaternion((1, 0, 0), math.pi / 2)  # from the frames of meshes, z up, to those of Blender's nodes

    @classmethod
    def version(cls):
        return bpy.app.version_string

    def load(self, folder):
        bpy.ops.import_scene.gltf(filepath=f"{folder}/scene.glb")

    def __init__(self, folder):
        bpy.ops.wm.read_factory_settings(use_empty=True)
        self.load(folder)
        bpy.context.view_layer.update()

    def name(self, item):
        return item.name

    def poses(self):
        found = {}
        for item in bpy.data.objects:
            at, turn, _ = item.matrix_world.decompose()
            found[self.name(item)] = (tuple(at), tuple(turn @ self.turn))
        return found
