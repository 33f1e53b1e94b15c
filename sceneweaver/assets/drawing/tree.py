"""The tree of parts of a drawing: frames, parts that move, and copies that are mirrored, turned or lined up."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace

import numpy as np

from sceneweaver.scene import Surface, Zone

from ..body import Grasp, Hull, Interior, Link, Material, Role
from ..category import Category
from .box import Box, Interval, Vec3
from .request import Request
from .watched import Watching


@dataclass
class Piece:
    """One closed body of the mesh: in its own frame, where that stands, and what it is made of and moves with."""

    vertices: np.ndarray
    faces: np.ndarray
    frame: np.ndarray
    material: Material
    link: int
    uv: np.ndarray | None = None

    @property
    def placed(self) -> np.ndarray:
        """The vertices in the object's frame, float64 [V, 3]."""
        return self.vertices @ self.frame[:3, :3].T + self.frame[:3, 3]


@dataclass
class Part:
    """A named part and those inside it. Once it is drawn, ``bounds`` is its box in the frame that it was begun in."""

    name: str
    children: list[Part] = field(default_factory=list)
    bounds: Box = Box((0.0, 0.0), (0.0, 0.0), (0.0, 0.0))

    def lines(self, depth: int = 0) -> Iterator[str]:
        """The tree in words, a line a part."""
        yield f"{'  ' * depth}{self.name}: " + " x ".join(f"{v:.3f}" for v in self.bounds.size)
        for child in self.children:
            yield from child.lines(depth + 1)


@dataclass
class Drawn:
    """All that was drawn: lists that only grow."""

    pieces: list[Piece] = field(default_factory=list)
    hulls: list[Hull] = field(default_factory=list)
    groups: list[str | None] = field(default_factory=list)
    surfaces: list[Surface] = field(default_factory=list)
    zones: list[Zone] = field(default_factory=list)
    clear: list[Box] = field(default_factory=list)
    links: list[Link] = field(default_factory=list)
    grasps: list[Grasp] = field(default_factory=list)
    interiors: list[Interior] = field(default_factory=list)


