"""What a request for a whole home says, read: a programme for its plan, and what each room's own request is to say."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from sceneweaver.io import InputError
from sceneweaver.language.model import Span, Unread
from sceneweaver.plans import Envelope, Profile, Programme, Rule, envelope_for
from sceneweaver.plans.programme import AdjacencyKind

INNER, TIGHT = 0.1, 0.98
"""Thickness of the walls between rooms [m], and share of the most floor of a home that its envelope is made for."""

HALL = 1.08
"""What `sceneweaver.plans.envelope_for` multiplies the floor of a programme without a hall with."""


@dataclass(frozen=True)
class RoomAsked:
    """A room of the programme, as its own request needs it.

    Attributes:
        id: of the room in the programme and in the home.
        noun: what its own request calls it.
        said: what the request calls it; its noun where it does not name it.
        whose: for whom it is ("two children"), empty where nobody is told.
        looks: what it is like ("bright", "red"), in the words of the request.
        wishes: what it is to have besides, in the words of the request.
        unwanted: things that it is not to have.
        size: "big", "small" or "" for a usual one.
        equal: whether it is to be as large as the others of its name.
        outside: whether a door of its own is to lead outside.
        area: (least, most) [m2] as it was said; None where it was not.
        least, most: floor [m2] that it was said to have at least and at most.
        storey: on which it was said to be, 0 the ground floor; None where it was not.
        daylight: whether it was said to have windows; None where it was not.
        assumed: whether the request does not name it.
        span: where the request names it.
    """

    id: str
    noun: str
    said: str = ""
    whose: str = ""
    looks: tuple[str, ...] = ()
    wishes: tuple[str, ...] = ()
    unwanted: tuple[str, ...] = ()
    size: str = ""
    equal: bool = False
    outside: bool = False
    area: tuple[float, float] | None = None
    least: float | None = None
    most: float | None = None
    storey: int | None = None
    daylight: bool | None = None
    assumed: bool = False
    span: Span | None = None


@dataclass(frozen=True)
class Understood:
    """Words of the request, and what became of them: ``kind`` is rooms, area, storeys, joint, people, request ..."""

    words: str
    kind: str
    row: str
    span: Span


@dataclass(frozen=True)
class JointAsked:
    """What the request says of rooms to each other: ids, or a ``place`` in their stead: entrance, street, front, back.

    ``how`` says what no adjacency does: "opposite" of each other, "not through" the room ``b`` on the way to ``a``.
    """

    a: tuple[str, ...]
    b: tuple[str, ...]
    kind: AdjacencyKind
    words: str
    place: str = ""
    how: str = ""


Status = Literal["met", "partly", "not met", "not understood"]


@dataclass(frozen=True)
class HomeDemand:
    """Something that a request asks for, as measured in a finished home.

    Attributes:
        kind: count, area, room_area, joint, outside, storeys, storey, profile, envelope, light, excluded, thing,
            style; words for what was not understood.
        words: what is asked for; of what was not understood, the words of the request.
        status: whether it is so.
        detail: the numbers.
    """

    kind: str
    words: str
    status: Status
    detail: str

    def to_dict(self) -> dict[str, str]:
        """As JSON data: words, kind, status, and what was found."""
        return {"words": self.words, "kind": self.kind, "status": self.status, "found": self.detail}


@dataclass(frozen=True)
class HomeRequest:
    """A request for a home, read.

    Attributes:
        text: the request.
        language: of it.
        use: flat, house, dental_practice, office ... (``uses.yaml``).
        programme: rooms, areas, storeys, adjacencies for the plan.
        profile: of rules that the plan has to keep: "base" or "accessible".
        rooms: what each room's own request is to say.
        joints: what was said of rooms to each other.
        counts: how many rooms of a kind were asked for in so many words, by type of the plan.
        people: how many live or work there; None where nothing tells it.
        styles: words for the style of all rooms.
        area: of all rooms together [m2]; least, most: what they are to have at least and at most, where that is said.
        width, depth: of the envelope [m].
        l_shape: whether the envelope is L-shaped.
        window_sides: how many sides may have windows.
        storeys: how many were asked for in so many words.
        doors, ways: least clear widths [m] of all doors, and of halls and corridors.
        excluded: types of rooms that are not wanted.
        understood: the words of the request with what became of them.
        assumed: what the request does not say and was chosen, one line each.
        unread: phrases that were not understood.
        remarks: what is said and is no demand: greetings, ages, reasons.
        notes: what else the user should know.
    """

    text: str
    language: str
    use: str
    programme: Programme
    profile: str = "base"
    rooms: tuple[RoomAsked, ...] = ()
    joints: tuple[JointAsked, ...] = ()
    counts: tuple[tuple[str, int], ...] = ()
    people: int | None = None
    styles: tuple[str, ...] = ()
    area: float | None = None
    least: float | None = None
    most: float | None = None
    width: float | None = None
    depth: float | None = None
    l_shape: bool = False
    window_sides: int | None = None
    storeys: int | None = None
    doors: float | None = None
    ways: float | None = None
    excluded: tuple[str, ...] = ()
    understood: tuple[Understood, ...] = ()
    assumed: tuple[str, ...] = ()
    unread: tuple[Unread, ...] = ()
    remarks: tuple[Unread, ...] = ()
    notes: tuple[str, ...] = ()

    def room(self, room_id: str) -> RoomAsked:
        """What is asked for the room of this id; InputError where there is none."""
        for room in self.rooms:
            if room.id == room_id:
                return room
        raise InputError(
            f"room '{room_id}' is none of the request; its rooms are {', '.join(r.id for r in self.rooms)}"
        )

    @property
    def rules(self) -> Profile:
        """The profile with a hard row for each width that is asked for.

        Examples:
            >>> from sceneweaver.language.homes import read_home
            >>> read_home("a two-bedroom flat, all doors 95 cm wide").rules.rule("asked-doors").least
            0.95
        """
        profile = Profile.named(self.profile)
        rows = [
            Rule(
                id=name, measure=measure, of=of, least=least, says=f"{what} are {least:g} m wide.", source="the request"
            )
            for name, measure, of, least, what in (
                ("asked-doors", "door_width", ("entrance-door", "inner-door"), self.doors, "Doors"),
                ("asked-ways", "passage", ("circulation", "-stairs"), self.ways, "Halls"),
            )
            if least is not None
        ]
        return profile.model_copy(update={"rows": (*profile.rows, *rows)}) if rows else profile

    def envelope(self, seed: int = 0) -> Envelope:
        """What the plan has to fit into: of the sides, the shape and the light that are asked for, and else as
        `sceneweaver.plans.envelope_for` chooses it by the ``seed``.

        Examples:
            >>> from sceneweaver.language.homes import read_home
            >>> envelope = read_home("a two-bedroom house on a plot of 6 m, windows only on two sides").envelope()
            >>> max(x for x, _ in envelope.outline), envelope.open_walls
            (6.0, (0, 2))
        """
        return self._limited(self._fitting(seed))

    def _limited(self, envelope: Envelope) -> Envelope:
        """An envelope whose rooms have no more floor together than the home may have at most."""
        import shapely

        if self.most is None:
            return envelope
        rooms = [room for room in self.programme.rooms if not {"outdoor", "stairs"} & room.kind.roles]
        net = sum(room.area[1] for room in rooms) / sum((room.area[1] ** 0.5 + INNER) ** 2 for room in rooms)
        have = shapely.Polygon(envelope.inner).area * envelope.storeys * net
        share = (TIGHT * self.most / have) ** 0.5
        if share >= 1.0:
            return envelope
        outline = tuple((int(x * share * 20) / 20, int(y * share * 20) / 20) for x, y in envelope.outline)
        return envelope.model_copy(update={"outline": outline})

    def _fitting(self, seed: int) -> Envelope:
        """The envelope of the sides, the shape and the light that are asked for."""
        chosen = envelope_for(self._without_hall() if self.area is not None else self.programme, seed)
        if not (self.width or self.depth or self.l_shape or self.window_sides):
            return chosen
        need = chosen.area if self.width is None or self.depth is None else self.width * self.depth
        cut = 0.14 if self.l_shape else 0.0
        full = need / (1 - cut)
        width = self.width or (full / self.depth if self.depth else (full * 1.2) ** 0.5)
        depth = self.depth or full / width
        width, depth = round(width * 20) / 20, round(depth * 20) / 20
        # light from the two short sides of a narrow plot, else from the south, and the north, and the west
        closed = {1: (1, 2, 3), 2: (1, 3), 3: (1,)}.get(self.window_sides or 4, ())
        fields = {"storeys": self.programme.storeys, "height": chosen.height}
        if not self.l_shape:
            return Envelope.rectangle(width, depth, closed=closed, entrance_wall=0 if closed else None, **fields)
        side = round((cut * width * depth) ** 0.5 * 20) / 20
        sides = (min(side, round(width / 2, 2)), min(side, round(depth / 2, 2)))
        number = {0: 0, 1: 1, 2: 4, 3: 5}
        return Envelope.l_shape(width, depth, cut=sides, closed=[number[k] for k in closed], **fields)

    def _without_hall(self) -> Programme:
        """The programme with as much less floor as an envelope adds for a hall where the programme has none: an area
        that was asked for holds all there is."""
        rooms = self.programme.rooms
        if len(rooms) <= 3 or any("circulation" in room.kind.roles for room in rooms):
            return self.programme
        smaller = [(min(r.area[0], r.area[1] / HALL), r.area[1] / HALL, r.area[2]) for r in rooms]
        rooms = tuple(r.model_copy(update={"area": a}) for r, a in zip(rooms, smaller, strict=True))
        return self.programme.model_copy(update={"rooms": rooms})
