"""Rooms that are set out by hand, tidy and furnished, with the kinds of rooms and requests that they answer."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cache
from typing import Any

from sceneweaver.assets import Asset, Request, make
from sceneweaver.critic import Review, review_scene
from sceneweaver.knowledge import RoomType
from sceneweaver.language import SceneGraph
from sceneweaver.scene import Door, Pose, Relation, Room, Scene, SceneObject, Support, Window
from sceneweaver.verify import Report, check

Size = tuple[float, float, float]

HEIGHT = 2.6
"""Height [m] of all rooms."""


@cache
def asset(category: str, seed: int = 0, size: Size | None = None) -> Asset:
    """An asset; drawn once."""
    return make(category, seed, Request(size=size) if size else None)


@dataclass(frozen=True)
class Case:
    """A scene, the kind of room and the request."""

    scene: Scene
    room_type: RoomType
    brief: SceneGraph = field(default_factory=lambda: SceneGraph(text=""))

    def report(self) -> Report:
        return check(self.scene)

    def review(self) -> Review:
        return review_scene(self.scene, self.report(), self.room_type, self.brief)

    def but(self, *changes: Mapping[str, Any], brief: SceneGraph | None = None) -> Case:
        """The case with objects moved (id, x, y, degrees, z), taken out (id, gone) or of another category."""
        objects = {o.id: o for o in self.scene.objects}
        for change in changes:
            object_id = change["id"]
            if change.get("gone"):
                del objects[object_id]
            else:
                before = objects[object_id]
                objects[object_id] = _changed(before, change)
                for other in [o for o in objects.values() if o.support and o.support.object == object_id]:
                    objects[other.id] = _carried(other, before.pose, objects[object_id].pose)
        objects = {k: o for k, o in objects.items() if o.support is None or o.support.object in objects}
        relations = tuple(r for r in self.scene.relations if {r.subject, *r.targets} <= {*objects, None})
        scene = self.scene.model_copy(update={"objects": tuple(objects.values()), "relations": relations})
        return replace(self, scene=scene, brief=brief or self.brief)

    def plus(self, *objects: SceneObject) -> Case:
        """The case with more objects."""
        return replace(self, scene=self.scene.model_copy(update={"objects": (*self.scene.objects, *objects)}))


def _changed(o: SceneObject, change: Mapping[str, Any]) -> SceneObject:
    x, y, z = o.pose.position
    yaw = math.degrees(o.pose.yaw)
    pose = Pose.from_yaw(
        change.get("x", x), change.get("y", y), change.get("z", z), math.radians(change.get("yaw", yaw))
    )
    return o.model_copy(update={"pose": pose, **change.get("update", {})})


def _carried(o: SceneObject, before: Pose, after: Pose) -> SceneObject:
    """What stands on something that moved, moved with it."""
    turn = after.yaw - before.yaw
    (x, y, z), (bx, by, bz), (ax, ay, az) = o.pose.position, before.position, after.position
    u, v = x - bx, y - by
    c, s = math.cos(turn), math.sin(turn)
    pose = Pose.from_yaw(ax + c * u - s * v, ay + s * u + c * v, z + az - bz, o.pose.yaw + turn)
    return o.model_copy(update={"pose": pose})


def put(
    object_id: str,
    x: float,
    y: float,
    yaw: float = 0.0,
    z: float = 0.0,
    *,
    seed: int = 0,
    size: Size | None = None,
    mount: Any = None,
) -> SceneObject:
    """An object of the category before the dash of its id; yaw in degrees."""
    body = asset(object_id.rsplit("-", 1)[0], seed, size)
    z = HEIGHT - body.size[2] if body.mount == "ceiling" else z
    return body.object(object_id, pose=Pose.from_yaw(x, y, z, math.radians(yaw)), mount=mount)


def on(
    base: SceneObject,
    object_id: str,
    ahead: float = 0.0,
    left: float = 0.0,
    yaw: float = 0.0,
    *,
    surface: str = "",
    seed: int = 0,
) -> SceneObject:
    """An object on a surface (the first one) of another, at a place in its frame."""
    row = next(s for s in base.surfaces if not surface or s.name == surface)
    xs, ys = [p[0] for p in row.polygon], [p[1] for p in row.polygon]
    u, v = (min(xs) + max(xs)) / 2 + ahead, (min(ys) + max(ys)) / 2 + left
    turn = base.pose.yaw
    x = base.pose.position[0] + u * math.cos(turn) - v * math.sin(turn)
    y = base.pose.position[1] + u * math.sin(turn) + v * math.cos(turn)
    pose = Pose.from_yaw(x, y, base.pose.position[2] + row.z, turn + math.radians(yaw))
    body = asset(object_id.rsplit("-", 1)[0], seed)
    return body.object(object_id, pose=pose, support=Support(object=base.id, surface=row.name))


def room(width: float, depth: float, *, door: float = 0.3, window: float | None = None, kind: str = "room") -> Room:
    """A rectangle with a door in the wall y = 0, and a window in the wall opposite, starting at x = ``window``."""
    windows = (
        ()
        if window is None
        else (Window(id="window-0", wall=2, offset=width - window - 1.4, width=1.4, sill=0.9, height=1.3),)
    )
    return Room(
        type=kind,
        outline=((0, 0), (width, 0), (width, depth), (0, depth)),
        height=HEIGHT,
        windows=windows,
        doors=(Door(id="door-0", wall=0, offset=door, width=0.88, height=2.05, swing="in-left"),),
    )


def kind(name: str, items: list[dict[str, Any]], **more: Any) -> RoomType:
    """A kind of room with those items."""
    base: dict[str, Any] = {
        "name": name,
        "description": name,
        "sources": ("none",),
        "area": (6, 14, 80),
        "doors": {"width": (0.8, 0.9), "height": (2.0, 2.1)},
        "windows": {"width": (1.2, 1.5), "height": (1.2, 1.4)},
    }
    return RoomType(**{**base, **more, "items": items})


BEDROOM = kind(
    "bedroom",
    [
        {"id": "bed", "what": ["bed", "king_bed"], "need": "needed", "place": ["against_wall"], "top": "bed_dressing"},
        {
            "id": "nightstand",
            "what": "nightstand",
            "with": "bed",
            "count": 2,
            "need": "needed",
            "top": "bedside",
            "place": ["leftright_to_leftright bed"],
        },
        {"id": "wardrobe", "what": "wardrobe", "need": "needed", "place": ["against_wall"]},
        {"id": "dresser", "what": ["dresser", "tallboy"], "place": ["against_wall"], "top": "dresser_display"},
        {"id": "rug", "what": "rug", "need": "optional"},
        {"id": "picture", "what": "picture", "place": ["above bed"]},
        {"id": "lamp", "what": "ceiling_light"},
        {"id": "plant", "what": "snake_plant", "place": ["in_corner"]},
    ],
)

LIVING = kind(
    "living_room",
    [
        {"id": "sofa", "what": ["sofa"], "need": "needed", "place": ["against_wall", "facing tv"]},
        {"id": "stand", "what": "tv_stand", "need": "needed", "place": ["against_wall"]},
        {"id": "tv", "what": "tv", "need": "needed", "on": ["stand"]},
        {"id": "table", "what": "coffee_table", "need": "needed", "place": ["front_to_front sofa"]},
        {"id": "armchair", "what": "armchair", "need": "usual"},
        {"id": "bookcase", "what": "bookcase", "need": "usual", "place": ["against_wall"], "fill": "books"},
        {"id": "plant", "what": "snake_plant", "need": "usual"},
        {"id": "lamp", "what": "ceiling_light", "need": "usual"},
        {"id": "picture", "what": "picture", "need": "usual"},
    ],
)

OFFICE = kind(
    "office",
    [
        {"id": "desk", "what": "desk", "need": "needed", "count": 2, "place": ["against_wall"], "top": "desk_set"},
        {
            "id": "chair",
            "what": "office_chair",
            "need": "needed",
            "with": "desk",
            "count": 1,
            "place": ["front_to_front desk"],
        },
        {"id": "bookcase", "what": "bookcase", "need": "usual", "place": ["against_wall"], "fill": "books"},
        {"id": "lamp", "what": "ceiling_light", "need": "usual"},
        {"id": "picture", "what": "picture", "need": "usual"},
        {"id": "plant", "what": "snake_plant", "need": "usual"},
    ],
)

DINING = kind(
    "restaurant",
    [
        {"id": "table", "what": ["dining_table", "cafe_table"], "need": "needed", "count": [2, 40]},
        {
            "id": "chair",
            "what": "dining_chair",
            "need": "needed",
            "with": "table",
            "count": 4,
            "place": ["front_against table"],
        },
        {"id": "lamp", "what": "pendant", "need": "usual", "with": "table"},
        {"id": "picture", "what": "picture", "need": "usual"},
        {"id": "plant", "what": "snake_plant", "need": "usual"},
    ],
    made_of=("chair",),
)


@cache
def bedroom() -> Case:
    """A bedroom of 3.6 x 4 m: the bed's head at the wall x = 0, the wardrobe opposite."""
    bed = put("bed-0", 1.08, 2.25, 0, size=(2.05, 1.65, 0.95))
    half = 1.65 / 2
    stands = [
        put(f"nightstand-{k}", 0.24, 2.25 + s * (half + 0.24), 0, size=(0.4, 0.45, 0.5)) for k, s in enumerate((1, -1))
    ]
    wardrobe = put("wardrobe-0", 3.28, 2.6, 180, size=(0.6, 1.6, 2.1))
    dresser = put("dresser-0", 2.6, 0.25, 90, size=(0.45, 1.1, 0.8))
    plant = put("snake_plant-0", 3.3, 3.7, size=(0.3, 0.3, 0.8))
    objects = [
        bed,
        *stands,
        wardrobe,
        dresser,
        plant,
        put("rug-0", 2.3, 2.25, 90),
        put("picture-0", 0.02, 2.25, 0, 1.3, size=(0.03, 0.8, 0.6)),
        put("ceiling_light-0", 1.8, 2.0),
        on(stands[0], "book-0"),
        on(stands[1], "alarm_clock-0"),
        on(dresser, "vase-0", left=0.3),
        on(dresser, "jewelry_box-0", left=-0.3),
    ]
    relations = [
        Relation(type="against_wall", subject="bed-0"),
        *(Relation(type="leftright_to_leftright", subject=s.id, target="bed-0") for s in stands),
        Relation(type="against_wall", subject="wardrobe-0"),
    ]
    return _case(room(3.6, 4.0, window=1.0, kind="bedroom"), objects, relations, BEDROOM)