class Tree(Watching):
    """Finishes with frames, parts, links and copies."""

    def __init__(self, category: Category, seed: int, request: Request | None = None, *, any_material: bool = False):
        super().__init__(category, seed, request, any_material=any_material)
        self.drawn = Drawn()
        self.root = Part(category.name, bounds=self.bounds)
        self._inside = [self.root]
        self._frame = np.eye(4)
        self._link = 0
        self._handle = False
        self._group: str | None = None
        self.posed = False

    def takes(self, *postures: str) -> str | None:
        """The posture that is asked for, if it is one that this drawing knows: it has to show it then."""
        asked = self.request.posture
        self.posed = self.posed or asked in postures
        return asked if asked in postures else None

    # Frames

    @contextmanager
    def at(
        self, x: float = 0.0, y: float = 0.0, z: float = 0.0, yaw: float = 0.0, pitch: float = 0.0, roll: float = 0.0
    ) -> Iterator[None]:
        """Draw in a frame at (x, y, z) turned by yaw about z, then pitch about its y, then roll about its x [rad].

        A positive pitch lowers what lies in front (+x); a negative one leans a back rest backward.
        """
        before = self._frame
        self._frame = before @ pose(x, y, z, yaw, pitch, roll)
        try:
            yield
        finally:
            self._frame = before

    @property
    def upright(self) -> bool:
        """Whether z is up in the frame that is drawn in."""
        return bool(self._frame[2, 2] > 0.999)

    # Parts

    @contextmanager
    def part(self, name: str) -> Iterator[Part]:
        """A named part: what is drawn inside becomes one prism of the engine (the seat of a chair, say).

        Parts nest; a part inside another is a prism of its own.
        """
        part, frame, first = Part(name), self._frame, len(self.drawn.pieces)
        self._inside[-1].children.append(part)
        before, self._group = self._group, name
        self._inside.append(part)
        try:
            yield part
        finally:
            self._group = before
            self._inside.pop()
        own = [piece.placed for piece in self.drawn.pieces[first:]]
        if own:
            points = (np.concatenate(own) - frame[:3, 3]) @ np.linalg.inv(frame[:3, :3]).T
            low, high = points.min(axis=0).tolist(), points.max(axis=0).tolist()
            part.bounds = Box(*((a, b) for a, b in zip(low, high, strict=True)))

    @contextmanager
    def hinge(
        self,
        name: str,
        at: Vec3,
        axis: Vec3 = (0.0, 0.0, 1.0),
        limits: Interval = (0.0, 1.57),
        role: Role = "door",
    ) -> Iterator[None]:
        """What is drawn inside is a door, or a lid or a control: it turns about ``axis`` through ``at``; it is drawn
        closed."""
        with self._moving(Link(name, "hinge", axis, at, limits, role)):
            yield

    @contextmanager
    def slide(
        self, name: str, axis: Vec3 = (1.0, 0.0, 0.0), limits: Interval = (0.0, 0.3), role: Role = "drawer"
    ) -> Iterator[None]:
        """What is drawn inside is a drawer, or a control: it slides along ``axis``; it is drawn closed."""
        with self._moving(Link(name, "slide", axis, (0.0, 0.0, 0.0), limits, role)):
            yield

    @contextmanager
    def item(self, name: str, category: str = "") -> Iterator[None]:
        """What is drawn inside lies on or in the rest and can be taken: a body of its own in a simulator.

        ``category`` is what it is, ``name`` unless told. It must rest on what is below it: nothing holds it.
        """
        with self._moving(Link(name, "free", role="item", category=category or name)):
            yield

    # What a hand needs

    @contextmanager
    def handle(
        self, name: str, position: Vec3, approach: Vec3, closing: Vec3, width: float, length: float
    ) -> Iterator[None]:
        """What is drawn inside is a handle: its parts are merged with no others, and a hand can take hold of it.

        Args:
            name: Of the grasp.
            position: The middle of what is held.
            approach: Along which a hand comes; of any length, as is ``closing``.
            closing: Along which its fingers close, square to ``approach``.
            width: Of what is between the fingers [m].
            length: Of it along the third axis [m].
        """
        before, self._handle = self._handle, True
        try:
            yield
        finally:
            self._handle = before
        self.grasp(name, position, approach, closing, width, length)

    def grasp(self, name: str, position: Vec3, approach: Vec3, closing: Vec3, width: float, length: float) -> None:
        """Where a hand takes hold of something that is no handle, such as a rim; arguments as of `handle`."""
        turn, shift = self._frame[:3, :3], self._frame[:3, 3]
        to, close = turn @ np.array(approach), turn @ np.array(closing)
        place = vec3(turn @ np.array(position) + shift)
        to, close = to / np.linalg.norm(to), close / np.linalg.norm(close)
        self.drawn.grasps.append(Grasp(name, self._link, place, vec3(to), vec3(close), width, length))

    def interior(self, name: str, box: Box, entry: Vec3 = (0.0, 0.0, 1.0), oval: bool = False) -> None:
        """A box is room that holds things, open towards ``entry``; where it is ``oval``, only the ellipse in its plan
        is."""
        placed, out = _moved_box(box, self._frame), self._frame[:3, :3] @ np.array(entry)
        self.drawn.interiors.append(
            Interior(
                name,
                self._link,
                placed.anchor("back right bottom"),
                placed.anchor("front left top"),
                vec3(out / np.linalg.norm(out)),
                oval,
            )
        )

    @contextmanager
    def _moving(self, link: Link) -> Iterator[None]:
        if self._link:
            raise ValueError("a link inside a link")
        turn, shift = self._frame[:3, :3], self._frame[:3, 3]
        axis, anchor = turn @ np.array(link.axis), turn @ np.array(link.anchor) + shift
        axis /= np.linalg.norm(axis)
        self.drawn.links.append(replace(link, axis=vec3(axis), anchor=vec3(anchor)))
        self._link = len(self.drawn.links)
        try:
            yield
        finally:
            self._link = 0

    # Copies

    @contextmanager
    def copies(self, frames: Sequence[np.ndarray]) -> Iterator[None]:
        """What is drawn inside stands in each of some frames [4, 4], which may mirror.

        It runs once, in the first frame; for copies that differ, loop over boxes instead. Names of parts, links and
        surfaces of the others end in "-1", "-2" ...
        """
        drawn, outer = self.drawn, self._frame
        start = {name: len(getattr(drawn, name)) for name in vars(drawn)}
        group, inside = self._group, self._link
        self._frame = outer @ frames[0]
        try:
            yield
        finally:
            self._frame = outer
        new = {name: getattr(drawn, name)[first:] for name, first in start.items()}
        back = np.linalg.inv(outer @ frames[0])
        for k, frame in enumerate(frames[1:], start=1):
            step = outer @ frame @ back
            turn, flip = step[:3, :3], bool(np.linalg.det(step[:3, :3]) < 0)
            offset = len(drawn.links) - start["links"]

            def link_of(link: int, offset: int = offset) -> int:
                return link if inside or not link else link + offset

            drawn.links += [_moved_link(link, step, f"-{k}", flip) for link in new["links"]]
            for piece in new["pieces"]:
                faces = piece.faces[:, ::-1] if flip else piece.faces
                uv = piece.uv[:, ::-1] if flip and piece.uv is not None and piece.uv.ndim == 3 else piece.uv
                drawn.pieces.append(
                    Piece(piece.vertices, faces, step @ piece.frame, piece.material, link_of(piece.link), uv)
                )
            for hull, name in zip(new["hulls"], new["groups"], strict=True):
                points = hull.vertices @ turn.T + step[:3, 3]
                faces = hull.faces[:, ::-1] if flip else hull.faces
                drawn.hulls.append(Hull(points, faces, link_of(hull.link), hull.handle))
                drawn.groups.append(name if name is None or name == group else f"{name}-{k}")
            drawn.surfaces += [_moved_surface(s, step, f"-{k}", flip) for s in new["surfaces"]]
            drawn.zones += [_moved_zone(z, step, f"-{k}", flip) for z in new["zones"]]
            drawn.clear += [_moved_box(box, step) for box in new["clear"]]
            drawn.grasps += [_moved_grasp(g, step, f"-{k}", link_of(g.link)) for g in new["grasps"]]
            drawn.interiors += [_moved_interior(i, step, f"-{k}", link_of(i.link)) for i in new["interiors"]]

    def mirror(self, *axes: str):
        """What is drawn inside is drawn once more mirrored at each of these axes, "x" or "y": twice, or four times."""
        frames = [np.eye(4)]
        for axis in axes:
            flip = np.diag([-1.0 if axis == a else 1.0 for a in "xyz"] + [1.0])
            frames += [flip @ frame for frame in frames]
        return self.copies(frames)

    def corners(self, box: Box, inset: float = 0.0):
        """Four copies at the lower corners of a box, moved in by ``inset``; +x and +y point to its middle in each."""
        (x0, x1), (y0, y1) = box.inset(x=inset, y=inset).x, box.inset(x=inset, y=inset).y
        corners = ((x1, y1, -1, -1), (x0, y1, 1, -1), (x0, y0, 1, 1), (x1, y0, -1, 1))
        return self.copies([pose(x, y, box.z[0]) @ np.diag([sx, sy, 1.0, 1.0]) for x, y, sx, sy in corners])

    def grid(self, box: Box, x: int = 1, y: int = 1, z: int = 1):
        """Copies in the middles of the cells of a grid of so many cells; z starts at the bottom of each cell."""
        cells = [c for a in box.split("x", x) for b in a.split("y", y) for c in b.split("z", z)]
        return self.copies([pose(*cell.anchor("bottom")) for cell in cells])

    def along(self, start: Vec3, end: Vec3, count: int):
        """So many copies from one point to another, both included."""
        share = np.linspace(0.0, 1.0, count)[:, None]
        points = (1 - share) * np.array(start) + share * np.array(end)
        return self.copies([pose(*point) for point in points.tolist()])

    def ring(self, count: int, radius: float = 0.0, start: float = 0.0):
        """So many copies around z at a radius, each turned so that +x points outward; the first at angle ``start``."""
        turns = [start + 2 * math.pi * k / count for k in range(count)]
        return self.copies([pose(radius * math.cos(a), radius * math.sin(a), 0.0, a) for a in turns])


