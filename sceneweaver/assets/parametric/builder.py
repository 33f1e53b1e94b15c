"""The workbench of the parametric library: draws a piece of furniture and collects all that an asset needs."""

from __future__ import annotations

import math
import zlib
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, NamedTuple, TypeVar
from urllib.parse import quote

import numpy as np

from sceneweaver.scene import InputError, Part, Surface, Zone

from .. import shapes
from ..asset import Asset, Origin
from ..body import Hull, Link, Material, Mesh
from ..category import Category
from ..materials import STYLES, Finish, alike, color_name, color_named, expand, finish, finishes_named, tinted
from ..prisms import prisms_of
from ..scheme import scheme_for
from ..shapes.convex import Shape
from ..zones import ZONE_HEIGHT, access_zones

T = TypeVar("T")
Interval = tuple[float, float]
Vec3 = tuple[float, float, float]


def span(a: float, b: float) -> Interval:
    """The interval between two numbers, given in any order."""
    return (a, b) if a <= b else (b, a)


class Size(NamedTuple):
    """Depth along the front, width, height [m]."""

    depth: float
    width: float
    height: float


@dataclass(frozen=True)
class Request:
    """What a user asks of an asset; None leaves the choice to the seed.

    ``shape`` is a name of ``looks.yaml``, ``parts`` are counted ones (("drawers", 3), ...); a drawing that cannot show
    them leaves them out. ``label`` is what a body that stands for an unknown noun is called. ``palette`` is the code of
    the room's, which all that is not asked otherwise follows. Pieces of one ``suite`` (any number) match, of whatever
    category: fronts, handles and worktops of a kitchen.
    """

    size: tuple[float | None, float | None, float | None] = (None, None, None)
    color: str | None = None
    material: str | None = None
    style: str | None = None
    shape: str | None = None
    parts: tuple[tuple[str, int], ...] = ()
    label: str | None = None
    palette: str | None = None
    suite: int | None = None

    @property
    def suffix(self) -> str:
        """The request as the end of an asset id; empty when nothing is asked."""
        parts = []
        if any(v is not None for v in self.size):
            parts.append("size=" + ",".join("" if v is None else f"{v:g}" for v in self.size))
        named = ("color", "material", "style", "shape", "label")
        parts += [f"{k}={quote(v)}" for k in named if (v := getattr(self, k)) is not None]
        if self.parts:
            parts.append("parts=" + ",".join(f"{name}:{count}" for name, count in self.parts))
        if self.palette is not None:
            parts.append("palette=" + quote(self.palette, safe="/,"))
        if self.suite is not None:
            parts.append(f"suite={self.suite}")
        return "".join(f"&{part}" for part in parts)


