# Written by tests/building/builder_stub.py from the relation catalogue; a test compares the two.
# ruff: noqa: A002 - names of parameters as the catalogue has them
from collections.abc import Sequence
from typing import Any, Literal, TypeAlias

from sceneweaver.assets import Library
from sceneweaver.assets.asset import Mount
from sceneweaver.scene import Named, Room, Scene, SceneObject
from sceneweaver.scene.room import Swing

Wall: TypeAlias = int | str | bool
Thing: TypeAlias = Named
Things: TypeAlias = Thing | Sequence[Thing]
Range: TypeAlias = tuple[float, float]

def build(
    room: Room,
    *,
    name: str = "scene",
    style: str | None = None,
    seed: int = 0,
    library: Library | None = None,
) -> SceneBuilder: ...

class SceneBuilder:
    notes: list[str]
    def __init__(
        self,
        room: Room,
        *,
        name: str = "scene",
        style: str | None = None,
        seed: int = 0,
        library: Library | None = None,
    ) -> None: ...
    @classmethod
    def of(
        cls, scene: Scene, *, style: str | None = None, seed: int = 0, library: Library | None = None
    ) -> SceneBuilder: ...
    @property
    def room(self) -> Room: ...
    @property
    def objects(self) -> tuple[ObjectHandle, ...]: ...
    def scene(self) -> Scene: ...
    def add_door(
        self,
        wall: int | str = 0,
        *,
        at: float = 0.5,
        width: float = 0.9,
        height: float = 2.0,
        swing: Swing = "in-left",
        name: str | None = None,
    ) -> str: ...
    def add_window(
        self,
        wall: int | str = 0,
        *,
        at: float = 0.5,
        width: float = 1.2,
        height: float = 1.2,
        sill: float = 0.9,
        name: str | None = None,
    ) -> str: ...
    def add(
        self,
        what: str | SceneObject,
        *,
        name: str | None = None,
        at: tuple[float, float] | None = None,
        turn: float = 0.0,
        depth: float | None = None,
        width: float | None = None,
        height: float | None = None,
        on: Thing | None = None,
        inside: Thing | None = None,
        surface: str | None = None,
        mount: Mount | None = None,
        fixed: bool = False,
        hard: bool = True,
        seed: int | None = None,
        frame: Literal["own", "viewer"] | None = None,
        against: Wall | None = None,
        against_wall: Wall | None = None,
        side_against_wall: Wall | None = None,
        front_against: Things | None = None,
        front_to_front: Things | None = None,
        leftright_to_leftright: Things | None = None,
        side_by_side: Things | None = None,
        back_to_back: Things | None = None,
        on_floor: bool | None = None,
        on_top: Things | None = None,
        near: Things | None = None,
        distance: Things | None = None,
        facing: Things | None = None,
        aligned: Things | None = None,
        parallel: Things | None = None,
        left_of: Things | None = None,
        right_of: Things | None = None,
        in_front_of: Things | None = None,
        behind: Things | None = None,
        centered_on: Things | None = None,
        in_corner: bool | None = None,
        at_window: str | bool | None = None,
        between: tuple[Thing, Thing] | None = None,
        around: Things | None = None,
        away_from_door: str | bool | None = None,
        above: Things | None = None,
        below: Things | None = None,
        same_height: Things | None = None,
        seated_at: Things | None = None,
        next_to: Things | None = None,
        arranged: Things | None = None,
        run_on: Things | None = None,
        in_middle: bool | None = None,
        over: Things | None = None,
        near_window: str | bool | None = None,
        near_door: str | bool | None = None,
        across_from: Things | None = None,
        facing_door: str | bool | None = None,
        off_walls: bool | None = None,
        on_grid: bool | None = None,
        beside: Things | None = None,
    ) -> ObjectHandle: ...
    def add_many(
        self,
        count: int,
        what: str,
        *,
        at: tuple[float, float] | None = None,
        turn: float = 0.0,
        depth: float | None = None,
        width: float | None = None,
        height: float | None = None,
        on: Thing | None = None,
        inside: Thing | None = None,
        surface: str | None = None,
        mount: Mount | None = None,
        fixed: bool = False,
        hard: bool = True,
        seed: int | None = None,
        frame: Literal["own", "viewer"] | None = None,
        against: Wall | None = None,
        against_wall: Wall | None = None,
        side_against_wall: Wall | None = None,
        front_against: Things | None = None,
        front_to_front: Things | None = None,
        leftright_to_leftright: Things | None = None,
        side_by_side: Things | None = None,
        back_to_back: Things | None = None,
        on_floor: bool | None = None,
        on_top: Things | None = None,
        near: Things | None = None,
        distance: Things | None = None,
        facing: Things | None = None,
        aligned: Things | None = None,
        parallel: Things | None = None,
        left_of: Things | None = None,
        right_of: Things | None = None,
        in_front_of: Things | None = None,
        behind: Things | None = None,
        centered_on: Things | None = None,
        in_corner: bool | None = None,
        at_window: str | bool | None = None,
        between: tuple[Thing, Thing] | None = None,
        around: Things | None = None,
        away_from_door: str | bool | None = None,
        above: Things | None = None,
        below: Things | None = None,
        same_height: Things | None = None,
        seated_at: Things | None = None,
        next_to: Things | None = None,
        arranged: Things | None = None,
        run_on: Things | None = None,
        in_middle: bool | None = None,
        over: Things | None = None,
        near_window: str | bool | None = None,
        near_door: str | bool | None = None,
        across_from: Things | None = None,
        facing_door: str | bool | None = None,
        off_walls: bool | None = None,
        on_grid: bool | None = None,
        beside: Things | None = None,
    ) -> list[ObjectHandle]: ...
    def relate(self, subject: Thing, type: str, target: Any = True, *, hard: bool = True, **params: Any) -> None: ...
    def remove(self, what: Thing, *, cascade: bool = False) -> None: ...

