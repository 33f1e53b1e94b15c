"""An envelope: the outer faces of a plan, the walls that may have windows, and the one with the entrance."""

from __future__ import annotations

import math
import random
from collections.abc import Iterable
from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from sceneweaver.io import InputError
from sceneweaver.io.messages import is_number, show
from sceneweaver.scene.base import FrozenModel
from sceneweaver.scene.fields import Length, Outline
from sceneweaver.scene.messages import FieldError

from .programme import MAX_STOREYS, Programme

INNER, OUTER = 0.10, 0.30
"""Thickness of walls between rooms and of those around the plan [m]."""

GRID = 0.001
"""Coordinates are multiples of this [m]."""

_MODULE = 0.05
"""Sides of chosen envelopes are multiples of this [m]."""

_LEAST_WINDOW_ROOM = 2.4
"""Length of an outer wall [m] that a room with daylight takes, where no least side is given."""

_TRIES = 200

Corner = Literal["south-west", "south-east", "north-east", "north-west"]


class Envelope(FrozenModel):
    """What a plan has to fit into; wall i runs from corner i to corner i + 1.

    Examples:
        >>> from sceneweaver.plans import Envelope
        >>> flat = Envelope.rectangle(10, 8, closed=(3,), entrance_wall=3)
        >>> flat.open_walls, flat.area, flat.inner[0]
        ((0, 1, 2), 80.0, (0.3, 0.3))

    Attributes:
        outline: outer faces [m], counter-clockwise, right angles only, on a grid of 1 mm; all storeys have the same.
        storeys: how many.
        open_walls: numbers of the walls that may have windows; the others are party walls.
        entrance_wall: number of the wall with the entrance's door; None: any.
        inner_wall, outer_wall: their thickness [m].
        height: of each storey between floor and ceiling [m].
    """

    _noun = "envelope"

    outline: Outline
    storeys: Annotated[int, Field(strict=True, ge=1, le=MAX_STOREYS)] = 1
    open_walls: tuple[int, ...]
    entrance_wall: int | None = None
    inner_wall: Length = INNER
    outer_wall: Length = OUTER
    height: Length = 2.6

    @model_validator(mode="after")
    def _check(self) -> Self:
        n = len(self.outline)
        for i, (x, y) in enumerate(self.outline):
            if max(abs(v / GRID - round(v / GRID)) for v in (x, y)) > 1e-6:
                raise FieldError(("outline", i), f"is {show([x, y])}; give whole millimetres")
            nx, ny = self.outline[(i + 1) % n]
            if (x != nx) == (y != ny):
                raise FieldError(("outline", i), f": wall {i} is oblique; walls run along x or y")
        for i, wall in enumerate(self.open_walls):
            if not 0 <= wall < n:
                raise FieldError(("open_walls", i), f"is {wall}; the outline has walls 0 to {n - 1}")
        if self.entrance_wall is not None and not 0 <= self.entrance_wall < n:
            raise FieldError(("entrance_wall",), f"is {self.entrance_wall}; the outline has walls 0 to {n - 1}")
        xs, ys = zip(*self.outline, strict=True)
        if min(max(xs) - min(xs), max(ys) - min(ys)) <= 2 * self.outer_wall:
            raise FieldError(("outer_wall",), f"is {self.outer_wall:g} m; nothing is left between the outer walls")
        return self

    @classmethod
    def rectangle(
        cls,
        width: float,
        depth: float,
        *,
        closed: Iterable[int] = (),
        entrance_wall: int | None = None,
        storeys: int = 1,
        height: float = 2.6,
    ) -> Self:
        """A rectangle, ``width`` along x and ``depth`` along y [m], its first corner at the origin.

        Args:
            width, depth: between outer faces [m].
            closed: walls without windows; 0 is south (-y), 1 east, 2 north, 3 west.
            entrance_wall: the wall with the entrance's door; None: any.
            storeys: how many.
            height: of each between floor and ceiling [m].
        """
        _require_lengths(width=width, depth=depth)
        w, d = _mm(width), _mm(depth)
        return cls(
            outline=((0.0, 0.0), (w, 0.0), (w, d), (0.0, d)),
            open_walls=tuple(i for i in range(4) if i not in set(closed)),
            entrance_wall=entrance_wall,
            storeys=storeys,
            height=height,
        )

    @classmethod
    def l_shape(
        cls,
        width: float,
        depth: float,
        *,
        cut: tuple[float, float],
        corner: Corner = "north-east",
        closed: Iterable[int] = (),
        entrance_wall: int | None = None,
        storeys: int = 1,
        height: float = 2.6,
    ) -> Self:
        """A rectangle without one of its corners; ``cut`` is width and depth [m] of what is missing.

        The walls are numbered from the south-western corner of the rectangle on, counter-clockwise.
        """
        if not isinstance(cut, list | tuple) or len(cut) != 2:
            raise InputError(f"cut is {show(cut)}; give width and depth of what is missing")
        _require_lengths(width=width, depth=depth, **{"cut[0]": cut[0], "cut[1]": cut[1]})
        w, d, a, b = _mm(width), _mm(depth), _mm(cut[0]), _mm(cut[1])
        if not (a < w and b < d):
            raise InputError(f"cut is {show(cut)}; it must be smaller than the envelope, {w:g} x {d:g} m")
        outlines = {
            "south-west": ((a, 0.0), (w, 0.0), (w, d), (0.0, d), (0.0, b), (a, b)),
            "south-east": ((0.0, 0.0), (_mm(w - a), 0.0), (_mm(w - a), b), (w, b), (w, d), (0.0, d)),
            "north-east": ((0.0, 0.0), (w, 0.0), (w, _mm(d - b)), (_mm(w - a), _mm(d - b)), (_mm(w - a), d), (0.0, d)),
            "north-west": ((0.0, 0.0), (w, 0.0), (w, d), (a, d), (a, _mm(d - b)), (0.0, _mm(d - b))),
        }
        if corner not in outlines:
            raise InputError(f"corner is {show(corner)}; corners are {', '.join(outlines)}")
        return cls(
            outline=outlines[corner],
            open_walls=tuple(i for i in range(6) if i not in set(closed)),
            entrance_wall=entrance_wall,
            storeys=storeys,
            height=height,
        )

    @property
    def area(self) -> float:
        """What the outer faces enclose [m2], of one storey."""
        return round(_area(self.outline), 6)

    @property
    def inner(self) -> tuple[tuple[float, float], ...]:
        """Faces of the outer walls towards the rooms [m], corner by corner of ``outline``."""
        n, t = len(self.outline), self.outer_wall
        corners: list[tuple[float, float]] = []
        for i in range(n):
            # Each corner moves by the inward normals (to the left of the way) of both of its walls.
            dx = dy = 0.0
            for a, b in ((self.outline[i - 1], self.outline[i]), (self.outline[i], self.outline[(i + 1) % n])):
                length = math.dist(a, b)
                dx -= (b[1] - a[1]) / length * t
                dy += (b[0] - a[0]) / length * t
            corners.append((_mm(self.outline[i][0] + dx), _mm(self.outline[i][1] + dy)))
        return tuple(corners)

    @property
    def closed_walls(self) -> tuple[int, ...]:
        """Numbers of the party walls."""
        return tuple(i for i in range(len(self.outline)) if i not in self.open_walls)