class Builder:
    """Draws one asset in the object's frame: bottom at z = 0, front +x, left +y, metres.

    Choices (``pick``, ``uniform``, ``whole``, ``chance``) are drawn by name, so that a new one leaves the others as
    they were. Every shape is at once a piece of the visual mesh and one or more convex collision parts.
    """

    def __init__(self, category: Category, seed: int, request: Request | None = None, *, any_material: bool = False):
        if category.size is None:
            raise InputError(f"category: '{category.name}' is a group of others; name one of them")
        self.category = category
        self.request = request or Request()
        self._seed = seed
        self._scheme = scheme_for(category.name, self.request.palette)
        self.style = self.request.style or self.pick("style", STYLES)
        if self.style not in STYLES:
            raise InputError(f"style: '{self.style}' is unknown; use one of {', '.join(STYLES)}")
        self.size = self._even(Size(*(self._extent(k) for k in range(3))))
        self._frame = np.eye(4)
        self._link = 0
        self._group: str | None = None
        self._links: list[Link] = []
        self._materials: dict[Material, int] = {}
        self._roles: dict[str, Material] = {}
        self._pieces: list[tuple[np.ndarray, np.ndarray, int, int]] = []
        self._hulls: list[Hull] = []
        self._groups: list[str | None] = []
        self._surfaces: list[Surface] = []
        self._zones: list[Zone] = []
        self._clear: list[tuple[Interval, Interval, Interval]] = []
        self._wanted = None if any_material else self.request.material
        self._shown: dict[str, Any] = {}
        self._main: str | None = None

    # Choices

    def _rng(self, name: str, matched: bool = False) -> np.random.Generator:
        """``matched``: drawn alike by all pieces of a suite, where this is one of a suite."""
        key = [zlib.crc32(self.category.name.encode()), self._seed]
        if matched and self.request.suite is not None:
            key = [zlib.crc32(b"suite"), self.request.suite]
        return np.random.Generator(np.random.PCG64([*key, zlib.crc32(name.encode())]))

    def pick(self, name: str, options: Sequence[T], matched: bool = False) -> T:
        """One of the options; ``matched``: the same for all pieces of a suite."""
        return options[int(self._rng(name, matched).integers(len(options)))]

    def uniform(self, name: str, low: float, high: float) -> float:
        """A number between two others."""
        return float(self._rng(name).uniform(low, high))

    def whole(self, name: str, low: int, high: int) -> int:
        """A whole number from ``low`` to ``high``, both included."""
        return int(self._rng(name).integers(low, high + 1))

    def chance(self, name: str, share: float, matched: bool = False) -> bool:
        """True in that share of the seeds; ``matched``: the same for all pieces of a suite."""
        return bool(self._rng(name, matched).uniform() < share)

    @property
    def in_suite(self) -> bool:
        """Whether it is one of several pieces that match."""
        return self.request.suite is not None

    def _extent(self, axis: int) -> float:
        assert self.category.size is not None
        name = ("depth", "width", "height")[axis]
        low, high = self.category.size.ranges[axis]
        asked = self.request.size[axis]
        if asked is None:
            return low if low == high else round(self.uniform(f"size {name}", low, high), 3)
        least, most = self.category.size.reach[axis]
        if not least - 1e-6 <= asked <= most + 1e-6:
            raise InputError(f"size: {self.category.words} has a {name} of {low:g} to {high:g} m, not {asked:g} m")
        return float(asked)

    def _even(self, size: Size) -> Size:
        """The size with two equal sides where a round or square thing was asked for, as near as its ranges allow.

        They are those in plan, or of what hangs on a wall those of its front.
        """
        axes = self._outline_axes
        if self.request.shape not in ("round", "square") or any(self.request.size[k] is not None for k in axes):
            return size
        assert self.category.size is not None
        (a0, a1), (b0, b1) = (self.category.size.ranges[k] for k in axes)
        side = min(max(size[axes[0]], b0), a1) if max(a0, b0) <= min(a1, b1) else min(a1, b1)
        if side < 0.5 * max(a0, b0):  # a square pipe would be another thing
            return size
        return Size(*(side if k in axes else size[k] for k in range(3)))

    @property
    def _outline_axes(self) -> tuple[int, int]:
        """The axes of the outline that a shape is said of."""
        return (1, 2) if self.category.mount[0] == "wall" else (0, 1)

    # Materials

    def material(self, role: str, *names: str) -> Material:
        """A finish for a role such as "top" or "legs": one of the names, "@wood" for any of a family.

        The same role has the same finish all over. The first role that can do so takes the material that the user
        asked for, also one that is not among its names where its families allow it, and the first that can takes the
        colour; a style prefers finishes that suit it.
        """
        if role in self._roles:
            return self._roles[role]
        options = expand(names)
        asked = self._asked_finishes(options)
        options = asked or options
        color = self.request.color if "color" not in self._shown else None
        if self.lacks_material:  # "blue velvet": the colour waits for the velvet
            color = None
        chosen = self._colored(role, options, color) if color else None
        if asked or (chosen is not None and self._main is None):
            self._main = role
        self._roles[role] = chosen or (self._suiting(role, options) if asked else self._usual(role, options))
        return self._roles[role]

    @property
    def lacks_material(self) -> bool:
        """Whether no role has had the asked material so far; at the end, draw again with ``any_material``."""
        return self._wanted is not None and "material" not in self._shown

    def _asked_finishes(self, options: list[Finish]) -> list[Finish]:
        """The finishes among some, or in place of them, that are of the asked material; none when there are none."""
        if not self._wanted or "material" in self._shown:
            return []
        wanted = finishes_named(self._wanted)
        like = [f for f in wanted if f in options]
        if not like:
            families = frozenset().union(*(alike(f.family) for f in options))
            like = [f for f in wanted if f.family in families]
            like = [f for f in like if not f.asked] or like
        if like:
            self._shown["material"] = self._wanted
        return like

    def _colored(self, role: str, options: list[Finish], color: str) -> Material | None:
        """A finish in the asked colour: one that has it, one that is dyed, or painted."""
        basic = color_named(color)
        like = [f for f in options if color_name(f.material.color) == basic]
        dyes = [f for f in options if f.tints]
        paints = [f for f in options if alike(f.family)]
        self._shown["color"] = basic
        if like and (color == basic or not dyes + paints):
            return self._suiting(role, like)
        if not dyes + paints:
            del self._shown["color"]
            return None
        return tinted(self._suiting(role, dyes or paints), color)

    def _suiting(self, role: str, options: list[Finish]) -> Material:
        """One of some finishes, rather one that suits the style."""
        return self.pick(f"material {role}", [f for f in options if self.style in f.styles] or options, True).material

    def _usual(self, role: str, options: list[Finish]) -> Material:
        """A finish of which nothing was asked: of the room's palette, furniture has the same all over the room."""
        if self._scheme is None:
            return self._suiting(role, options)
        large = self.category.mount[0] != "surface"
        looks = self._scheme.replaced(options, large)
        return looks[int(self._scheme.share(role) * len(looks))] if large else self.pick(f"material {role}", looks)

    # Where and to what

    @contextmanager
    def frame(
        self, x: float = 0.0, y: float = 0.0, z: float = 0.0, yaw: float = 0.0, pitch: float = 0.0, roll: float = 0.0
    ) -> Iterator[None]:
        """Draw in a frame at (x, y, z) turned by yaw about z, then pitch about its y, then roll about its x [rad].

        A positive pitch lowers what lies in front (+x); a negative one leans a back rest backward.
        """
        before = self._frame
        cy, sy, cp, sp, cr, sr = (f(a) for a in (yaw, pitch, roll) for f in (math.cos, math.sin))
        turn = (
            np.array([[cy, -sy, 0], [sy, cy, 0], [0, 0, 1]])
            @ np.array([[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]])
            @ np.array([[1, 0, 0], [0, cr, -sr], [0, sr, cr]])
        )
        step = np.eye(4)
        step[:3, :3], step[:3, 3] = turn, (x, y, z)
        self._frame = before @ step
        try:
            yield
        finally:
            self._frame = before

    @contextmanager
    def solid(self, name: str) -> Iterator[None]:
        """What is drawn inside becomes one prism of the engine (legs and seat of a chair, say)."""
        before, self._group = self._group, name
        try:
            yield
        finally:
            self._group = before

    @contextmanager
    def hinge(self, name: str, at: tuple[float, float, float], axis=(0.0, 0.0, 1.0), limits=(0.0, 1.57)):
        """What is drawn inside is a door: it turns about ``axis`` through ``at``; it is drawn closed."""
        with self._moving(Link(name, "hinge", _vec(axis), _vec(at), tuple(limits))):
            yield

    @contextmanager
    def slide(self, name: str, axis=(1.0, 0.0, 0.0), limits=(0.0, 0.3)):
        """What is drawn inside is a drawer: it slides along ``axis``; it is drawn closed."""
        with self._moving(Link(name, "slide", _vec(axis), (0.0, 0.0, 0.0), tuple(limits))):
            yield

    @contextmanager
    def _moving(self, link: Link) -> Iterator[None]:
        if self._link:
            raise ValueError("a link inside a link")
        turn, shift = self._frame[:3, :3], self._frame[:3, 3]
        axis, anchor = turn @ np.array(link.axis), turn @ np.array(link.anchor) + shift
        self._links.append(Link(link.name, link.joint, _vec(axis), _vec(anchor), link.limits))
        self._link = len(self._links)
        try:
            yield
        finally:
            self._link = 0

    # Shapes

    def add(self, shape: Shape, material: Material | str, hulls: Sequence[Shape] | None = None) -> None:
        """A closed shape; ``hulls`` are its convex parts, by default the shape itself, which must then be convex.

        An empty list adds no collision part: only for what lies inside other parts.
        """
        vertices, faces = shape
        look = self._finish(material) if isinstance(material, str) else material
        index = self._materials.setdefault(look, len(self._materials))
        self._pieces.append((self._place(vertices), faces, index, self._link))
        for points, triangles in [shape] if hulls is None else hulls:
            self._hulls.append(Hull(self._place(points), triangles, self._link))
            self._groups.append(self._group)

    def _finish(self, name: str) -> Material:
        return finish(name).material if self._scheme is None else self._scheme.alone(name)

    def box(self, x: Interval, y: Interval, z: Interval, material: Material | str, bevel: float = 0.003) -> None:
        """A box between two ends on each axis, its edges cut by ``bevel``."""
        self.add(shapes.box(x, y, z, bevel), material)

    def extrude(self, polygon, z: Interval, material: Material | str, bevel: float = 0.0) -> None:
        """A simple polygon [V, 2], counter-clockwise, times a z interval."""
        shape = shapes.extrusion(np.asarray(polygon), z, bevel)
        pieces = shapes.convex_pieces(np.asarray(polygon, dtype=np.float64))
        self.add(shape, material, None if len(pieces) == 1 else [shapes.extrusion(p, z) for p in pieces])

    def frustum(
        self, low: float, high: float, z: Interval, material: Material | str, segments: int = 24, bevel: float = 0.0
    ) -> None:
        """A cylinder or cone about z with these radii at its foot and head."""
        self.add(shapes.frustum(low, high, z, segments, bevel), material)

    def lathe(
        self, profile: list[tuple[float, float]], material: Material | str, segments: int = 24, hollow: bool = False
    ) -> None:
        """A profile of (radius, z) turned about z.

        A solid one rises from foot to head. A hollow one runs up outside and down again inside; it is one solid
        body for collisions, as nothing is put into cups and vases.
        """
        shape = shapes.lathe(profile, segments)
        if hollow:
            top = max(range(len(profile)), key=lambda i: (profile[i][1], -i))
            profile = profile[: top + 1]
        self.add(shape, material, shapes.lathe_hulls(profile, segments))

    def ball(
        self, radii: tuple[float, float, float], center: tuple[float, float, float], material, segments=20
    ) -> None:
        """An ellipsoid."""
        shape = shapes.ball(radii, center, segments)
        self.add(shape, material, None if segments <= 12 else [shapes.containing_hull(shape[0])])

    def cushion(
        self, x: Interval, y: Interval, z: Interval, material: Material | str, radius: float = 0.04, puff: float = 0.0
    ) -> None:
        """Upholstery: a box with round edges; ``puff`` (0 to 1) swells it to a pillow. Fills its box."""
        shape = shapes.cushion(x, y, z, radius, puff)
        if puff > 0:
            self.add(shape, material, [shapes.containing_hull(shape[0])])
            return
        # The planes at 45 degrees that touch round edges of radius r cut (2 - sqrt 2) r off a box.
        r = min(radius, 0.4995 * min(x[1] - x[0], y[1] - y[0], z[1] - z[0]))
        self.add(shape, material, [shapes.box(x, y, z, 0.5857 * r)])

    def sheet(self, grid: np.ndarray, thickness: float, material: Material | str, cells: int = 1) -> None:
        """Cloth or a leaf: a bent grid of points [N, M, 3]; its hulls are those of ``cells`` strips along N."""
        shape = shapes.sheet(grid, thickness)
        n, m = grid.shape[:2]
        cuts = np.unique(np.linspace(0, n - 1, cells + 1).round().astype(int))
        both = shape[0].reshape(2, n, m, 3)
        hulls = [shapes.hull(both[:, a : b + 1].reshape(-1, 3)) for a, b in zip(cuts[:-1], cuts[1:], strict=True)]
        self.add(shape, material, hulls)

    def tube(
        self, path, radius: float | np.ndarray, material: Material | str, segments: int = 10, closed=False
    ) -> None:
        """A bar along points [N, 3]: round with a radius, or with a convex section [K, 2]."""
        path = np.asarray(path, dtype=np.float64)
        shape = shapes.sweep(path, radius, segments, closed)
        self.add(shape, material, shapes.sweep_hulls(path, radius, segments, closed))

    def bar(self, a, b, radius: float | np.ndarray, material: Material | str, segments: int = 10) -> None:
        """A straight bar between two points."""
        self.tube([a, b], radius, material, segments)

    def hull(self, points, material: Material | str) -> None:
        """The convex hull of points [N, 3]: tapered legs, wedges, gems."""
        self.add(shapes.hull(np.asarray(points, dtype=np.float64)), material)

    def _place(self, points: np.ndarray) -> np.ndarray:
        return points @ self._frame[:3, :3].T + self._frame[:3, 3]

    # What others may do with it

    def surface(
        self, name: str, x: Interval, y: Interval, z: float, headroom: float | None = None, polygon=None
    ) -> None:
        """A flat place for other things at height z: a rectangle, or a polygon [V, 2] (x and y are then ignored).

        The polygon is where footprints may be, so leave out lips and back panels.
        """
        corners = [(x[0], y[0]), (x[1], y[0]), (x[1], y[1]), (x[0], y[1])] if polygon is None else polygon
        placed = self._place(np.array([(px, py, z) for px, py in corners], dtype=np.float64))
        flat = tuple((float(a), float(b)) for a, b, _ in placed)
        self._surfaces.append(Surface(name=name, polygon=flat, z=float(placed[0, 2]), headroom=headroom))

    def unsurface(self) -> Surface:
        """Take the surface named last away again, to name it anew in another shape."""
        return self._surfaces.pop()

    def resurface(self, surface: Surface, polygon: Sequence[Interval]) -> None:
        """Put a surface that was taken away back with another polygon."""
        self._surfaces.append(surface.model_copy(update={"polygon": tuple(polygon)}))

    def zone(self, name: str, x: Interval, y: Interval, z: Interval = (0.0, ZONE_HEIGHT), hard: bool = True) -> None:
        """Room that must stay free for use; replaces the zone that the category's ``clearance`` gives that side."""
        polygon = ((x[0], y[0]), (x[1], y[0]), (x[1], y[1]), (x[0], y[1]))
        self._zones.append(Zone(name=name, polygon=polygon, z=z, hard=hard))

    def clear(self, x: Interval, y: Interval, z: Interval) -> None:
        """Room inside the box that prisms should not fill: where knees, or a chair, go."""
        self._clear.append((x, y, z))

    # The asset

    def fit(self, size: Sequence[float] | None = None) -> None:
        """Stretch all that was drawn so far until its box has this size, by default the one to draw."""
        points = np.concatenate([v for v, *_ in self._pieces])
        scale = np.asarray(size or self.size) / (points.max(axis=0) - points.min(axis=0))
        s = tuple(float(v) for v in scale)
        self._pieces = [(v * scale, f, m, k) for v, f, m, k in self._pieces]
        self._hulls = [Hull(h.vertices * scale, h.faces, h.link) for h in self._hulls]
        self._surfaces = [
            Surface(
                name=k.name,
                polygon=tuple((x * s[0], y * s[1]) for x, y in k.polygon),
                z=k.z * s[2],
                headroom=None if k.headroom is None else k.headroom * s[2],
            )
            for k in self._surfaces
        ]
        self._links = [
            Link(k.name, k.joint, k.axis, (k.anchor[0] * s[0], k.anchor[1] * s[1], k.anchor[2] * s[2]), k.limits)
            for k in self._links
        ]
        self._clear = [
            ((x[0] * s[0], x[1] * s[0]), (y[0] * s[1], y[1] * s[1]), (z[0] * s[2], z[1] * s[2]))
            for x, y, z in self._clear
        ]

    def finish(self) -> Asset:
        """All that was drawn, as an asset with its origin at the bottom centre of its box."""
        offsets = np.cumsum([0] + [len(v) for v, *_ in self._pieces])
        vertices = np.concatenate([v for v, *_ in self._pieces])
        faces = np.concatenate([f + o for (_, f, *_), o in zip(self._pieces, offsets[:-1], strict=True)])
        count = [len(f) for _, f, *_ in self._pieces]
        low, high = vertices.min(axis=0), vertices.max(axis=0)
        shift = np.array([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]])
        mesh = Mesh(
            vertices=vertices - shift,
            faces=faces.astype(np.int32),
            face_material=np.repeat([m for *_, m, _ in self._pieces], count).astype(np.int32),
            face_link=np.repeat([link for *_, link in self._pieces], count).astype(np.int32),
            materials=tuple(self._materials),
        )
        hulls = tuple(Hull(h.vertices - shift, h.faces, h.link) for h in self._hulls)
        surfaces = tuple(_moved(s, shift) for s in self._surfaces)
        size = tuple(float(v) for v in high - low)
        dx, dy, dz = shift
        clear: list[tuple[Interval, Interval, Interval]] = [
            ((x[0] - dx, x[1] - dx), (y[0] - dy, y[1] - dy), (z[0] - dz, z[1] - dz)) for x, y, z in self._clear
        ]
        clear += [_above(s) for s in surfaces]
        zones = [Zone(name=z.name, polygon=_shifted(z.polygon, shift), z=z.z, hard=z.hard) for z in self._zones]
        named = {z.name for z in zones}
        zones += access_zones(self.category, size, named)
        main = self._roles[self._main] if self._main else next(iter(self._roles.values()), None)
        name = self.request.label or self.category.name
        attributes: dict[str, Any] = {"style": self.style}
        if main is not None:
            attributes |= {"color": color_name(main.color), "material": main.name}
        attributes |= {key: value for key, value in self._shown.items() if key != "material"}
        attributes |= self._counted()
        parts = prisms_of(hulls, self._groups, clear)
        if self.request.shape and outline_shape(hulls, self._outline_axes) == self.request.shape:
            attributes["shape"] = self.request.shape
        surfaces = tuple(_on_parts(s, parts) for s in surfaces)
        return Asset(
            id=f"parametric:{self.category.name}?seed={self._seed}{self.request.suffix}",
            category=name,
            mesh=mesh,
            hulls=hulls,
            parts=parts,
            mount=self.category.mount[0],
            mass=self._mass(size),
            friction=self.category.friction,
            origin=Origin(source="parametric", licence="Apache-2.0", attribution="sceneweaver"),
            surfaces=surfaces,
            zones=tuple(zones),
            sides=self.category.sides,
            links=tuple(Link(k.name, k.joint, k.axis, _vec(np.array(k.anchor) - shift), k.limits) for k in self._links),
            attributes=attributes,
            description=f"{main.name} {name.replace('_', ' ')}" if main is not None else name.replace("_", " "),
        )

    def _counted(self) -> dict[str, int]:
        """How many there are of the parts that were asked for, as far as they can be told from what was drawn."""
        joints = [link.joint for link in self._links]
        there = {"drawers": joints.count("slide"), "doors": joints.count("hinge"), "shelves": len(self._surfaces)}
        return {name: there[name] for name, _ in self.request.parts if there.get(name)}

    def _mass(self, size: tuple[float, ...]) -> float:
        """Between the category's least and largest mass by where the box's volume lies in its range."""
        assert self.category.size is not None
        least, most = (math.prod(r[k] for r in self.category.size.ranges) for k in (0, 1))
        share = (math.prod(size) - least) / max(1e-12, most - least)
        low, high = self.category.mass
        return round(low + (high - low) * min(1.0, max(0.0, share)), 3)


