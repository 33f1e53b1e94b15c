"""Kitchens of RoboCasa: where the fixtures of a layout stand, by its rules of alignment.

A fixture's frame has x to the right, y to the back and z up; sizes are (width, depth, height), full lengths.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from .categories import category_of
from .fixture_models import FixtureModels
from .sizes import usual_size
from .values import Entry

SHELL = ("wall", "floor")
SAMPLED = "placement"
"""Key of what RoboCasa puts somewhere on a counter when it loads the kitchen."""

GAP = 0.02
"""Least distance [m] of a sink or hob from the edge of its counter."""

_SIDES = (("left", "right"), ("front", "back"), ("bottom", "top"))
_SINK = (0.78, 0.5, 0.25)
"""Width, depth and height [m] of a sink that is let into a counter, which no category is."""

_LABELS = {
    "counter": "kitchen counter",
    "stack": "base cabinet",
    "housing_cabinet": "kitchen cabinet",
    "box": "cabinet",
    "stovetop": "cooktop",
    "hood": "range hood",
    "wall_accessory": "power outlet",
    "open_cabinet": "wall shelf",
}


@dataclass(eq=False)
class Fixture:
    """A fixture: box centre ``at`` [m] and angle in the room, after `placed` has put its group there."""

    name: str
    type: str
    group: str
    entry: Entry
    size: np.ndarray
    offset: np.ndarray
    asset: str | None = None
    given: bool = True
    at: np.ndarray = field(default_factory=lambda: np.zeros(3))
    yaw: float = 0.0
    stands: bool = False

    @property
    def origin(self) -> np.ndarray:
        """Where the origin of its model is, which absolute positions are of."""
        return self.at - self.offset

    @property
    def low(self) -> np.ndarray:
        """Least corner [3] of the box, while nothing is turned."""
        return self.at - self.size / 2

    @property
    def high(self) -> np.ndarray:
        """Largest corner [3] of the box, while nothing is turned."""
        return self.at + self.size / 2


def label_of(kind: str, config: str, height: float) -> str:
    """A word for a type of fixture, whose middle is at some height [m]."""
    if kind == "wall_accessory" and config:
        return config.replace("_", " ")
    if kind.startswith("fridge"):
        return "refrigerator"
    if kind in _LABELS:
        return _LABELS[kind]
    if kind.endswith("_cabinet"):
        return "wall cabinet" if height > 1.2 else "base cabinet"
    return kind.replace("_", " ")


class Kitchen:
    """The fixtures of a layout in the order of the file, each placed by what stands before it."""

    def __init__(self, root: Entry, models: FixtureModels):
        self.fixtures: dict[str, Fixture] = {}
        self.walls: dict[str, Entry] = {}
        self.floors: list[Entry] = []
        self.sampled: list[str] = []
        self.disabled: list[str] = []
        self.notes: list[str] = []
        self._models = models
        for group, content in root.items():
            if group == "room" or isinstance(content.value, dict):
                self._group(group, content)
        for group, content in root.items():
            if isinstance(content.value, dict) and content.has("group_origin"):
                self._turn(group, content)
        for fixture in self.fixtures.values():
            if fixture.entry.has("z_rot"):
                fixture.yaw += fixture.entry["z_rot"].number()

    def _group(self, group: str, content: Entry) -> None:
        for key, listed in content.items():
            if key in ("group_origin", "group_pos", "group_z_rot"):
                continue
            for item in listed.entries():
                kind, name = item["type"].text(), f"{item['name'].text()}_{group}"
                if item.value.get("enable") is False:
                    self.disabled.append(name)
                elif kind in SHELL:
                    if item.value.get("backing") is not True:
                        if kind == "wall":
                            self.walls[name] = item
                        else:
                            self.floors.append(item)
                elif item.has(SAMPLED):
                    self.sampled.append(name)
                else:
                    self._add(name, kind, group, item)

    def _add(self, name: str, kind: str, group: str, item: Entry) -> None:
        if name in self.fixtures:
            raise item["name"].error("names a fixture twice in its group; rename one")
        model = self._models.find(kind)
        usual, known = model.size if model is not None else _usual(kind, item), model is not None
        size, whole = self._size(item, kind, group, np.array(usual), known)
        offset = np.zeros(3) if model is None else np.array(model.offset) * size / np.array(model.size)
        made = Fixture(name, kind, group, item, size, offset, model.name if model is not None else None, whole)
        inner = self._named(item["interior_obj"], group) if item.has("interior_obj") else None
        if kind == "housing_cabinet" and inner is not None:
            made.size, made.given = self._housed(item, inner, size), made.given and inner.given
        if item.has("align_to"):
            made.at = _beside(made, item, self._named(item["align_to"], group))
        elif item.has("stack_on"):
            made.at = self._on(item, made, self._named(item["stack_on"], group))
        elif item.has("attach_to"):
            self._attach(made, item, group)
        elif item.has("pos"):
            made.at = np.array(item["pos"].numbers(3)) + made.offset
        if not whole and made.low[2] < 0 < made.high[2]:  # the usual height is too much below what it is flush with
            made.size[2] = made.high[2]
            made.at[2] = made.size[2] / 2
        made.stands = made.stands or any(item.has(k) for k in ("align_to", "stack_on", "attach_to", "pos"))
        self.fixtures[name] = made
        if inner is not None:
            _let_in(made, inner, item)

    def _named(self, field: Entry, group: str) -> Fixture:
        name = f"{field.text()}_{group}"
        if name not in self.fixtures:
            raise field.error("names a fixture that is not before it in its group")
        return self.fixtures[name]

    def _size(self, item: Entry, kind: str, group: str, usual: np.ndarray, known: bool) -> tuple[np.ndarray, bool]:
        """Width, depth and height [m], and whether they are known: a model keeps its shape where one is null."""
        given: list[float | None] = [None, None, None]
        sure = True
        if item.has("size"):
            values = list(item["size"].entries())
            if len(values) != 3:
                raise item["size"].error("must hold width, depth and height; null where free")
            for k, value in enumerate(values):
                if isinstance(value.value, str):
                    other = self._named(value, group)
                    given[k], sure = float(other.size[k]), sure and other.given
                elif value.value is not None:
                    given[k] = value.number(1e-4, 100.0)
        if item.has("stack_height"):
            stack = [self._named(f, group) for f in item.listed("stack_fixtures")]
            given[2] = item["stack_height"].length() - sum(float(f.size[2]) for f in stack)
            sure = sure and all(f.given for f in stack)
            if given[2] <= 0:
                raise item["stack_height"].error("is lower than what stands below; nothing is left for it")
        if kind == "housing_cabinet" and not item.has("size"):
            return usual, item.has("interior_obj")  # it is as large as what is in it
        scale: list[float | None] = [None if v is None else v / u for v, u in zip(given, usual, strict=True)]
        order = ((0, 2, 1), (1, 0, 2), (2, 0, 1))
        filled = [next((s for k in row if (s := scale[k]) is not None), 1.0) for row in order]
        # In RoboCasa width follows height before depth, depth follows width, height follows width.
        return usual * np.array(filled), sure and (known or all(v is not None for v in given))

    def _housed(self, item: Entry, inner: Fixture, size: np.ndarray) -> np.ndarray:
        """The size of a housing: its own, or that of what is in it with the padding."""
        if item.has("size"):
            return size
        pads = _padding(item)
        return np.array([inner.size[k] + sum(v or 0.0 for v in pads[k]) for k in range(3)])

    def _on(self, item: Entry, made: Fixture, below: Fixture) -> np.ndarray:
        values = list(item["pos"].entries()) if item.has("pos") else []
        at = below.at.copy()
        for k, value in enumerate(values[:2]):
            if value.value is not None:
                at[k] = value.number() + made.offset[k]
        at[2] = below.high[2] + made.size[2] / 2
        return at

    def _attach(self, made: Fixture, item: Entry, group: str) -> None:
        """Before a wall, where its size is half lengths, or on a floor: nulls of the position are filled from it."""
        name = f"{item['attach_to'].text()}_{group}"
        values = list(item["pos"].entries()) if item.has("pos") else []
        if len(values) != 3:
            raise item.error("'pos' must hold x, y and z; null where the wall or floor says it")
        given = [None if v.value is None else v.number() for v in values]
        if name in self.walls:
            wall = self.walls[name]
            at, half = wall["pos"].numbers(3), wall["size"].numbers(3)
            made.yaw = wall_yaw(wall)
            inward = np.array((np.sin(made.yaw), -np.cos(made.yaw), 0.0))
            for k in range(3):
                made.at[k] = at[k] if given[k] is None else given[k]
            across = int(np.abs(inward).argmax())
            if given[across] is None:
                made.at = made.at + inward * (half[2] + made.size[1] / 2) * (made.type != "window")
            return
        floor = next((f for f in self.floors if f"{f['name'].text()}_{group}" == name), None)
        if floor is None:
            raise item["attach_to"].error("names a wall or floor that is not in its group")
        top = floor["pos"].numbers(3)[2]
        made.at = np.array([given[0] or 0.0, given[1] or 0.0, top + made.size[2] / 2 if given[2] is None else given[2]])

    def _turn(self, group: str, content: Entry) -> None:
        """Put a group where it is in the room: turned about its origin, then moved to its position."""
        origin, to = (np.array([v.number() for v in content[k].entries()][:2]) for k in ("group_origin", "group_pos"))
        angle = content["group_z_rot"].number()
        c, s = np.cos(angle), np.sin(angle)
        for fixture in self.fixtures.values():
            if fixture.group == group:
                x, y = fixture.at[:2] - origin
                fixture.at = np.array([c * x - s * y + to[0], s * x + c * y + to[1], fixture.at[2]])
                fixture.yaw += angle


def wall_yaw(wall: Entry) -> float:
    """The angle [rad] of what hangs on a wall: the back one at y = 0 has it face -y, which is 0."""
    return {"left": np.pi / 2, "right": -np.pi / 2, "front": np.pi}.get(wall.word("wall_side", "back"), 0.0)


def _usual(kind: str, item: Entry) -> tuple[float, float, float]:
    if kind == "sink":
        return _SINK
    depth, width, height = usual_size(category_of(label_of(kind, item.word("config_name"), 1.0)).body)
    return width, depth, height


def _padding(item: Entry) -> list[tuple[float | None, float | None]]:
    """What a housing leaves free [m] on the left and right, at the front and back, below and above; None: not said."""
    pads: list[tuple[float | None, float | None]] = []
    for row in list(item["padding"].entries()) if item.has("padding") else []:
        values = [] if row.value is None else [None if v.value is None else v.number() for v in row.entries()]
        if len(values) not in (0, 2):
            raise row.error("must hold two lengths, or be null")
        pads.append((values[0], values[1]) if values else (None, None))
    return (pads + [(None, None)] * 3)[:3]


def _beside(made: Fixture, item: Entry, other: Fixture) -> np.ndarray:
    """The box centre of a fixture that touches a side of another one, flush with the faces that it is aligned to."""
    side, flush = item["side"].text().lower(), item.word("alignment", "center").lower()
    at = other.at.copy()
    known = [name for pair in _SIDES for name in pair]
    if side not in known:
        raise item["side"].error(f"must be one of {', '.join(known)}")
    for axis, (low, high) in enumerate(_SIDES):
        reach = (other.size[axis] + made.size[axis]) / 2
        room = (other.size[axis] - made.size[axis]) / 2
        if side in (low, high):
            at[axis] += reach if side == high else -reach
        if low in flush:
            at[axis] = other.at[axis] - room
        elif high in flush:
            at[axis] = other.at[axis] + room
    return at + np.array(item["offset"].numbers(3)) if item.has("offset") else at


def _let_in(made: Fixture, inner: Fixture, item: Entry) -> None:
    """Put what is within a counter or a housing at its place there."""
    inner.stands = made.stands
    if made.type == "housing_cabinet":
        pads = _padding(item)
        for k in range(3):
            low, high = pads[k]
            free = made.size[k] - inner.size[k]
            if low is None and high is None:
                low = free / 2
            low = free - high if low is None and high is not None else low
            inner.at[k] = made.low[k] + (low or 0.0) + inner.size[k] / 2
        return
    part = [item[k].number() if item.has(k) else 0.5 for k in ("obj_x_percent", "obj_y_percent")]
    inner.at = made.at.copy()
    for k, share in enumerate(part):
        most = (made.size[k] - GAP - inner.size[k] / 2) / made.size[k]
        share = float(np.clip(share, 1 - most, most)) if most >= 0.5 else 0.5
        inner.at[k] = made.at[k] + (share - 0.5) * made.size[k]
    inner.at[2] = made.high[2] - inner.size[2] / 2
