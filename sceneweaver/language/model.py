"""The scene graph of a request: what is to be there, what it is like, and how it stands to each other.

One contract for whoever reads requests (the offline reader, a model) and whoever works from them (tools, critic,
planner, report). Each item has an ``id`` and the ``span`` of the text that it came from, so that what became of it can
be shown beside the words.
"""

from __future__ import annotations

from typing import Any, Literal, NamedTuple

from pydantic import Field

from sceneweaver.scene.base import FrozenModel

Shape = Literal["rectangle", "L", "T", "U", "round"]

AttributeKind = Literal["color", "material", "finish", "style", "shape", "size", "part", "state", "other"]

RelationType = Literal[
    "next_to",
    "near",
    "far_from",
    "side_by_side",
    "left_of",
    "right_of",
    "in_front_of",
    "behind",
    "flanking",
    "between",
    "around",
    "at",
    "along",
    "at_head",
    "at_foot",
    "centered_on",
    "against",
    "leaning_on",
    "on",
    "inside",
    "hanging_from",
    "above",
    "below",
    "facing",
    "opposite",
    "parallel",
    "aligned",
    "back_to_back",
]
"""What a request says of where something is.

Sides are those of the target as seen by who looks at its front: right of a bed is the right-hand side of who
stands at its foot. ``next_to`` is beside it with hardly a gap, ``near`` within a step, ``flanking`` beside both sides.
``at`` a table is sitting at it; ``along`` is its long side, ``at_head`` and ``at_foot`` are its ends. ``opposite`` is
across the room or the table from it, ``facing`` turned to it. With the place ``corner`` or ``middle`` the type is
``at``.
"""

Pattern = Literal[
    "row",
    "rows",
    "grid",
    "circle",
    "semicircle",
    "u",
    "back_to_back",
    "stack",
    "cluster",
    "islands",
    "sides",
    "walls",
    "between",
    "right_angle",
    "head_to_head",
    "end_to_end",
    "outside",
    "inside",
    "wall",
]
"""How things are set out."""

Activity = Literal["sit", "sleep", "work", "eat", "stand", "wait", "use"]
"""What people do in a room; ``use`` where nothing is said."""

ANYTHING = "anything"
"""Category of an exclusion of whatever the request does not name for a place: "nothing on the bench"."""

PLACES = ("wall", "window", "door", "corner", "middle", "half", "ceiling", "floor", "room")
"""Targets that are parts of the room. ``wall:left`` (right, far, near, north ...) is as seen from the door, or by
compass with y north; ``wall:long``, ``wall:short`` (an end of the room), ``wall:side`` (left or right), ``wall:window``
and ``wall:door`` are any such wall, ``wall:niche``, ``wall:bay`` and ``wall:breast`` parts of walls that stand back or
forward, ``wall:beside_breast`` and ``wall:breast_opening`` what is beside a breast and open in it; ``corner:far+left``
is the corner of these two, ``corner:far`` one of two. ``half:left`` (or another side) is the half of the floor
there."""


class Span(NamedTuple):
    """Characters [start, end) of the request."""

    start: int
    end: int


class Attribute(FrozenModel):
    """A word about something: a colour, a material, a shape ..."""

    id: str = ""
    kind: AttributeKind
    value: str = Field(description="The word in the terms of the taxonomy, such as 'grey' for 'ash-coloured'")
    words: str = Field(default="", description="As it was written")
    count: tuple[int, int] | None = Field(default=None, description="Of how many of the things it is said; None: all")
    span: Span | None = None


