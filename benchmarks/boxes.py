"""Ten boxes in a bedroom of 5 x 4 m with fourteen relations: a small room to count steps in."""

from __future__ import annotations

from functools import cache

from sceneweaver.scene import Door, Relation, Room, Scene, SceneObject, Window

SIZES = {  # depth, width, height [m]
    "bed": (2.0, 1.5, 0.5),
    "left": (0.4, 0.4, 0.5),
    "right": (0.4, 0.4, 0.5),
    "desk": (0.6, 1.2, 0.75),
    "chair": (0.45, 0.45, 0.8),
    "wardrobe": (0.6, 1.2, 2.0),
    "shelf": (0.3, 0.8, 1.8),
    "dresser": (0.45, 0.9, 0.8),
    "plant": (0.4, 0.4, 1.0),
    "bin": (0.3, 0.3, 0.4),
}
AT_WALLS = ("bed", "left", "right", "desk", "wardrobe", "shelf", "dresser")
BETWEEN_TWO = (
    ("leftright_to_leftright", "left", "bed"),
    ("leftright_to_leftright", "right", "bed"),
    ("front_against", "chair", "desk"),
    ("near", "bin", "desk"),
    ("near", "plant", "shelf"),
    ("parallel", "wardrobe", "bed"),
    ("distance", "plant", "bin"),
)


@cache
def ten_boxes() -> Scene:
    """The scene; its poses are all the same and mean nothing."""
    room = Room(
        outline=((0, 0), (5, 0), (5, 4), (0, 4)),
        height=2.6,
        doors=(Door(id="door", wall=0, offset=0.3, width=0.9, height=2.1),),
        windows=(Window(id="window", wall=2, offset=1.5, width=1.4, sill=0.9, height=1.2),),
    )
    far = {"distance": {"min": 0.5, "max": 6.0}}
    relations = [Relation(type="against_wall", subject=name) for name in AT_WALLS]
    relations += [Relation(type=t, subject=a, target=b, params=far.get(t, {})) for t, a, b in BETWEEN_TWO]
    objects = [SceneObject(id=name, category=name, size=size) for name, size in SIZES.items()]
    return Scene(id="ten-boxes", room=room, objects=tuple(objects), relations=tuple(relations))