@cache
def living() -> Case:
    """A living room of 5 x 4.2 m: the sofa at the wall x = 5 looks at the television at x = 0."""
    stand = put("tv_stand-0", 0.26, 2.1, 0, size=(0.42, 1.5, 0.5))
    sofa = put("sofa-0", 4.52, 2.1, 180, size=(0.92, 2.0, 0.85))
    table = put("coffee_table-0", 3.3, 2.1, 0, size=(0.6, 1.1, 0.42))
    case = put("bookcase-0", 3.4, 4.0, -90, size=(0.32, 1.0, 1.8))
    objects = [
        stand,
        sofa,
        table,
        case,
        put("armchair-0", 2.55, 0.75, 90, size=(0.8, 0.8, 0.9)),
        put("snake_plant-0", 0.2, 4.0, size=(0.3, 0.3, 0.8)),
        put("rug-0", 3.0, 2.1, 0),
        put("picture-0", 4.98, 2.1, 180, 1.3, size=(0.03, 0.9, 0.7)),
        put("ceiling_light-0", 2.5, 2.1),
        on(stand, "tv_on_stand-0", surface="top"),
        on(table, "vase-0", surface="top"),
        on(table, "book-0", left=0.3, surface="top"),
        on(case, "standing_books-0", surface="shelf-0"),
        on(case, "standing_books-1", surface="shelf-1", seed=1),
        on(case, "jewelry_box-0", surface="shelf-2"),
        on(case, "picture_frame-0", surface="shelf-3"),
        on(sofa, "cushion-0", surface="seat-0"),
    ]
    relations = [
        Relation(type="against_wall", subject="sofa-0"),
        Relation(type="against_wall", subject="tv_stand-0"),
        Relation(type="front_to_front", subject="coffee_table-0", target="sofa-0", params={"gap": [0.3, 0.5]}),
    ]
    return _case(room(5.0, 4.2, window=0.6, kind="living_room"), objects, relations[:2], LIVING)