class Entity(FrozenModel):
    """Objects of one kind that a request names."""

    id: str = Field(description="Name in this graph; relations use it. The category, with a number when it recurs")
    noun: str = Field(description="As it was written")
    category: str = Field(description="Category of the taxonomy, or of a generic body that bears the noun as its label")
    generic: bool = Field(default=False, description="Whether no category fits and a labelled body stands for it")
    count: tuple[int, int] | None = Field(default=None, description="Least and most; None when nothing was said")
    color: str | None = None
    material: str | None = None
    style: str | None = None
    size: tuple[float | None, float | None, float | None] = Field(
        default=(None, None, None), description="Depth, width, height [m] where given"
    )
    scale: float = Field(default=1.0, description="1.2 for large, 0.8 for small, relative to the usual size")
    words: tuple[str, ...] = Field(default=(), description="Other words about it, for choosing an asset")
    unnamed: tuple[str, ...] = Field(
        default=(), description="Words of its name that its category does not tell: 'jury' of a 'jury box'"
    )
    attributes: tuple[Attribute, ...] = Field(default=(), description="All that was said of what it is like, in order")
    implied: bool = Field(default=False, description="Whether only a part of the room ('dining area') called for it")
    sized_for_people: bool = Field(
        default=False,
        description="Whether its size follows from the number of people alone, so that none was asked for",
    )
    span: Span | None = None

    @property
    def standing(self) -> bool:
        """Whether it is said to be for people who stand, as a standing table."""
        return any(one.value == "standing" for one in self.attributes)


class StatedRelation(FrozenModel):
    """A relation that a request names.

    ``targets`` are ids of entities or `PLACES`; ``between`` two things has two. ``count`` is how many of the subjects
    it is said of, with ``each`` for every single one of the targets (or sides): of six chairs two on each long side.
    ``nth`` is the one of several targets that is meant: a coat on the third hook.
    """

    id: str = ""
    type: RelationType
    subject: str
    targets: tuple[str, ...] = ()
    count: tuple[int, int] | None = Field(default=None, description="Least and most of the subjects; None: all")
    each: bool = False
    side: Literal["long", "short", "left", "right"] | None = Field(
        default=None, description="Which sides of the target"
    )
    nth: int = Field(
        default=0,
        description="Which of the targets it is said of, in order along their row from either end: 3 for the third, -1 "
        "for the last; 0: any",
    )
    params: dict[str, Any] = Field(default={}, description="Distances that were given: min, max [m]")
    words: str = Field(default="", description="As it was written")
    implied: bool = Field(default=False, description="Whether it follows from 'with' or a part of the room alone")
    span: Span | None = None


class Exclusion(FrozenModel):
    """What must not be there: nowhere in the room or, with a ``relation``, not there ("no shelf above the bed").

    Beside the ``categories`` it may be whatever is of some ``materials``, ``colors`` or ``styles``, or hangs where a
    ``mount`` says; ``within`` are the things of which alone that is said ("no black chairs").

    An entity that must not stand somewhere ("the wardrobe may not be in front of the window") is named by ``subject``.
    The category `ANYTHING` with a relation is all that the request does not place there ("nothing on the bench").
    """

    id: str = ""
    words: str
    categories: tuple[str, ...] = Field(description="Categories, or groups of them")
    relation: RelationType | None = Field(default=None, description="How they must not stand to the targets")
    targets: tuple[str, ...] = Field(default=(), description="Ids of entities or `PLACES`, of the relation")
    subject: str = Field(default="", description="The entity that it is said of, by id; else all of the categories")
    others: bool = Field(default=False, description="Whether what the request names may be: 'no other seats'")
    materials: tuple[str, ...] = Field(
        default=(), description="Names of materials; nothing may be of one that the request does not name"
    )
    colors: tuple[str, ...] = Field(
        default=(), description="Basic colours that nothing may have, unless the request says so of it"
    )
    styles: tuple[str, ...] = Field(default=(), description="Styles that nothing may have")
    within: tuple[str, ...] = Field(
        default=(),
        description="Categories, or groups, of which alone materials and colours are unwanted; empty: of the room too",
    )
    mount: Literal["", "wall", "ceiling"] = Field(
        default="", description="Where nothing may hang that the request does not name"
    )
    span: Span | None = None