class ObjectHandle:
    id: str
    def __init__(self, builder: SceneBuilder, name: str) -> None: ...
    @property
    def object(self) -> SceneObject: ...
    def against_wall(
        self,
        target: Wall = True,
        /,
        *,
        hard: bool = True,
        gap: Range = ...,
        overlap: float = ...,
        degrees: float = ...,
        door_walls: Literal["allowed", "avoided"] = ...,
        middle: float = ...,
    ) -> ObjectHandle:
        """The back face is toward the wall and close to it, with nearly all of its width along the wall; without a
        target, any wall will do.
        """
        ...
    def side_against_wall(
        self,
        target: Wall = True,
        /,
        *,
        hard: bool = True,
        gap: Range = ...,
        overlap: float = ...,
        side: Literal["left", "right", "front", "any"] = ...,
        degrees: float = ...,
    ) -> ObjectHandle:
        """The left, right or front face is toward the wall and close to it, with nearly all of its width along the
        wall; without a target, any wall will do.
        """
        ...
    def front_against(
        self,
        target: Thing,
        /,
        *,
        hard: bool = True,
        gap: Range | Literal["tucked"] = ...,
        overlap: float = ...,
        degrees: float = ...,
    ) -> ObjectHandle:
        """The front faces any side of the target from close by, or is tucked under it, such as a chair at a table."""
        ...
    def front_to_front(
        self,
        target: Thing,
        /,
        *,
        hard: bool = True,
        gap: Range | Literal["tucked"] = ...,
        overlap: float = ...,
        degrees: float = ...,
        offset: float = ...,
    ) -> ObjectHandle:
        """The front faces the front of the target from close by, or is tucked under it, such as a chair at a desk or a
        coffee table at a sofa.
        """
        ...
    def leftright_to_leftright(
        self,
        target: Thing,
        /,
        *,
        hard: bool = True,
        gap: Range = ...,
        overlap: float = ...,
        degrees: float = ...,
        backs: float = ...,
    ) -> ObjectHandle:
        """The left or right side is beside the left or right side of the target, such as a nightstand at a bed."""
        ...
    def side_by_side(
        self,
        target: Thing,
        /,
        *,
        hard: bool = True,
        gap: Range = ...,
        overlap: float = ...,
        degrees: float = ...,
    ) -> ObjectHandle:
        """The left, right or front side is beside the left, right or front side of the target."""
        ...
    def back_to_back(
        self,
        target: Thing,
        /,
        *,
        hard: bool = True,
        gap: Range = ...,
        overlap: float = ...,
        degrees: float = ...,
    ) -> ObjectHandle:
        """The back is against the back of the target."""
        ...
    def on_floor(
        self,
        *,
        hard: bool = True,
    ) -> ObjectHandle:
        """The subject stands on the floor: its bottom is within `height` of it."""
        ...
    def on_top(
        self,
        target: Thing,
        /,
        *,
        hard: bool = True,
    ) -> ObjectHandle:
        """The subject stands on an upper surface of the target: its bottom is within `height` of the surface, its
        footprint inside the surface's polygon, its top under the head room.
        """
        ...
    def inside(
        self,
        target: Thing,
        /,
        *,
        hard: bool = True,
    ) -> ObjectHandle:
        """The subject stands on an inner surface of the target, such as a shelf board: its bottom is within `height`
        of the surface, its footprint inside the surface's polygon, its top under the head room.
        """
        ...
    def near(
        self,
        target: Thing,
        /,
        *,
        hard: bool = True,
        max: float = ...,
    ) -> ObjectHandle:
        """The footprints are at most `max` apart."""
        ...
    def distance(
        self,
        target: Thing,
        /,
        *,
        hard: bool = True,
        min: float,
        max: float,
    ) -> ObjectHandle:
        """The distance between the footprints is from `min` to `max`."""
        ...
    def facing(
        self,
        target: Thing,
        /,
        *,
        hard: bool = True,
        degrees: float = ...,
        offset: float = ...,
    ) -> ObjectHandle:
        """The target's centre lies within `degrees` of the direction of the front."""
        ...
    def aligned(
        self,
        target: Thing,
        /,
        *,
        hard: bool = True,
        degrees: float = ...,
    ) -> ObjectHandle:
        """The two yaws are equal modulo 90 degrees."""
        ...
    def parallel(
        self,
        target: Thing,
        /,
        *,
        hard: bool = True,
        degrees: float = ...,
    ) -> ObjectHandle:
        """The two yaws are equal modulo 180 degrees."""
        ...
    def left_of(
        self,
        target: Thing,
        /,
        *,
        hard: bool = True,
        max: float = ...,
        min: float = ...,
        band: float = ...,
        frame: Literal["own", "viewer"] = ...,
    ) -> ObjectHandle:
        """The subject's centre lies `min` to `max` beyond the target's left face, along its normal, and within a band
        `band` times as wide as that face and centred on it (seen in the target's frame).
        """
        ...
    def right_of(
        self,
        target: Thing,
        /,
        *,
        hard: bool = True,
        max: float = ...,
        min: float = ...,
        band: float = ...,
        frame: Literal["own", "viewer"] = ...,
    ) -> ObjectHandle:
        """The subject's centre lies `min` to `max` beyond the target's right face, along its normal, and within a band
        `band` times as wide as that face and centred on it (seen in the target's frame).
        """
        ...
    def in_front_of(
        self,
        target: Thing,
        /,
        *,
        hard: bool = True,
        max: float = ...,
        min: float = ...,
        band: float = ...,
    ) -> ObjectHandle:
        """The subject's centre lies `min` to `max` beyond the target's front face, along its normal, and within a band
        `band` times as wide as that face and centred on it (seen in the target's frame).
        """
        ...
    def behind(
        self,
        target: Thing,
        /,
        *,
        hard: bool = True,
        max: float = ...,
        min: float = ...,
        band: float = ...,
    ) -> ObjectHandle:
        """The subject's centre lies `min` to `max` beyond the target's back face, along its normal, and within a band
        `band` times as wide as that face and centred on it (seen in the target's frame).
        """
        ...
    def centered_on(
        self,
        target: Thing,
        /,
        *,
        hard: bool = True,
        offset: float = ...,
        axis: Literal["either", "width", "both"] = ...,
        ahead: Range = ...,
    ) -> ObjectHandle:
        """The subject's centre is at most `offset` off the target's centre along one axis of the target's frame, or
        along those that `axis` names.
        """
        ...
    def in_corner(
        self,
        *,
        hard: bool = True,
        to_corner: float = ...,
        to_wall: float = ...,
    ) -> ObjectHandle:
        """The footprint is within `to_corner` of a convex corner of the room and the box within `to_wall` of both of
        its walls.
        """
        ...
    def at_window(
        self,
        target: str | bool,
        /,
        *,
        hard: bool = True,
        max: float = ...,
        offset: float = ...,
        overlap: float = ...,
    ) -> ObjectHandle:
        """Along the wall, the box overlaps the window by at least `overlap` of the narrower of the two, its middle is
        at most `offset` from the window's, and it is at most `max` from the wall.
        """
        ...
    def between(
        self,
        target: tuple[Thing, Thing],
        /,
        *,
        hard: bool = True,
        along: Range = ...,
        aside: float = ...,
    ) -> ObjectHandle:
        """The subject's centre projects on the middle part `along` of the line from the centre of the first target to
        that of the second, and lies at most `aside` from the line.
        """
        ...
    def around(
        self,
        target: Thing,
        /,
        *,
        hard: bool = True,
        gap: Range | Literal["tucked"] = ...,
        overlap: float = ...,
        degrees: float = ...,
        n: int = ...,
        spread: float = ...,
    ) -> ObjectHandle:
        """The subject is one of a group around the target: its front is against the target, and the directions of the
        group's centres are evenly spread. All `around` relations with the same target form the group.
        """
        ...
    def away_from_door(
        self,
        target: str | bool = True,
        /,
        *,
        hard: bool = True,
        min: float = ...,
    ) -> ObjectHandle:
        """The footprint is at least `min` from the zone of the door; without a target, of every door."""
        ...
    def above(
        self,
        target: Thing,
        /,
        *,
        hard: bool = True,
        lateral: float = ...,
    ) -> ObjectHandle:
        """The subject hangs above the target: its bottom is at or over the target's top, and its centre is laterally
        within `lateral` of the target's width of the target's centre.
        """
        ...
    def below(
        self,
        target: Thing,
        /,
        *,
        hard: bool = True,
        lateral: float = ...,
    ) -> ObjectHandle:
        """The subject is below the target: its top is at or under the target's bottom, and its centre is laterally
        within `lateral` of the target's width of the target's centre.
        """
        ...
    def same_height(
        self,
        target: Thing,
        /,
        *,
        hard: bool = True,
        tolerance: float = ...,
    ) -> ObjectHandle:
        """The bottoms are at the same height."""
        ...
    def seated_at(
        self,
        target: Thing,
        /,
        *,
        hard: bool = True,
        side: Literal["front", "back", "left", "right"] = ...,
        k: int = ...,
        n: int = ...,
        gap: Range | Literal["tucked"] = ...,
        degrees: float = ...,
        offset: float = ...,
        frame: Literal["own", "viewer"] = ...,
    ) -> ObjectHandle:
        """The front is against one side of the target, in the middle of the `k`-th of `n` equal parts of that side,
        counted counter-clockwise seen from above.
        """
        ...
    def next_to(
        self,
        target: Thing,
        /,
        *,
        hard: bool = True,
        side: Literal["left", "right", "front", "back"] = ...,
        gap: Range = ...,
        degrees: float = ...,
        offset: float = ...,
        frame: Literal["own", "viewer"] = ...,
    ) -> ObjectHandle:
        """The subject is the next in a row: it looks the same way as the target and stands beyond one side of it, with
        the backs in line where that is left or right, with the middles in line where it is front or back.
        """
        ...
    def arranged(
        self,
        target: Thing,
        /,
        *,
        hard: bool = True,
        ahead: float = ...,
        left: float = ...,
        turn: float = ...,
        degrees: float = ...,
        offset: float = ...,
    ) -> ObjectHandle:
        """The subject has its place in a pattern about the target: its centre lies `ahead` of the target's centre and
        `left` of it, and it is turned by `turn`: one of a grid, a circle, two rows that face each other.
        """
        ...
    def run_on(
        self,
        target: Thing,
        /,
        *,
        hard: bool = True,
        side: Literal["left", "right"] = ...,
        gap: Range = ...,
        degrees: float = ...,
        offset: float = ...,
        frame: Literal["own", "viewer"] = ...,
    ) -> ObjectHandle:
        """The subject goes on with a run of furniture to the target's left or right, flush with it and with the backs
        in line; or around a corner of the room, turned by a quarter, in front of the target and with its back in
        line with the target's side.
        """
        ...
    def in_middle(
        self,
        *,
        hard: bool = True,
        offset: float = ...,
    ) -> ObjectHandle:
        """The subject's centre is at most `offset` from the middle of the room, along either axis: the centre of its
        floor, or a point inside of the room where that is outside.
        """
        ...
    def over(
        self,
        target: Thing,
        /,
        *,
        hard: bool = True,
        inset: float = ...,
        forward: float = ...,
        left: float = ...,
        offset: float = ...,
    ) -> ObjectHandle:
        """The subject's centre lies over the target's box, at least `inset` from its edges, seen from above: what
        stands on a rug, the rug under what stands on it, a lamp over a table. With `offset` it lies that close to
        one place over the target: the second of three lamps over a long table.
        """
        ...
    def near_window(
        self,
        target: str | bool = True,
        /,
        *,
        hard: bool = True,
        min: float = ...,
        max: float = ...,
    ) -> ObjectHandle:
        """The footprint is `min` to `max` from the window, as seen from above; without a target, from some window."""
        ...
    def near_door(
        self,
        target: str | bool = True,
        /,
        *,
        hard: bool = True,
        min: float = ...,
        max: float = ...,
    ) -> ObjectHandle:
        """The footprint is `min` to `max` from the doorway, as seen from above; without a target, from some doorway."""
        ...
    def across_from(
        self,
        target: Thing,
        /,
        *,
        hard: bool = True,
        side: Literal["front", "back", "left", "right", "ends", "any"] = ...,
        k: int = ...,
        n: int = ...,
        gap: Range = ...,
        degrees: float = ...,
        offset: float = ...,
        frame: Literal["own", "viewer"] = ...,
    ) -> ObjectHandle:
        """The front looks straight at one side of the target across a gap, in line with the middle of the `k`-th of
        `n` equal parts of that side, counted counter-clockwise seen from above: a screen at the end of a table,
        benches before a rack, a shelf behind a bar.
        """
        ...
    def facing_door(
        self,
        target: str | bool = True,
        /,
        *,
        hard: bool = True,
        degrees: float = ...,
        aside: float = ...,
    ) -> ObjectHandle:
        """The front looks toward the wall of the door: at most `degrees` between it and the way out; without a target,
        of some door.
        """
        ...
    def off_walls(
        self,
        *,
        hard: bool = True,
        min: float = ...,
    ) -> ObjectHandle:
        """The footprint is at least `min` from every wall."""
        ...
    def on_grid(
        self,
        *,
        hard: bool = True,
        k: int = ...,
        n: int = ...,
        offset: float = ...,
    ) -> ObjectHandle:
        """The subject's centre is at most `offset`, along x and along y, from the `k`-th of `n` places that are spread
        evenly over the floor, in rows: lamps on a ceiling.
        """
        ...
    def beside(
        self,
        target: Thing,
        /,
        *,
        hard: bool = True,
        max: float = ...,
        min: float = ...,
        band: float = ...,
    ) -> ObjectHandle:
        """The subject's centre lies `min` to `max` beyond the target's left or right face, along its normal, and
        within a band `band` times as wide as that face and centred on it, such as an armchair at the end of a
        coffee table.
        """
        ...