def pose(x: float, y: float, z: float, yaw: float = 0.0, pitch: float = 0.0, roll: float = 0.0) -> np.ndarray:
    """A frame [4, 4] at a point, turned by yaw, then pitch, then roll [rad]."""
    cy, sy, cp, sp, cr, sr = (f(a) for a in (yaw, pitch, roll) for f in (math.cos, math.sin))
    return np.array(
        [
            [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr, x],
            [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr, y],
            [-sp, cp * sr, cp * cr, z],
            [0.0, 0.0, 0.0, 1.0],
        ]
    )


def vec3(values: Iterable[float]) -> Vec3:
    """Three plain numbers."""
    x, y, z = (float(v) for v in values)
    return x, y, z


def _moved_link(link: Link, step: np.ndarray, suffix: str, flip: bool) -> Link:
    turn = step[:3, :3]
    axis = turn @ np.array(link.axis)
    # Mirrored, what turned one way about its axis turns the other way.
    axis = -axis if flip and link.joint == "hinge" else axis
    anchor = turn @ np.array(link.anchor) + step[:3, 3]
    return replace(link, name=link.name + suffix, axis=vec3(axis), anchor=vec3(anchor))


def _moved_grasp(grasp: Grasp, step: np.ndarray, suffix: str, link: int) -> Grasp:
    turn, position = step[:3, :3], step[:3, :3] @ np.array(grasp.position) + step[:3, 3]
    approach, closing = vec3(turn @ np.array(grasp.approach)), vec3(turn @ np.array(grasp.closing))
    name = grasp.name + suffix
    return replace(grasp, name=name, link=link, position=vec3(position), approach=approach, closing=closing)


