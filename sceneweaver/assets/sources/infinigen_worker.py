# /// script
# requires-python = "==3.11.*"
# dependencies = ["infinigen", "bpy==4.2.0", "numpy<2"]
# ///
"""Runs one Infinigen generator and writes its mesh; a process and an environment of its own.

    uv run --script infinigen_worker.py MODULE FACTORY SEED OUT.npz

Infinigen pins an old numpy and brings its own Blender, so nothing of sceneweaver is imported here, and sceneweaver
imports nothing of this. The file holds vertices [V, 3], faces [F, 3], face_material [F] and colors [M, 5]
(sRGB, roughness, metallic) and material names. Units are metres, z is up and the front is +x.
"""

import importlib
import os
import sys

# Python puts the folder of a script first; the modules beside this one are not meant for here.
sys.path = [path for path in sys.path if os.path.realpath(path or ".") != os.path.dirname(os.path.realpath(__file__))]


def main() -> None:
    """Make one asset and write it, complete or not at all."""
    module, factory, seed, out = sys.argv[1], sys.argv[2], int(sys.argv[3]), sys.argv[4]
    import bpy
    import numpy as np

    bpy.ops.wm.read_factory_settings(use_empty=True)
    maker = getattr(importlib.import_module(f"infinigen.assets.objects.{module}"), factory)
    made = maker(seed)
    thing = made.spawn_asset(0)
    try:
        made.finalize_assets([thing])
    except Exception as error:  # materials may need what a headless Blender lacks; the shape is there all the same
        print(f"no materials: {error}", file=sys.stderr)
    vertices, faces, materials, looks, names = [], [], [], [], []
    depsgraph = bpy.context.evaluated_depsgraph_get()
    start = 0
    for item in [thing, *thing.children_recursive]:
        if item.type != "MESH":
            continue
        body = item.evaluated_get(depsgraph)
        mesh = body.to_mesh()
        mesh.calc_loop_triangles()
        if len(mesh.loop_triangles):
            points = np.empty(3 * len(mesh.vertices))
            mesh.vertices.foreach_get("co", points)
            world = np.array(body.matrix_world)
            points = points.reshape(-1, 3) @ world[:3, :3].T + world[:3, 3]
            triangles = np.empty(3 * len(mesh.loop_triangles), dtype=np.int32)
            mesh.loop_triangles.foreach_get("vertices", triangles)
            slot = np.empty(len(mesh.loop_triangles), dtype=np.int32)
            mesh.loop_triangles.foreach_get("material_index", slot)
            slots = [s.material for s in item.material_slots] or [None]
            base = len(looks)
            for material in slots:
                looks.append(look_of(material))
                names.append(material.name if material else "none")
            vertices.append(points)
            faces.append(triangles.reshape(-1, 3) + start)
            materials.append(np.clip(slot, 0, len(slots) - 1) + base)
            start += len(points)
        body.to_mesh_clear()
    if not vertices:
        raise SystemExit(f"{factory} made no mesh")
    part = f"{out}.part.npz"
    np.savez_compressed(
        part, vertices=np.concatenate(vertices), faces=np.concatenate(faces), face_material=np.concatenate(materials),
        looks=np.array(looks), names=np.array(names),
    )  # fmt: skip
    os.replace(part, out)


def look_of(material) -> tuple:
    """sRGB base colour, roughness and metallic: of the principled shader, with the mean of its colour ramps."""
    color, roughness, metallic = (0.6, 0.6, 0.6), 0.6, 0.0
    nodes = list(material.node_tree.nodes) if material and material.use_nodes else []
    for node in nodes:
        if node.type == "BSDF_PRINCIPLED":
            base = node.inputs["Base Color"]
            color = tuple(base.default_value)[:3]
            if base.is_linked:
                color = mean_color(nodes) or color
            if not node.inputs["Roughness"].is_linked:
                roughness = float(node.inputs["Roughness"].default_value)
            metallic = float(node.inputs["Metallic"].default_value)
            break
    else:
        color = mean_color(nodes) or color
    clipped = [max(0.0, min(1.0, c)) for c in color]
    srgb = [12.92 * c if c <= 0.0031308 else 1.055 * c ** (1 / 2.4) - 0.055 for c in clipped]
    return (*srgb, roughness, metallic)


def mean_color(nodes) -> tuple | None:
    """The mean colour of all ramps and plain colours of a shader."""
    found = []
    for node in nodes:
        if node.type == "VALTORGB":
            found += [tuple(e.color)[:3] for e in node.color_ramp.elements]
        elif node.type == "RGB":
            found.append(tuple(node.outputs[0].default_value)[:3])
    return tuple(sum(c[k] for c in found) / len(found) for k in range(3)) if found else None


if __name__ == "__main__":
    main()