class StatedOpening(FrozenModel):
    """Doors, windows or parts of the shell of one kind that a request describes.

    ``wall`` is as seen from the first door (left, right, far, near), by compass, by length (long, short), or opposite
    another opening; ``at`` is where along it. Slopes, sunken floors, steps, windows in roofs, openings in floors and
    shapes of ceilings are told and not built.
    """

    id: str = ""
    part: Literal[
        "door",
        "window",
        "niche",
        "breast",
        "roof_window",
        "slope",
        "sunk_floor",
        "ceiling_shape",
        "steps",
        "floor_opening",
    ]
    count: int = 1
    wall: Literal["left", "right", "side", "far", "near", "north", "south", "east", "west", "long", "short", "any"] = (
        "any"
    )
    run: Literal["long", "short", "any"] = Field(
        default="any", description="Whether its wall is a long or a short one, where a side is said as well"
    )
    at: Literal["middle", "left", "right", "corner", "along", "any"] = Field(
        default="any", description="'along' runs over the length of the wall; left and right as seen from the room"
    )
    wall_length: float | None = Field(default=None, description="Length [m] by which its wall was told")
    opposite: str = Field(
        default="", description="Another opening, by id, in whose opposite wall it is; 'door' is the first door"
    )
    width: float | None = Field(default=None, description="[m]")
    height: float | None = Field(default=None, description="[m]")
    sill: float | None = Field(default=None, description="[m]")
    depth: float | None = Field(default=None, description="Of a niche or a breast [m]")
    features: tuple[str, ...] = Field(default=(), description="Double, sliding, to a bathroom, stained glass, ...")
    words: str = ""
    span: Span | None = None


class FreeArea(FrozenModel):
    """Floor that is to stay free.

    A ``rectangle`` of two sides or a ``circle`` is anywhere, or at its ``targets``; a ``clearance`` is a width on the
    sides of its first target; a ``gap`` lies between two targets (or between all of one); a ``path`` leads from the
    first target to the second, or from the door to everything where it has none.
    """

    id: str = ""
    kind: Literal["rectangle", "circle", "clearance", "gap", "path"]
    size: tuple[float, float] = Field(description="Sides, or diameter twice, or least width twice [m]")
    most: float | None = Field(default=None, description="Largest width [m], where one was given")
    targets: tuple[str, ...] = Field(default=(), description="Ids of entities, or `PLACES`")
    side: Literal["front", "back", "left", "right", "sides", "long", "around", "any"] = Field(
        default="any", description="Of its first target; 'sides' are left and right, 'long' both that are long"
    )
    words: str = ""
    span: Span | None = None


class Capacity(FrozenModel):
    """How many people do something in the room, and what each of them has for their own."""

    id: str = ""
    people: int = Field(description="0: all that the request speaks of")
    activity: Activity
    target: str = Field(default="", description="The entity at which they do it, by id; empty: the room")
    each: bool = Field(default=False, description="Whether so many are at each of the targets, not at all together")
    own: tuple[tuple[str, int], ...] = Field(
        default=(), description="Entities, by id, with how many of them each person has"
    )
    words: str = ""
    span: Span | None = None


class Arrangement(FrozenModel):
    """How things of one kind stand to each other.

    A ``cluster`` is one of ``groups`` of ``columns`` things, ``around`` something where that is said. ``sides`` are
    numbers at opposite sides of what they are ``around`` (or all four: front, back, left, right), or of an aisle where
    nothing is said; of ``walls`` at either of the walls named by ``around``. ``between`` has one of them in each gap of
    what they are ``around``. At a ``right_angle`` stand two of a kind, or one of it and
    ``others``. Seats are ``outside`` or ``inside`` of a U of tables. A ``wall`` of things is a
    row over most of one.
    """

    id: str = ""
    entity: str
    pattern: Pattern
    others: tuple[str, ...] = Field(default=(), description="What else takes part: entities, by id")
    rows: int | None = Field(default=None, description="One behind the other; of a stack: one on the other")
    columns: int | None = Field(default=None, description="In each row or group")
    groups: int | None = Field(default=None, description="Groups, or stacks")
    sides: tuple[int, ...] = Field(default=(), description="How many are on one side, and on the other")
    spacing: float | None = Field(default=None, description="Clear between neighbours, or rows of one column [m]")
    pitch: float | None = Field(default=None, description="Between the middles of neighbours [m]")
    at_least: bool = Field(default=False, description="Whether the pitch may be more")
    aisle: float | None = Field(default=None, description="Way through the middle, from front to back [m]")
    upright: bool = Field(default=False, description="Whether rows are one above the other, at a wall")
    height: float | None = Field(default=None, description="Up to which a stack reaches [m]")
    around: str = Field(default="", description="What each group, or the circle, is around: an entity, by id")
    facing: str = Field(default="", description="What they look at: an entity, one of `PLACES`, or 'each other'")
    words: str = ""
    span: Span | None = None
    more: tuple[Span, ...] = Field(default=(), description="Further words of it, elsewhere in the request")