def envelope_for(programme: Programme, seed: int = 0) -> Envelope:
    """An envelope that the programme fits into: equal seeds choose the same one.

    It is as large as the rooms at their target, the walls between and around them, a hall where the programme has
    none, and stairs. Flats and offices have party walls without windows on one or two sides, the entrance in one of
    them; houses and clinics stand free. The walls with windows are long enough for all rooms that need one.

    Args:
        programme: what has to fit.
        seed: chooses proportions, sides and shape.

    Raises:
        InputError: seed is no whole number.
    """
    if isinstance(seed, bool) or not isinstance(seed, int):
        raise InputError(f"seed is {show(seed)}; give a whole number")
    rng = random.Random(f"envelope {seed} {programme.name}")
    placed = programme.with_storeys()
    clear = max(_clear(placed, storey) for storey in range(placed.storeys))
    facade = max(_facade(placed, storey) for storey in range(placed.storeys))
    best: tuple[float, Envelope] | None = None
    for _ in range(_TRIES):
        envelope = _proposal(placed, clear, rng)
        lack = facade - sum(_clear_length(envelope, wall) for wall in envelope.open_walls)
        if best is None or lack < best[0]:
            best = (lack, envelope)
        if lack <= 0:
            return envelope
    assert best is not None
    return best[1]