@cache
def office() -> Case:
    """An office of 4.2 x 3.8 m with two desks at the wall y = 3.8."""
    desks = [put(f"desk-{k}", 0.95 + 1.9 * k, 3.44, -90, size=(0.7, 1.4, 0.74)) for k in (0, 1)]
    chairs = [put(f"office_chair-{k}", 0.95 + 1.9 * k, 2.78, 90, size=(0.62, 0.62, 1.0)) for k in (0, 1)]
    case = put("bookcase-0", 4.02, 1.5, 180, size=(0.32, 1.0, 1.8))
    objects = [
        *desks,
        *chairs,
        case,
        put("snake_plant-0", 3.95, 0.25, size=(0.3, 0.3, 0.8)),
        put("picture-0", 0.02, 1.75, 0, 1.3, size=(0.03, 0.9, 0.7)),
        put("ceiling_light-0", 2.1, 1.9),
        put("low_bookcase-0", 0.18, 1.75, 0, size=(0.32, 0.9, 0.8)),
    ]
    for k, desk in enumerate(desks):
        objects += [
            on(desk, f"monitor-{k}", ahead=-0.15),
            on(desk, f"keyboard-{k}", ahead=0.12),
            on(desk, f"pen_holder-{k}", left=0.5),
        ]
    low = objects[8]
    objects += [on(case, f"standing_books-{k}", surface=f"shelf-{k}", seed=k) for k in range(4)]
    objects += [on(low, "standing_books-4", surface="shelf-0"), on(low, "vase-0", surface="top")]
    relations = [
        Relation(type="front_to_front", subject=c.id, target=d.id) for c, d in zip(chairs, desks, strict=True)
    ] + [Relation(type="against_wall", subject=d.id) for d in desks]
    return _case(room(4.2, 3.8, kind="office"), objects, relations, OFFICE)