class View(FrozenModel):
    """What people see from their seats, or have at their backs.

    They ``see`` what is not behind them, ``face`` what is before them; what is ``not_back_to`` them may be at a side.
    """

    id: str = ""
    entity: str = Field(default="", description="The seats, by id; empty: all of the room")
    target: str = Field(description="An entity, by id, one of `PLACES`, or 'each other'")
    kind: Literal["see", "face", "not_back_to", "back_to"]
    words: str = ""
    span: Span | None = None


class Amount(FrozenModel):
    """Things of which there are many: ``many`` of them, or so that they are all over the room or a part of it."""

    id: str = ""
    entity: str
    spread: Literal["many", "everywhere", "surfaces", "floor", "walls"]
    least: int | None = Field(default=None, description="At least so many, where that is told")
    words: str = ""
    span: Span | None = None


class StatedFinish(FrozenModel):
    """What a part of the room is finished in. Of walls in two colours the lower one is ``lower``, a band of tiles
    ``tiled``; ``everything`` is all that is there, but for what has a colour of its own."""

    id: str = ""
    part: Literal[
        "walls", "accent", "lower", "tiled", "panels", "floor", "ceiling", "beams", "doors", "furniture", "everything"
    ]
    material: str | None = Field(default=None, description="As `scene.RoomFinish` names it")
    color: str | None = Field(default=None, description="A colour, or a finish of wood")
    second: str | None = Field(default=None, description="The other colour, of checks, stripes or everything")
    pattern: str | None = Field(default=None, description="As `scene.FloorFinish` and `scene.RoomFinish` name it")
    high: float | None = Field(default=None, description="Up to which height [m]")
    where: Literal["any", "left", "right", "far", "near", "long", "short"] = Field(
        default="any", description="Which wall an accent is on, as seen from the door"
    )
    words: str = ""
    span: Span | None = None


class StatedLook(FrozenModel):
    """How the whole room looks: a row of `sceneweaver.knowledge.looks`, by its name."""

    id: str = ""
    name: str = Field(description="Of the row; empty where only the last year is said")
    years: tuple[int, int] | None = Field(default=None, description="First and last year of the time that is meant")
    color: str | None = Field(default=None, description="Colour of the light that is named")
    words: str = ""
    span: Span | None = None


