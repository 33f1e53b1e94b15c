"""A scene as a multibody plant: floor objects that slide and turn on the floor, the rest of the room around them.

Imported inside functions only: it needs drake.
"""

from __future__ import annotations

from itertools import combinations

import numpy as np
from pydrake.geometry import Box, CollisionFilterDeclaration, Convex, GeometryId, GeometrySet
from pydrake.math import RigidTransform, RotationMatrix
from pydrake.multibody.plant import AddMultibodyPlantSceneGraph, CoulombFriction
from pydrake.multibody.tree import PlanarJoint, SpatialInertia
from pydrake.systems.framework import DiagramBuilder

from benchmarks.rivals.prisms import Prism, rectangle, solids
from benchmarks.rivals.pulls import Room
from benchmarks.starts import movable
from sceneweaver.scene import Scene

TALL = 20.0  # [m] height of everything: what sinks into another thing is to part from it in the plane
THICK = 1.0  # [m] of walls, less where the room goes on behind them


class World:
    """The plant, a context of it, and its queries. Positions are x, y [m] and yaw [rad] of floor objects in a row."""

    def __init__(self, scene: Scene) -> None:
        builder = DiagramBuilder()
        self.plant, _ = AddMultibodyPlantSceneGraph(builder, 0.0)
        bodies = [self._body(k) for k in range(len(movable(scene)))]
        shapes = [*solids(scene), *walls(scene)]
        ids = [self._shape(bodies, k, prism) for k, prism in enumerate(shapes)]
        self.plant.Finalize()
        self._diagram = builder.Build()
        self._root = self._diagram.CreateDefaultContext()
        self.context = self.plant.GetMyMutableContextFromRoot(self._root)
        self._leave_out(shapes, ids)

    def depth(self, q: np.ndarray) -> float:
        """How deep the deepest pair sinks in at positions q [3 n]; at most zero where nothing does [m]."""
        self.plant.SetPositions(self.context, q)
        query = self.plant.get_geometry_query_input_port().Eval(self.context)
        return max((-p.distance for p in query.ComputeSignedDistancePairwiseClosestPoints(0.0)), default=0.0)

    def _body(self, k: int):
        body = self.plant.AddRigidBody(f"body-{k}", SpatialInertia.SolidBoxWithMass(1.0, 1.0, 1.0, 1.0))
        self.plant.AddJoint(PlanarJoint(f"slide-{k}", self.plant.world_frame(), body.body_frame()))
        return body

    def _shape(self, bodies: list, k: int, prism: Prism) -> GeometryId:
        body = bodies[prism.owner] if prism.owner >= 0 else self.plant.world_body()
        box = rectangle(prism.corners)
        if box is None:
            pose = RigidTransform()
            ends = [np.column_stack([prism.corners, np.full(len(prism.corners), z)]) for z in (-TALL / 2, TALL / 2)]
            shape = Convex(np.concatenate(ends).T, f"prism-{k}")
        else:
            middle, half, turn = box
            pose = RigidTransform(RotationMatrix.MakeZRotation(turn), [*middle, 0.0])
            shape = Box(*(2 * half), TALL)
        return self.plant.RegisterCollisionGeometry(body, pose, shape, f"shape-{k}", CoulombFriction(1.0, 1.0))

    def _leave_out(self, shapes: list[Prism], ids: list[GeometryId]) -> None:
        """Pairs that have no height in common never meet, although everything is tall here."""
        graph = self._diagram.GetSubsystemByName("scene_graph")
        manager = graph.collision_filter_manager(graph.GetMyMutableContextFromRoot(self._root))
        filters = CollisionFilterDeclaration()
        for i, j in combinations(range(len(ids)), 2):
            if shapes[i].owner != shapes[j].owner and not shapes[i].overlaps_height(shapes[j]):
                filters.ExcludeBetween(GeometrySet(ids[i]), GeometrySet(ids[j]))
        manager.Apply(filters)


def walls(scene: Scene) -> list[Prism]:
    """A static box behind every wall; at convex corners it goes on, so that there is no gap."""
    import shapely

    room, inside = Room(scene), shapely.Polygon(scene.room.outline).buffer(-1e-6)
    convex, found = set(room.convex.tolist()), []
    for w in range(len(room.p)):
        after = (w + 1) % len(room.p)
        thick = THICK
        while True:
            begin = room.p[w] - (thick if w in convex else 0.0) * room.t[w]
            end = room.p[after] + (thick if after in convex else 0.0) * room.t[w]
            out = -thick * room.n[w]
            corners = np.array([begin, begin + out, end + out, end])
            if thick < 1e-3 or not shapely.intersects(shapely.Polygon(corners), inside):
                break
            thick /= 2
        found.append(Prism(-1, -1, corners, (0.0, scene.room.height)))
    return found