@cache
def restaurant(rows: int = 2, columns: int = 3) -> Case:
    """Tables for four in a grid, chairs on the long sides."""
    objects: list[SceneObject] = []
    relations = []
    for k in range(rows * columns):
        x, y = 1.8 + 2.4 * (k % columns), 2.6 + 2.6 * (k // columns)
        table = put(f"dining_table-{k}", x, y, 0, size=(0.8, 1.4, 0.75))
        objects += [
            table,
            on(table, f"vase-{k}"),
            on(table, f"salt_and_pepper-{k}", left=0.3),
            on(table, f"candle-{k}", left=-0.3),
            put(f"pendant-{k}", x, y, size=(0.4, 0.4, 1.1)),
        ]
        for j, (side, row) in enumerate(((-1, -1), (-1, 1), (1, -1), (1, 1))):
            chair = put(
                f"dining_chair-{4 * k + j}",
                x + 0.67 * side,
                y + 0.33 * row,
                0 if side < 0 else 180,
                size=(0.5, 0.45, 0.9),
            )
            objects.append(chair)
            relations.append(Relation(type="front_against", subject=chair.id, target=table.id))
    width, depth = 2.4 * columns + 1.2, 2.6 * rows + 1.8
    objects += [
        put("snake_plant-0", width - 0.25, depth - 0.25, size=(0.3, 0.3, 0.8)),
        put("picture-0", 0.02, depth / 2, 0, 1.3, size=(0.03, 0.9, 0.7)),
    ]
    return _case(room(width, depth, kind="restaurant"), objects, relations, DINING)


def _case(space: Room, objects: list[SceneObject], relations: list[Relation], kind: RoomType) -> Case:
    scene = Scene(id=kind.name, room=space, objects=tuple(objects), relations=tuple(relations))
    return Case(scene, kind)


KITCHEN = kind(
    "kitchen",
    [
        {"id": "counter", "what": "kitchen_counter", "need": "needed", "place": ["against_wall"], "top": "counter"},
        {"id": "sink", "what": "sink_cabinet", "need": "needed", "place": ["against_wall"]},
        {"id": "stove", "what": "stove", "need": "needed", "place": ["against_wall"]},
        {"id": "fridge", "what": "fridge", "need": "needed", "place": ["against_wall"]},
        {"id": "hood", "what": "range_hood", "place": ["above stove"]},
        {"id": "table", "what": "dining_table", "top": "dinner"},
        {"id": "chair", "what": "dining_chair", "with": "table", "count": [2, 6], "place": ["front_against table"]},
        {"id": "lamp", "what": "ceiling_light"},
    ],
)


@cache
def kitchen() -> Case:
    """A kitchen of 4 x 4 m with one run at the wall y = 4, and a table for four."""
    sizes = {
        "fridge": (0.62, 0.6, 1.8),
        "sink_cabinet": (0.62, 1.0, 1.2),
        "kitchen_counter": (0.62, 1.4, 0.87),
        "stove": (0.61, 0.6, 0.87),
    }
    objects, left = [], 0.05
    for name, size in sizes.items():
        objects.append(put(f"{name}-0", left + size[1] / 2, 4.0 - size[0] / 2, -90, size=size))
        left += size[1] + 0.005
    sink, counter, stove = objects[1:4]
    hood = asset("range_hood")
    objects.append(put("range_hood-0", stove.pose.position[0], 4.0 - hood.size[0] / 2, -90, 1.6))
    table = put("dining_table-0", 2.0, 1.45, 90, size=(0.8, 1.4, 0.75))
    chairs = [
        put(f"dining_chair-{k}", 2.0 + 0.33 * dx, 1.45 + 0.67 * dy, -90 * dy, size=(0.5, 0.45, 0.9))
        for k, (dx, dy) in enumerate(((-1, -1), (1, -1), (-1, 1), (1, 1)))
    ]
    objects += [
        table,
        *chairs,
        on(sink, "soap_dispenser-0"),
        on(counter, "toaster-0", left=0.3),
        on(counter, "kettle-0", left=-0.3),
        on(table, "fruit_bowl-0"),
        on(table, "mug-0", left=0.4),
        put("ceiling_light-0", 2.0, 1.45),
        put("snake_plant-0", 3.8, 0.2, size=(0.3, 0.3, 0.8)),
        put("wall_clock-0", 0.03, 1.2, 0, 1.7),
    ]
    relations = [Relation(type="front_against", subject=c.id, target=table.id) for c in chairs]
    return _case(room(4.0, 4.0, kind="kitchen"), objects, relations, KITCHEN)