def _moved_interior(room: Interior, step: np.ndarray, suffix: str, link: int) -> Interior:
    (x0, y0, z0), (x1, y1, z1) = room.low, room.high
    box = _moved_box(Box((x0, x1), (y0, y1), (z0, z1)), step)
    low, high = box.anchor("back right bottom"), box.anchor("front left top")
    entry = vec3(step[:3, :3] @ np.array(room.entry))
    return replace(room, name=room.name + suffix, link=link, low=low, high=high, entry=entry)


def _moved_plan(polygon, z: float, step: np.ndarray, flip: bool) -> tuple[tuple[tuple[float, float], ...], float]:
    placed = np.array([(x, y, z) for x, y in polygon]) @ step[:3, :3].T + step[:3, 3]
    placed = placed[::-1] if flip else placed
    return tuple((float(x), float(y)) for x, y, _ in placed), float(placed[0, 2])


def _moved_surface(surface: Surface, step: np.ndarray, suffix: str, flip: bool) -> Surface:
    polygon, z = _moved_plan(surface.polygon, surface.z, step, flip)
    return Surface(name=surface.name + suffix, polygon=polygon, z=z, headroom=surface.headroom)


def _moved_zone(zone: Zone, step: np.ndarray, suffix: str, flip: bool) -> Zone:
    polygon, z = _moved_plan(zone.polygon, zone.z[0], step, flip)
    return Zone(name=zone.name + suffix, polygon=polygon, z=(z, z + zone.z[1] - zone.z[0]), hard=zone.hard)


def _moved_box(box: Box, step: np.ndarray) -> Box:
    corners = np.array([(x, y, z) for x in box.x for y in box.y for z in box.z]) @ step[:3, :3].T + step[:3, 3]
    low, high = corners.min(axis=0).tolist(), corners.max(axis=0).tolist()
    return Box(*((a, b) for a, b in zip(low, high, strict=True)))
