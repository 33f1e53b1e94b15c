"""A programme: which rooms a plan has, how large they are, what lies next to what."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import cached_property
from typing import Annotated, Any, Literal, Self

from pydantic import Field, model_validator

from sceneweaver.io import InputError, Place, dump_yaml, load_yaml, packaged, write_atomic
from sceneweaver.io.messages import path_name, show, suggest
from sceneweaver.scene.base import FrozenModel
from sceneweaver.scene.fields import Id, Name
from sceneweaver.scene.messages import FieldError

from .room_specs import Adjacency, AdjacencyKind, RoomSpec
from .room_types import room_type, room_types

MAX_ROOMS = 60
"""Rooms of a programme."""

MAX_STOREYS = 6
"""Storeys of a programme."""

Use = Literal["flat", "house", "clinic", "office"]


class Programme(FrozenModel):
    """Which rooms a plan has, how large they are, and what lies next to what.

    Examples:
        >>> from sceneweaver.plans import Programme
        >>> programme = Programme.from_graph(
        ...     {"hall": "entrance_hall", "living": ("living_kitchen", 26), "bed": "bedroom", "bath": "bathroom"},
        ...     [("hall", "living"), ("hall", "bed"), ("hall", "bath")],
        ... )
        >>> programme.entrance, programme.room("living").area
        ('hall', (20.8, 26.0, 33.8))

    Attributes:
        name: of the programme.
        use: flat, house, clinic or office: rules differ.
        rooms: in the order of the solver's arrays.
        adjacencies: between rooms, by id.
        storeys: how many.
        entrance: id of the room that the entrance's door leads to.
    """

    _noun = "programme"

    name: Name = "programme"
    use: Use = "flat"
    rooms: Annotated[tuple[RoomSpec, ...], Field(min_length=1, max_length=MAX_ROOMS)]
    adjacencies: Annotated[tuple[Adjacency, ...], Field(max_length=500)] = ()
    storeys: Annotated[int, Field(strict=True, ge=1, le=MAX_STOREYS)] = 1
    entrance: Id

    @model_validator(mode="before")
    @classmethod
    def _with_entrance(cls, data: Any) -> Any:
        """Where no entrance is named, the first room that is one by its type, else the first that is a way."""
        if not isinstance(data, Mapping) or data.get("entrance") is not None:
            return data
        rooms = data.get("rooms")
        if not isinstance(rooms, list | tuple):
            return data
        for role in ("entrance", "circulation", "public"):
            for room in rooms:
                name, kind = (room.id, room.type) if isinstance(room, RoomSpec) else _id_and_type(room)
                if kind in room_types() and role in room_types()[kind].roles:
                    return {**data, "entrance": name}
        return data

    @model_validator(mode="after")
    def _check(self) -> Self:
        ids = [room.id for room in self.rooms]
        for i, room in enumerate(self.rooms):
            if room.id in ids[:i]:
                raise FieldError(("rooms", i, "id"), f"is {show(room.id)}, as of room {ids.index(room.id)}; rename one")
            if room.storey is not None and room.storey >= self.storeys:
                known = f"storeys is {self.storeys}, so 0 to {self.storeys - 1}"
                raise FieldError(("rooms", i, "storey"), f"is {room.storey}; {known}")
        if self.entrance not in ids:
            raise FieldError(("entrance",), f"is {show(self.entrance)}{suggest(self.entrance, ids, what='rooms are')}")
        seen: dict[frozenset[str], Adjacency] = {}
        for i, adjacency in enumerate(self.adjacencies):
            for end in ("a", "b"):
                name = getattr(adjacency, end)
                if name not in ids:
                    raise FieldError(("adjacencies", i, end), f"is {show(name)}{suggest(name, ids, what='rooms are')}")
            if adjacency.a == adjacency.b:
                raise FieldError(("adjacencies", i), f": a and b are both {show(adjacency.a)}; give two rooms")
            pair = frozenset((adjacency.a, adjacency.b))
            if pair in seen and "apart" in {seen[pair].kind, adjacency.kind} and seen[pair].kind != adjacency.kind:
                both = f"{seen[pair].kind} and {adjacency.kind}"
                raise FieldError(("adjacencies", i), f": {adjacency.a} and {adjacency.b} are {both}; keep one of them")
            seen[pair] = adjacency
        return self

    @cached_property
    def index(self) -> dict[str, int]:
        """Number of each room by its id."""
        return {room.id: i for i, room in enumerate(self.rooms)}

    def room(self, room_id: str) -> RoomSpec:
        """The room of this id; InputError where there is none."""
        if room_id not in self.index:
            raise InputError(f"room {show(room_id)} is not in {self.name}{suggest(room_id, self.index)}")
        return self.rooms[self.index[room_id]]

    def with_storeys(self) -> Self:
        """The programme with a storey for each room, and with stairs: what `solve_plans` plans.

        Rooms without a storey go where their type usually lies, and else, largest first, to the storey with least
        floor; annexes that belong to one room go to its storey. Where no room is of type stairs, each storey gets one,
        ``stairs-0`` and so on, joined by an open passage to its first hall: stairwells lie one over the other.
        """
        if self.storeys == 1:
            return self._rebuilt(rooms=tuple(room.at_storey(0) for room in self.rooms))
        return self._placed()._with_stairs()

    def _placed(self) -> Self:
        placed = {room.id: room.storey for room in self.rooms if room.storey is not None}
        placed.setdefault(self.entrance, 0)
        usual = {"ground": 0, "upper": 1}
        neighbours = self._joined()
        for room in self.rooms:
            if room.id not in placed and room.kind.storey and not ("annex" in room.kind.roles and neighbours[room.id]):
                placed[room.id] = usual[room.kind.storey]
        floors = [sum(room.area[1] for room in self.rooms if placed.get(room.id) == s) for s in range(self.storeys)]
        for room in sorted(self.rooms, key=lambda r: (-r.area[1], r.id)):
            if room.id in placed:
                continue
            beside = [placed[n] for n in neighbours[room.id] if n in placed]
            storey = beside[0] if beside else floors.index(min(floors))
            placed[room.id] = storey
            floors[storey] += room.area[1]
        return self._rebuilt(rooms=tuple(room.at_storey(placed[room.id]) for room in self.rooms))

    def _with_stairs(self) -> Self:
        if any(room.type == "stairs" for room in self.rooms):
            return self
        rooms, adjacencies = list(self.rooms), list(self.adjacencies)
        for storey in range(self.storeys):
            name = f"stairs-{storey}"
            rooms.append(RoomSpec(id=name, type="stairs", area=room_type("stairs").area, storey=storey))
            ways = [r for r in self.rooms if r.storey == storey and r.kind.transit == "all"]
            ways.sort(key=lambda r: (r.id != self.entrance, "circulation" not in r.kind.roles))
            adjacencies += [Adjacency(a=ways[0].id, b=name, kind="open")] if ways else []
        return self._rebuilt(rooms=tuple(rooms), adjacencies=tuple(adjacencies))

    def _joined(self) -> dict[str, list[str]]:
        """Rooms that a door joins, by room."""
        pairs = [(x.a, x.b) for x in self.adjacencies if x.kind in ("door", "open") and x.hard]
        return {r.id: [b if a == r.id else a for a, b in pairs if r.id in (a, b)] for r in self.rooms}

    @classmethod
    def from_table(cls, rows: Iterable[Mapping[str, Any]], **fields: Any) -> Self:
        """A programme of a table: a row a room, with the fields of `RoomSpec`.

        Beside them a row may have ``doors``, ``open``, ``near`` and ``apart``: ids of rooms, in a list or in a text
        with commas. Empty cells count as missing, numbers may be texts, as CSV has them.

        Args:
            rows: one mapping a room.
            fields: of `Programme`: name, use, storeys, entrance, more adjacencies.
        """
        rooms: list[dict[str, Any]] = []
        adjacencies: list[Any] = list(fields.pop("adjacencies", ()))
        kinds: dict[str, AdjacencyKind] = {"doors": "door", "open": "open", "near": "near", "apart": "apart"}
        for number, row in enumerate(rows):
            if not isinstance(row, Mapping):
                raise InputError(f"rows[{number}]: is {show(row)}; give an object with id and type")
            cells = {str(key): _cell(str(key), value) for key, value in row.items() if value not in (None, "")}
            for column, kind in kinds.items():
                others = cells.pop(column, ())
                names = [n.strip() for n in others.split(",")] if isinstance(others, str) else list(others)
                for name in filter(None, names):
                    adjacencies.append({"a": str(cells.get("id")), "b": name, "kind": kind})
            rooms.append(cells)
        return cls(**{**fields, "rooms": rooms, "adjacencies": _once(adjacencies)})

    @classmethod
    def from_graph(
        cls, nodes: Mapping[str, Any], edges: Iterable[Sequence[Any] | Adjacency] = (), **fields: Any
    ) -> Self:
        """A programme of a bubble graph.

        Args:
            nodes: by id of the room its type, (type, area), or a mapping with fields of `RoomSpec`.
            edges: (a, b) for a door, or (a, b, kind).
            fields: of `Programme`: name, use, storeys, entrance.
        """
        if not isinstance(nodes, Mapping):
            raise InputError(f"nodes is {show(nodes)}; give an object of types by id")
        rooms: list[dict[str, Any]] = []
        for name, node in nodes.items():
            if isinstance(node, str):
                rooms.append({"id": name, "type": node})
            elif isinstance(node, Mapping):
                rooms.append({"id": name, **node})
            elif isinstance(node, list | tuple) and len(node) == 2:
                rooms.append({"id": name, "type": node[0], "area": node[1]})
            else:
                raise InputError(f"nodes.{name}: is {show(node)}; give a type, [type, area] or an object")
        return cls(**{**fields, "rooms": rooms, "adjacencies": list(edges)})

    @classmethod
    def load(cls, path: Place) -> Self:
        """A programme from a YAML (or JSON) file.

        Raises:
            InputError: one line that names the file, the field and the fix.
        """
        name = path_name(path)
        try:
            return cls._of(load_yaml(path))
        except InputError as error:
            raise error if str(error).startswith(name) else InputError(f"{name}: {error}") from None

    @classmethod
    def loads(cls, text: str) -> Self:
        """A programme from a YAML text."""
        from sceneweaver.io import parse_yaml

        return cls._of(parse_yaml(text, "programme"))

    @classmethod
    def example(cls, name: str) -> Self:
        """A programme that ships with the library; `programme_names` lists them."""
        if name not in programme_names():
            raise InputError(f"programme {show(name)} is not known{suggest(name, programme_names())}")
        return cls._of(packaged.yaml_data("sceneweaver.plans", "programmes", f"{name}.yaml"))

    def dumps(self) -> str:
        """The programme as YAML."""
        return dump_yaml(_plain(self.model_dump(exclude_none=True)), default_flow_style=None, width=120)

    def save(self, path: Place) -> None:
        """Write the programme as YAML, whole or not at all."""
        write_atomic(path, self.dumps())

    @classmethod
    def _of(cls, data: Any) -> Self:
        if not isinstance(data, Mapping):
            raise InputError(f"programme is {show(data)}; give an object with rooms and adjacencies")
        return cls.model_validate(dict(data))

    def _rebuilt(self, **changes: Any) -> Self:
        return type(self)(**{**{name: getattr(self, name) for name in type(self).model_fields}, **changes})


def programme_names() -> tuple[str, ...]:
    """Names of the programmes that ship with the library."""
    files = packaged.folder("sceneweaver.plans", "programmes").iterdir()
    return tuple(sorted(file.name.removesuffix(".yaml") for file in files if file.name.endswith(".yaml")))


def _id_and_type(room: Any) -> tuple[Any, Any]:
    return (room.get("id"), room.get("type")) if isinstance(room, Mapping) else (None, None)


def _plain(value: Any) -> Any:
    """Lists for tuples, as YAML's plain dumper wants them."""
    if isinstance(value, Mapping):
        return {key: _plain(item) for key, item in value.items()}
    return [_plain(item) for item in value] if isinstance(value, list | tuple) else value


def _cell(column: str, value: Any) -> Any:
    """A cell of a table, numbers in texts as such."""
    if column not in ("area", "side", "storey") or not isinstance(value, str):
        return value
    try:
        return int(value) if column == "storey" else float(value)
    except ValueError:
        return value


def _once(adjacencies: list[Any]) -> list[Any]:
    """Each pair and kind once: tables often say it in both rows."""
    seen: dict[Any, Any] = {}
    for item in adjacencies:
        adjacency = item if isinstance(item, Adjacency) else Adjacency.model_validate(item)
        key = (frozenset((adjacency.a, adjacency.b)), adjacency.kind)
        seen.setdefault(key, adjacency)
    return list(seen.values())
