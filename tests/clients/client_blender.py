"""Blender as a module: ``scene.glb``."""

import bpy
from mathutils import Matrix, Vector
from measure import Client


class Room(Client):
    """The nodes of a glTF file; Blender turns the frames of all nodes from y up to z up."""

    frames = "node"
    simulates = False

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
            found[self.name(item)] = (tuple(at), tuple(turn))
        return found

    def hinges(self):
        """What moves by its extras: the objects, how they move, and where they are when closed."""
        if not hasattr(self, "closed"):
            kinds = {o: o["joint"].to_dict() for o in bpy.data.objects if "joint" in o}
            moving = {o: joint for o, joint in kinds.items() if joint["type"] != "free"}
            self.closed = {self.name(o): (o, joint, o.matrix_local.copy()) for o, joint in moving.items()}
        return self.closed

    def joints(self):
        return {name: (joint["type"], *joint["limits"]) for name, (_, joint, _) in self.hinges().items()}

    def set_joint(self, name, value):
        item, joint, closed = self.hinges()[name]
        axis = Vector(joint["axis_z_up"])
        by = Matrix.Rotation(value, 4, axis) if joint["type"] == "hinge" else Matrix.Translation(value * axis)
        item.matrix_local = closed @ by
        bpy.context.view_layer.update()