def _proposal(programme: Programme, clear: float, rng: random.Random) -> Envelope:
    """A random envelope with that area between its outer walls."""
    free = programme.use in ("house", "clinic")
    aspect = rng.uniform(1.0, 1.5) if free else rng.uniform(0.9, 1.7)
    l_shaped = clear >= 60 and rng.random() < 0.25
    missing = rng.uniform(0.08, 0.16) if l_shaped else 0.0
    full = clear / (1 - missing)
    width = _module(math.sqrt(full * aspect) + 2 * OUTER)
    depth = _module(full / (width - 2 * OUTER) + 2 * OUTER)
    if free:
        closed, entrance = [], None
    else:
        # The party walls: the one to the stairwell, with the entrance, and sometimes the neighbour's beside it.
        entrance = rng.randrange(4)
        closed = [entrance, (entrance + rng.choice((1, 2, 3))) % 4] if rng.random() < 0.5 else [entrance]
    if not l_shaped:
        return Envelope.rectangle(width, depth, closed=closed, entrance_wall=entrance, storeys=programme.storeys)
    side = math.sqrt(missing * full)
    cut = (_module(side), _module(side))
    # The missing corner: walls 0 and 1 of the rectangle keep their numbers, 2 and 3 become 4 and 5.
    number = {0: 0, 1: 1, 2: 4, 3: 5}
    return Envelope.l_shape(
        width,
        depth,
        cut=cut,
        closed=[number[wall] for wall in closed],
        entrance_wall=None if entrance is None else number[entrance],
        storeys=programme.storeys,
    )


def _clear(programme: Programme, storey: int) -> float:
    """Area between the outer walls [m2] that the rooms of a storey need, each with half of the walls around it."""
    rooms = [room for room in programme.rooms if room.storey == storey and "outdoor" not in room.kind.roles]
    floor = sum((math.sqrt(room.area[1]) + INNER) ** 2 for room in rooms)
    # Without a hall of its own a plan of more than three rooms needs one all the same.
    return floor * (1.0 if len(rooms) <= 3 or any("circulation" in room.kind.roles for room in rooms) else 1.08)


def _facade(programme: Programme, storey: int) -> float:
    """Length of outer walls [m] that the rooms of a storey with daylight need."""
    needy = [room for room in programme.rooms if room.storey == storey and room.needs_daylight]
    return 1.35 * sum(max(room.side or 0.0, _LEAST_WINDOW_ROOM) + INNER for room in needy)


def _clear_length(envelope: Envelope, wall: int) -> float:
    a, b = envelope.outline[wall], envelope.outline[(wall + 1) % len(envelope.outline)]
    return math.dist(a, b) - 2 * envelope.outer_wall


def _area(outline: tuple[tuple[float, float], ...]) -> float:
    return sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(outline, outline[1:] + outline[:1], strict=True)) / 2


def _require_lengths(**lengths: object) -> None:
    for name, value in lengths.items():
        if not is_number(value) or not value > 0:  # pyright: ignore[reportOperatorIssue] - is_number says what it is
            raise InputError(f"{name} is {show(value)}; give metres above 0")


def _mm(value: float) -> float:
    return round(value, 3)


def _module(value: float) -> float:
    return _mm(round(value / _MODULE) * _MODULE)