def outline_shape(hulls: Sequence[Hull], axes: tuple[int, int] = (0, 1)) -> str | None:
    """Round, oval, square or rectangular: what the outline of some bodies is, along two axes; None: something else."""
    import shapely

    outline = shapely.MultiPoint(np.concatenate([h.vertices[:, list(axes)] for h in hulls])).convex_hull
    ring = shapely.get_coordinates(outline.minimum_rotated_rectangle)
    a, b = sorted(np.linalg.norm(ring[k + 1] - ring[k]) for k in (0, 1))
    fill, even = outline.area / max(a * b, 1e-12), b < 1.12 * a
    if fill > 0.9:
        return "square" if even else "rectangular"
    if 0.74 < fill < 0.87:
        return "round" if even else "oval"
    return None


THICK = 0.003
"""Height [m] by which a prism may stand above the surface that it carries, as it takes in a rim or a joint."""


def _on_parts(surface: Surface, parts: Sequence[Part]) -> Surface:
    """The surface as high as the prisms under it, so that what stands on it does not stand in them."""
    import shapely

    inner = shapely.Polygon(surface.polygon).buffer(-0.002)
    tops = [
        part.z[1]
        for part in parts
        if part.z[0] < surface.z < part.z[1] <= surface.z + THICK
        and shapely.Polygon(part.polygon).intersection(inner).area > 1e-4
    ]
    if not tops:
        return surface
    room = None if surface.headroom is None else surface.headroom - (max(tops) - surface.z)
    return surface.model_copy(update={"z": max(tops), "headroom": room})


def _vec(values) -> Vec3:
    x, y, z = (float(v) for v in values)
    return x, y, z


def _moved(surface: Surface, shift: np.ndarray) -> Surface:
    return Surface(
        name=surface.name,
        polygon=_shifted(surface.polygon, shift),
        z=round(surface.z - float(shift[2]), 6),
        headroom=surface.headroom,
    )


def _shifted(polygon, shift: np.ndarray) -> tuple[tuple[float, float], ...]:
    return tuple((round(x - float(shift[0]), 6), round(y - float(shift[1]), 6)) for x, y in polygon)


def _above(surface: Surface) -> tuple[Interval, Interval, Interval]:
    """The box over a surface that must stay free of prisms, a little smaller than the room itself."""
    xs, ys = [p[0] for p in surface.polygon], [p[1] for p in surface.polygon]
    top = surface.z + min(surface.headroom or 0.3, 0.3)
    return (min(xs) + 1e-3, max(xs) - 1e-3), (min(ys) + 1e-3, max(ys) - 1e-3), (surface.z + 1e-3, top - 1e-3)
