"""Cases for the physics of many layouts: models and initial poses, made here and measured anywhere."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sceneweaver.physics.batch import Shapes, model_of, poses_of
from sceneweaver.physics.model import Model
from sceneweaver.physics.worlds import Template
from sceneweaver.scene import Scene

REQUEST = "Design me a bedroom for a teenager with a desk, a bookshelf and things on every surface"
"""What the designed case is made from; many of its things are small."""

BODIES = range(28, 35)
"""Things that may move in the designed case: it is the first seed's design that has so many."""

SEEDS = 20


@dataclass(frozen=True)
class Case:
    """Models of one room by shapes, and initial poses [B, N, 7] in the order of ``Template``."""

    name: str
    scene: Scene
    models: dict[str, Model]
    poses: np.ndarray

    @property
    def free(self) -> tuple[str, ...]:
        """The bodies that may move."""
        return self.models["hull"].free

    def template(self, shapes: str) -> Template:
        """The compiled model."""
        return Template.of(self.models[shapes], self.scene)


def case_of(scene: Scene, poses: np.ndarray, seed: int = 0) -> Case:
    """Layouts [B, N, 4] of a scene; in every second one, one free thing in five is lifted by up to 4 cm."""
    shapes: tuple[Shapes, ...] = ("box", "hull")
    models = {each: model_of(scene, shapes=each) for each in shapes}
    free, fixed = models["hull"].free, models["hull"].fixed
    order = [scene.index(name) for name in (*free, *fixed)]
    start = poses_of(scene, poses)[:, order]
    random = np.random.default_rng(seed)
    shape = (len(start), len(free))
    lift = np.where(random.random(shape) < 0.2, random.uniform(0.0, 0.04, shape), 0.0)
    lift[::2] = 0.0
    start[:, : len(free), 2] += lift
    return Case(scene.id, scene, dict(models), start)


def designed(count: int, device: str = "cpu") -> Case:
    """A designed room with valid layouts of its own."""
    from sceneweaver.agent import design
    from sceneweaver.layout import refine
    from sceneweaver.physics import build

    for seed in range(SEEDS):
        scene = design(REQUEST, seed=seed, device=device).scene
        if len(build(scene).free) in BODIES:
            break
    found = refine(scene, candidates=count, seed=0, device=device)
    return case_of(scene, np.asarray(found.poses))


def small(count: int, seed: int = 0) -> Case:
    """A desk with a few things on it, at other places of an empty room."""
    from sceneweaver.assets import make
    from sceneweaver.scene import Pose, Room, Support

    desk = make("desk", 3)
    top = desk.surfaces[0]
    objects = [desk.object("desk", pose=Pose.from_yaw(2, 2, 0, 0))]
    for k, kind in enumerate(("mug", "vase", "book_stack")):
        on = Support(object="desk", surface=top.name)
        objects.append(make(kind, 1).object(kind, pose=Pose.from_yaw(2, 1.6 + 0.35 * k, top.z, 0.5 * k), support=on))
    room = Room(outline=((0, 0), (6, 0), (6, 6), (0, 6)))
    scene = Scene(id="desk", room=room, objects=tuple(objects))
    own = np.array([(*o.pose.position, o.pose.yaw) for o in scene.objects])
    poses = np.tile(own, (count, 1, 1))
    poses[..., :2] += np.random.default_rng(seed).uniform(-1, 1, (count, 1, 2))
    return case_of(scene, poses, seed)
