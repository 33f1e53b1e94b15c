"""A room as a model writes it down: floor, groups and items, in the words of the knowledge base."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, ConfigDict, Field

from sceneweaver.assets import categories, resolve
from sceneweaver.knowledge import RoomType
from sceneweaver.knowledge.groups import expanded
from sceneweaver.knowledge.load import group_templates
from sceneweaver.llm import Reply

NAME = r"^[a-z][a-z0-9_]{0,39}$"


def _listed(value: Any) -> Any:
    """A list, of what small models write for one: null, or a single value."""
    return [] if value is None else [value] if isinstance(value, str | Mapping) else value


def _paired(value: Any) -> Any:
    """A range, of a single number."""
    plain = isinstance(value, int | float) and not isinstance(value, bool)
    return [value, value] if plain else value * 2 if isinstance(value, list) and len(value) == 1 else value


def _counted(value: Any) -> Any:
    """A count, which is one where nothing is said."""
    return [1, 1] if value is None else _paired(value)


def _related(value: Any) -> Any:
    """A relation, also as the files of rooms write it: "soft near bed"."""
    if not isinstance(value, str):
        return value
    words = value.split()
    soft = words[:1] == ["soft"]
    words = words[soft:]
    return {"type": words[0], "to": words[1] if len(words) > 1 else None, "soft": soft} if words else value


Pair = Annotated[list[float], BeforeValidator(_paired), Field(min_length=2, max_length=2)]
Counts = Annotated[list[int], BeforeValidator(_counted), Field(min_length=2, max_length=2)]
Listed = BeforeValidator(_listed)

SIDES = ("depth", "width", "height")


class PlaceReply(Reply):
    """One relation of an item."""

    type: str = Field(max_length=40, description="A relation of the catalogue")
    to: str | None = Field(default=None, max_length=40, description="Id of an item; wall, wall:far, window or door")
    soft: bool = Field(default=False, description="A wish, not a condition")
    params: Annotated[dict[str, Any], BeforeValidator(lambda value: {} if value is None else value)] = Field(
        default={}, max_length=8, description="Numbers of the relation, such as max [m]"
    )


class ItemReply(Reply):
    """One kind of object in the room."""

    model_config = ConfigDict(extra="forbid", frozen=True, populate_by_name=True)

    id: str = Field(pattern=NAME, description="A short name; relations use it")
    what: Annotated[list[str], Listed] = Field(
        min_length=1, max_length=8, description="Categories, the usual one first"
    )
    need: Literal["needed", "usual", "optional"] = "usual"
    count: Counts = Field(default=[1, 1], description="[least, most]")
    with_: str | None = Field(default=None, alias="with", max_length=40, description="Item that it goes with")
    depth: Pair | None = Field(default=None, description="[least, most] in m")
    width: Pair | None = Field(default=None, description="[least, most] in m")
    height: Pair | None = Field(default=None, description="[least, most] in m")
    mount: Literal["floor", "wall", "ceiling", "surface"] | None = Field(
        default=None, description="What holds it, where that is not as usual"
    )
    place: Annotated[list[Annotated[PlaceReply, BeforeValidator(_related)]], Listed] = Field(default=[], max_length=8)
    on: Annotated[list[str], Listed] = Field(default=[], max_length=8, description="Items that may carry it")
    top: str | None = Field(default=None, max_length=40, description="Arrangement on its top")
    fill: str | None = Field(default=None, max_length=40, description="Theme that fills its shelves")
    row: Literal["grid"] | None = Field(default=None, description="grid: several are set out in rows")


class GroupReply(Reply):
    """A group of furniture that is known by name."""

    model_config = ConfigDict(extra="forbid", frozen=True, populate_by_name=True)

    use: str = Field(max_length=40, description="Name of the group")
    as_: str = Field(default="", alias="as", max_length=20, description="Prefix of its ids, for a second use")
    drop: Annotated[list[str], Listed] = Field(default=[], max_length=20, description="Items of it that are not wanted")


class OpeningReply(Reply):
    """Doors or windows."""

    count: Counts = Field(default=[1, 1], description="[least, most]")
    width: Pair = Field(description="[least, most] in m")
    height: Pair = Field(description="[least, most] in m")
    sill: Pair | None = Field(default=None, description="[least, most] in m; windows only")


class FurnitureReply(Reply):
    """What a room holds."""

    groups: Annotated[list[GroupReply], Listed] = Field(default=[], max_length=12)
    items: list[ItemReply] = Field(min_length=1, max_length=40)


class ProgrammeReply(FurnitureReply):
    """What one room holds that was asked for in words."""

    kind: str = Field(max_length=60, description="What kind of room it is")
    area: float = Field(ge=2, le=400, description="Floor in m2")
    people: int | None = Field(default=None, ge=0, le=200, description="For how many people")
    style: str | None = Field(default=None, max_length=40, description="Style, where the request names none")


class RoomReply(FurnitureReply):
    """What rooms of a kind are like."""

    words: Annotated[list[str], Listed] = Field(default=[], max_length=8, description="Other names of such a room")
    description: str = Field(min_length=1, max_length=200, description="One sentence: what it is for")
    area: list[float] = Field(min_length=3, max_length=3, description="Least, usual and largest floor in m2")
    aspect: Pair = Field(default=[1.0, 1.5], description="Length by width, [least, most]")
    height: float = Field(default=2.6, ge=2.0, le=8.0, description="Ceiling in m")
    people: int = Field(default=2, ge=0, le=200)
    doors: OpeningReply
    windows: OpeningReply
    styles: Annotated[list[str], Listed] = Field(default=["modern", "rustic"], min_length=1, max_length=6)
    floor: Literal["wood", "tile", "carpet", "concrete", "stone"] = "wood"
    fill: float = Field(default=0.33, ge=0.1, le=0.45, description="Share of the floor under furniture")


def room_of(reply: FurnitureReply, **fields: Any) -> RoomType:
    """A kind of room with what a reply says it holds.

    Args:
        reply: groups and items.
        fields: all other fields of `RoomType`.

    Raises:
        InputError: where it names what is not there, with the line for the model.
    """
    return RoomType(**expanded({**fields, **furniture(reply)}, group_templates()))


def furniture(reply: FurnitureReply) -> dict[str, Any]:
    """Groups and items as the files of rooms have them."""
    groups = [{"use": g.use, **({"as": g.as_} if g.as_ else {}), "drop": list(g.drop)} for g in reply.groups]
    return {"groups": groups, "items": [_item(item) for item in _in_order(reply.items)]}


def kind_data(reply: RoomReply, name: str, words: Sequence[str], source: str) -> dict[str, Any]:
    """The data of a file for a kind of room.

    Args:
        reply: what a model wrote.
        name: of the room.
        words: its other names.
        source: where it comes from.
    """
    openings = {
        kind: {k: v for k, v in getattr(reply, kind).model_dump().items() if v is not None}
        for kind in ("doors", "windows")
    }
    openings["doors"].pop("sill", None)
    plain = ("description", "area", "aspect", "height", "people", "styles", "floor", "fill")
    own = {field: getattr(reply, field) for field in plain}
    return {"name": name, "words": list(words), "sources": [source], **own, **openings, **furniture(reply)}


def _item(item: ItemReply) -> dict[str, Any]:
    """An item as the files of rooms have it."""
    data: dict[str, Any] = {
        "id": item.id,
        "what": [*dict.fromkeys(named(noun) for noun in item.what)],
        "need": item.need,
        "count": list(item.count),
        "place": [_place(place) for place in item.place],
    }
    if item.on:
        data["on"] = list(item.on)
    sizes = [_cut(getattr(item, side), data["what"], axis) for axis, side in enumerate(SIDES)]
    if any(sizes):
        data["size"] = sizes
    optional = {"with": item.with_, "mount": item.mount, "top": item.top, "fill": item.fill, "row": item.row}
    return data | {key: value for key, value in optional.items() if value is not None}


def named(noun: str) -> str:
    """The category with a body that a noun means; the noun itself where none does."""
    match = resolve(noun[:60])
    return noun if match.generic or match.body not in categories() else match.body


def _cut(given: Pair | None, what: Sequence[str], axis: int) -> Pair | None:
    """A range of sizes [m] as far as such things have them; as it was given where none has."""
    known = [size.ranges[axis] for name in what if name in categories() and (size := categories()[name].size)]
    if given is None or not known or given[0] > given[1]:
        return given
    low, high = min(one[0] for one in known), max(one[1] for one in known)
    if given[1] < low or given[0] > high:
        return given
    return [max(given[0], low), min(given[1], high)]


def _place(place: PlaceReply) -> dict[str, Any]:
    """A relation as the files of rooms have it."""
    said: dict[str, Any] = {"type": place.type}
    if place.to not in (None, "", "any", "none"):
        said["to"] = place.to
    if place.soft:
        said["soft"] = True
    return said | ({"params": dict(place.params)} if place.params else {})


def _in_order(items: Sequence[ItemReply]) -> Iterable[ItemReply]:
    """The items, each after what it goes with and what it stands on, else as they came."""
    by_id: Mapping[str, ItemReply] = {item.id: item for item in items}
    done: dict[int, ItemReply] = {}

    def put(item: ItemReply, above: tuple[str, ...]) -> None:
        if id(item) in done:
            return
        for name in (item.with_, *item.on):
            if name in by_id and name not in above and name is not None:
                put(by_id[name], (*above, item.id))
        done[id(item)] = item

    for item in items:
        put(item, (item.id,))
    return done.values()