class StatedMeasure(FrozenModel):
    """A length that is said of things: an extent, or the height of a part of them or of where they are.

    ``length`` is that of the longer side in plan, ``side`` that of both; ``top``, ``seat``, ``centre``, ``bottom`` and
    ``upper`` are heights above the floor, ``placed`` is where a thing hangs or stands, ``ceiling`` what is left to it.
    ``lowest`` is the height of the top of what stands, and of the lower edge of what hangs; ``knee`` is the clear
    height below a top, at the side where there is most.

    With ``categories`` it is a limit on all things of these kinds, whether or not the request names them: none of them
    is beyond it ("no shelf above 137 cm").
    """

    id: str = ""
    entity: str = Field(default="", description="The entity, by id; empty: all worktops of the room")
    categories: tuple[str, ...] = Field(
        default=(), description="Categories, or groups, of all of which it is a limit; 'object': of all things"
    )
    on: str = Field(default="", description="What the things of a limit stand on, by id; empty: wherever they are")
    quantity: Literal[
        "depth",
        "width",
        "length",
        "height",
        "diameter",
        "side",
        "top",
        "seat",
        "centre",
        "bottom",
        "upper",
        "placed",
        "ceiling",
        "lowest",
        "knee",
    ]
    low: float | None = Field(default=None, description="Least [m]; the same as the largest where one was given")
    high: float | None = Field(default=None, description="Largest [m]")
    vague: bool = Field(default=False, description="Whether it is about so much")
    words: str = ""
    span: Span | None = None

    @property
    def wanted(self) -> float:
        """A length [m] that is as asked, by the ends alone."""
        ends = [end for end in (self.low, self.high) if end is not None]
        return sum(ends) / len(ends)


class Unread(FrozenModel):
    """Words that were not understood."""

    words: str
    span: Span | None = None


class SceneGraph(FrozenModel):
    """A request, read. Nothing of it is lost: what was not understood stands under ``unread``."""

    text: str
    room_type: str | None = Field(default=None, description="Kind of room, a name of the knowledge base")
    room_words: str = Field(default="", description="The words that named it")
    other_rooms: tuple[str, ...] = Field(default=(), description="Kinds of further rooms that the request names")
    shape: Shape | None = None
    size: tuple[float, float] | None = Field(default=None, description="Floor [m], longer side first")
    wing: tuple[float, float] | None = Field(
        default=None, description="Sides [m] of what sticks out of a floor of that size, at an end of a long side"
    )
    area: float | None = Field(default=None, description="Floor [m2]")
    height: float | None = Field(default=None, description="Of the ceiling [m]")
    scale: float = Field(default=1.0, description="1.3 for a large room, 0.75 for a small one")
    people: int | None = None
    for_whom: tuple[str, ...] = Field(default=(), description="child, teenager, couple, guest ... as it was written")
    style: str | None = None
    looks: tuple[StatedLook, ...] = Field(default=(), description="Styles, times, themes, moods and light of the room")
    finishes: tuple[StatedFinish, ...] = Field(
        default=(), description="What walls, floor and ceiling are said to be of"
    )
    colors: tuple[str, ...] = ()
    windows: int | None = None
    doors: int | None = None
    density: Literal["sparse", "normal", "full"] = "normal"
    entities: tuple[Entity, ...] = ()
    relations: tuple[StatedRelation, ...] = ()
    exclusions: tuple[Exclusion, ...] = ()
    openings: tuple[StatedOpening, ...] = ()
    free_areas: tuple[FreeArea, ...] = ()
    capacities: tuple[Capacity, ...] = ()
    arrangements: tuple[Arrangement, ...] = ()
    views: tuple[View, ...] = ()
    amounts: tuple[Amount, ...] = ()
    measures: tuple[StatedMeasure, ...] = ()
    only: bool = Field(default=False, description="Nothing but what is named: 'only', 'just', 'nothing else'")
    unread: tuple[Unread, ...] = ()
    notes: tuple[str, ...] = Field(default=(), description="What was assumed, corrected or contradicts itself")

    @property
    def without(self) -> tuple[str, ...]:
        """Categories or groups that must be nowhere in the room."""
        return tuple(dict.fromkeys(c for e in self.exclusions if e.relation is None for c in e.categories))

    def finish_of(self, part: str) -> StatedFinish | None:
        """What is said of a part of the room."""
        return next((one for one in self.finishes if one.part == part), None)

    @property
    def year(self) -> int | None:
        """The last year of the time that the room is of; None where it is of today."""
        years = [look.years[1] for look in self.looks if look.years is not None]
        return min(years, default=None)

    def entity(self, name: str) -> Entity | None:
        """The entity of that id; None for a place."""
        return next((e for e in self.entities if e.id == name), None)
