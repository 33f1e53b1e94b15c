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
        sys.stderr.write(f"no materials: {error}\n")
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
        part,
        vertices=np.concatenate(vertices),
        faces=np.concatenate(faces),
        face_material=np.concatenate(materials),
        looks=np.array(looks),
        names=np.array(names),
    )
    os.replace(part, out)


def look_of(material) -> tuple:
    """sRGB base colour, roughness and metallic of a shader, from what its nodes have unlinked; a mean, no texture."""
    color, roughness, metallic = (0.4, 0.4, 0.4), 0.6, 0.0
    nodes = list(all_nodes(material.node_tree)) if material and material.use_nodes else []
    bodies = [node for node in nodes if node.type == "BSDF_PRINCIPLED"]
    found = [tuple(n.inputs["Base Color"].default_value)[:3] for n in bodies if not n.inputs["Base Color"].is_linked]
    if len(found) < len(bodies) or not bodies:
        found = colors_of(nodes) or found
    if found:
        color = tuple(sum(c[k] for c in found) / len(found) for k in range(3))
    plain = [node.inputs["Roughness"] for node in bodies if not node.inputs["Roughness"].is_linked]
    if plain:
        roughness = sum(float(i.default_value) for i in plain) / len(plain)
    metal = [node.inputs["Metallic"] for node in bodies if not node.inputs["Metallic"].is_linked]
    if metal:
        metallic = sum(float(i.default_value) for i in metal) / len(metal)
    clipped = [max(0.0, min(1.0, c)) for c in color]
    srgb = [12.92 * c if c <= 0.0031308 else 1.055 * c ** (1 / 2.4) - 0.055 for c in clipped]
    return (*srgb, roughness, metallic)


def all_nodes(tree):
    """The nodes of a tree and of the groups in it."""
    for node in tree.nodes:
        yield node
        if node.type == "GROUP" and node.node_tree:
            yield from all_nodes(node.node_tree)


def colors_of(nodes) -> list:
    """Colours that a shader is mixed from: ramps, plain colours, and unlinked colour sockets that were set."""
    found = []
    for node in nodes:
        if node.type == "VALTORGB":
            found += [tuple(e.color)[:3] for e in node.color_ramp.elements]
        elif node.type == "RGB":
            found.append(tuple(node.outputs[0].default_value)[:3])
        elif node.type in ("GROUP", "MIX", "MIX_RGB", "HUE_SAT", "BRIGHTCONTRAST"):
            sockets = [i for i in node.inputs if i.type == "RGBA" and not i.is_linked]
            found += [tuple(i.default_value)[:3] for i in sockets if len(set(tuple(i.default_value)[:3])) > 1]
    # Pure black and white are masks of noise, hardly ever paint.
    paints = [c for c in found if 0.02 < sum(c) < 2.9]
    return [c for c in paints if max(c) - min(c) > 0.02] or paints


if __name__ == "__main__":
    main()
