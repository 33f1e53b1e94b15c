"""The drawing of one asset: shapes, what others may do with it, and the size that all is stretched to."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from typing import Literal

import numpy as np

from sceneweaver.scene import Surface, Zone

from .. import shapes
from ..body import Grasp, Hull, Link, Material
from ..shapes.convex import Shape
from ..zones import ZONE_HEIGHT
from .box import Axis, Box, Interval, Vec3
from .rooms import holds as holds_things
from .rooms import lathed_room, lofted_room, staves_of
from .tree import Piece, Tree, vec3

Look = Material | str

PROUD = 0.0003
"""How far [m] prints and labels stand out of what they lie on: less than the rules for collision parts notice."""


class Drawing(Tree):
    """Draws one asset in the object's frame: bottom at z = 0, front +x, left +y, metres.

    Every shape is at once a piece of the visual mesh and one or more convex collision parts. Shapes fill a `Box` and
    return it, so that the next part is found from it.
    """

    _collides = True

    @contextmanager
    def no_colliders(self) -> Iterator[None]:
        """What is drawn inside adds no collision parts: only for what lies in other parts, as drinks and labels do."""
        before, self._collides = self._collides, False
        try:
            yield
        finally:
            self._collides = before

    @contextmanager
    def convex(self, box: bool = False) -> Iterator[None]:
        """What is drawn inside has one collision part, the hull of all of it: for things that are nearly convex.

        As a ``box`` along the axes of the object it is coarser, and lies still where it is thin.
        """
        first = len(self.drawn.hulls)
        yield
        own = self.drawn.hulls[first:]
        if len(own) > 1:
            corners = np.concatenate([hull.vertices for hull in own])
            low, high = corners.min(axis=0).tolist(), corners.max(axis=0).tolist()
            x, y, z = zip(low, high, strict=True)
            points, faces = shapes.box(x, y, z) if box else shapes.hull(corners)
            self.drawn.hulls[first:] = [replace(own[0], vertices=points, faces=faces)]
            del self.drawn.groups[first + 1 :]

    # Shapes

    def add(
        self, shape: Shape, material: Look, hulls: Sequence[Shape] | None = None, uv: np.ndarray | None = None
    ) -> None:
        """Any closed shape.

        Args:
            shape: Vertices [V, 3] and faces [F, 3] in the current frame.
            material: Its finish, or the name of one.
            hulls: Its convex parts; None: the shape itself, which must then be convex. An empty list adds no
                collision part: only for what lies inside other parts.
            uv: Texture coordinates [F, 3, 2] of the corners of its faces [m]; None: laid out at the end.
        """
        vertices, faces = shape
        self.drawn.pieces.append(Piece(vertices, faces, self._frame, self.named(material), self._link, uv))
        if not self._collides:
            return
        turn, shift = self._frame[:3, :3], self._frame[:3, 3]
        for points, triangles in [shape] if hulls is None else hulls:
            self.drawn.hulls.append(Hull(points @ turn.T + shift, triangles, self._link, self._handle))
            self.drawn.groups.append(self._group)

    def box(self, box: Box, material: Look, bevel: float = 0.003) -> Box:
        """A box, its edges cut by ``bevel``."""
        self.add(shapes.box(box.x, box.y, box.z, bevel), material)
        return box

    def slab(self, box: Box, material: Look, radius: float = 0.01, bevel: float = 0.001, steps: int = 3) -> Box:
        """A box with corners of ``radius`` in its plan, and edges cut by ``bevel`` at top and bottom."""
        cut = min(bevel, 0.45 * box.height, 0.6 * radius)
        rings = [
            shapes.rectangle(box.inset(x=e).x, box.inset(y=e).y, z, radius - e, steps)
            for e, z in ((cut, box.z[0]), (0.0, box.z[0] + cut), (0.0, box.z[1] - cut), (cut, box.z[1]))
        ]
        self.loft(rings, material, convex=True)
        return box

    def cylinder(
        self,
        box: Box,
        material: Look,
        axis: Axis = "z",
        ends: tuple[float, float] = (1.0, 1.0),
        bevel: float = 0.0,
        segments: int = 24,
    ) -> Box:
        """A cylinder or cone along an axis that fills a box, elliptic where that is not square.

        ``ends`` are the shares of the full width at its lower and its upper end.
        """
        order = {"x": (1, 2, 0), "y": (2, 0, 1), "z": (0, 1, 2)}[axis]
        size = [box.size[k] for k in order]
        least = min(size[0], size[1]) / 2
        points, faces = shapes.frustum(ends[0] * least, ends[1] * least, (0.0, size[2]), segments, bevel)
        placed = np.empty_like(points)
        middle = box.anchor({"x": "back", "y": "right", "z": "bottom"}[axis])
        for k, to in enumerate(order):
            stretch = size[k] / (2 * least) if k < 2 else 1.0
            placed[:, to] = points[:, k] * stretch + middle[to]
        self.add((placed, faces), material)
        return box

    def ball(self, box: Box, material: Look, segments: int = 20) -> Box:
        """An ellipsoid that fills a box."""
        d, w, h = box.size
        shape = shapes.ball((d / 2, w / 2, h / 2), box.center, segments)
        self.add(shape, material, None if segments <= 12 else [shapes.containing_hull(shape[0])])
        return box

    def cushion(self, box: Box, material: Look, radius: float = 0.04, puff: float = 0.0) -> Box:
        """Upholstery: a box with round edges; ``puff`` (0 to 1) swells its faces. It fills the box."""
        shape = shapes.cushion(box.x, box.y, box.z, radius, puff)
        if puff > 0:
            self.add(shape, material, [shapes.containing_hull(shape[0])])
            return box
        # The planes at 45 degrees that touch round edges of radius r cut (2 - sqrt 2) r off a box.
        r = min(radius, 0.4995 * min(box.size))
        self.add(shape, material, [shapes.box(box.x, box.y, box.z, 0.5857 * r)])
        return box

    def print(self, box: Box, material: Look, proud: float = PROUD, oval: bool = False) -> Box:
        """A print, a label, a lit key: it stands ``proud`` metres out of what it lies on and has no collision part.

        Give the place on the surface, flat in one axis: ``screen.front(0)``, ``cup.top(0).inset(x=0.01, y=0.01)``. It
        is a rectangle or an ``oval``.
        """
        out = box.inset(-proud)
        if oval:
            flat = min(range(3), key=lambda k: out.size[k])
            axis: Axis = ("x", "y", "z")[flat]
            with self.no_colliders():
                self.cylinder(out, material, axis, segments=16)
        else:
            self.add(shapes.box(out.x, out.y, out.z), material, [])
        return box

    def revolve(
        self,
        profile: Sequence[tuple[float, float]],
        material: Look,
        segments: int = 24,
        hollow: bool = False,
        stretch: tuple[float, float] = (1.0, 1.0),
        collides: bool = True,
        holds: bool = True,
        staves: int = 0,
    ) -> None:
        """A profile of (radius, z) turned about z, stretched along x and y.

        A solid one rises from bottom to top. A hollow one runs up outside and down again inside; where that is deep
        and wide enough to hold something, it has an interior and its parts leave that free, unless it is full
        and ``holds`` nothing else. One with ``staves`` has so many parts around, however shallow.
        """
        points, faces = shapes.lathe(list(profile), segments)
        scale = np.array([*stretch, 1.0])
        hulls: list[Shape] = []
        if collides and self._collides:
            top = max(range(len(profile)), key=lambda i: (profile[i][1], -i))
            rising = list(profile[: top + 1]) if hollow else list(profile)
            room = lathed_room(profile[top:], scale) if hollow and holds else None
            if room is None and not staves:
                parts = shapes.lathe_hulls(rising, segments)
            else:
                count = staves or staves_of(room) if room else staves
                parts = shapes.hollow_hulls(rising, list(profile[top + 1 :]), segments, count)
                if room is not None and self.upright:
                    self.interior("inside", room, oval=True)
            hulls = [(v * scale, f) for v, f in parts]
        self.add((points * scale, faces), material, hulls)

    def turned(
        self,
        box: Box,
        profile: Sequence[tuple[float, float]],
        material: Look,
        segments: int = 24,
        hollow: bool = False,
        holds: bool = True,
        staves: int = 0,
    ) -> Box:
        """A profile of (radius, height) in shares of a box, turned about its middle; elliptic where it is not square.

        (1, 0) lies on the box's sides at its bottom. It is solid or hollow as `revolve` says.
        """
        x, y, z = box.anchor("bottom")
        with self.at(x, y, z):
            shares = [(r, box.height * s) for r, s in profile]
            self.revolve(shares, material, segments, hollow, (box.depth / 2, box.width / 2), holds=holds, staves=staves)
        return box

    def extrude(self, polygon, span: Interval, material: Look, *, axis: Axis = "z", bevel: float = 0.0) -> None:
        """A simple polygon [V, 2], counter-clockwise, drawn along an axis.

        The polygon's coordinates are (x, y) along z, (y, z) along x and (z, x) along y.
        """
        plan = np.asarray(polygon, dtype=np.float64)
        turn = {"z": [0, 1, 2], "x": [2, 0, 1], "y": [1, 2, 0]}[axis]
        pieces = shapes.convex_pieces(plan)
        made = [shapes.extrusion(plan, span, bevel)]
        made += [shapes.extrusion(piece, span) for piece in pieces] if len(pieces) > 1 else []
        made = [(points[:, turn], faces) for points, faces in made]
        self.add(made[0], material, made[1:] or None)

    def silhouette(self, box: Box, outline, material: Look, axis: Axis = "y", bevel: float = 0.0) -> Box:
        """A polygon [V, 2] drawn through a box along an axis, its points shares of the box as seen from there.

        They are (x, z) along y, (y, z) along x and (x, y) along z, either way round; it need not be convex.
        """
        spans = {"x": (box.y, box.z), "y": (box.x, box.z), "z": (box.x, box.y)}[axis]
        low = np.array([span[0] for span in spans])
        plan = low + np.asarray(outline, dtype=np.float64) * (np.array([span[1] for span in spans]) - low)
        plan = plan[:, ::-1] if axis == "y" else plan  # `extrude` has (z, x) there
        after = np.roll(plan, -1, axis=0)
        if (plan[:, 0] * after[:, 1] - plan[:, 1] * after[:, 0]).sum() < 0:
            plan = plan[::-1]
        self.extrude(plan, {"x": box.x, "y": box.y, "z": box.z}[axis], material, axis=axis, bevel=bevel)
        return box

    def sweep(
        self,
        path,
        section: float | tuple[float, float] | np.ndarray,
        material: Look,
        segments: int = 10,
        closed: bool = False,
    ) -> None:
        """A bar along points [N, 3]: round with a radius, flat with width and height, or of a convex section [K, 2]."""
        path = np.asarray(path, dtype=np.float64)
        if isinstance(section, tuple):
            section = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) * np.array(section) / 2
        hulls = shapes.sweep_hulls(path, section, segments, closed) if self._collides else []
        self.add(shapes.sweep(path, section, segments, closed), material, hulls)

    def bar(
        self,
        start: Vec3,
        end: Vec3,
        section: float | tuple[float, float] | np.ndarray,
        material: Look,
        segments: int = 10,
    ) -> None:
        """A straight bar between two points, with a section as in `sweep`."""
        self.sweep([start, end], section, material, segments)

    def arch(self, start: Vec3, end: Vec3, reach: Vec3, radius: float, material: Look, steps: int = 6) -> None:
        """A bent round bar: half an ellipse from one point to another that ``reach`` takes out from their middle."""
        a, c = np.asarray(start, dtype=np.float64), np.asarray(end, dtype=np.float64)
        t = np.linspace(0, np.pi, steps + 1)[:, None]
        self.sweep((a + c) / 2 + (a - c) / 2 * np.cos(t) + np.asarray(reach) * np.sin(t), radius, material, 8)

    def hoop(self, box: Box, radius: float, material: Look, axis: Axis = "z", steps: int = 20) -> None:
        """A ring of round wire whose middle line is the ellipse that a box holds, level in the middle of its axis."""
        t = np.arange(steps) * (2 * np.pi / steps)
        order = {"x": (1, 2, 0), "y": (2, 0, 1), "z": (0, 1, 2)}[axis]
        path = np.empty((steps, 3))
        for wave, k in ((np.cos(t), order[0]), (np.sin(t), order[1]), (0 * t, order[2])):
            path[:, k] = box.center[k] + box.size[k] / 2 * wave
        self.sweep(path, radius, material, 8, closed=True)

    def loft(
        self,
        rings: Sequence[np.ndarray],
        material: Look,
        convex: bool = False,
        hollow: int = 0,
        holds: bool = True,
    ) -> None:
        """A skin over convex rings [K, 3] of as many points each, from bottom to top, closed at both ends.

        Its collision parts are hulls of two neighbours, or one hull where it is convex. The last ``hollow`` rings run
        down again inside: where that is deep enough to hold something, it has an interior and its wall is staves,
        unless it is full and ``holds`` nothing else.
        """
        outer = list(rings[: len(rings) - hollow])
        if hollow > 1 and holds:
            inner = list(rings[-hollow:])
            room, oval = lofted_room(inner)
            if holds_things(room):
                if self.upright:
                    self.interior("inside", room, oval=oval)
                ends = np.linspace(0, len(rings[0]), staves_of(room) + 1).round().astype(int).tolist()
                hulls = shapes.staved_hulls(outer, inner, ends) if self._collides else []
                self.add(shapes.lofted(rings), material, hulls)
                return
        pairs = [outer] if convex else [list(p) for p in zip(outer[:-1], outer[1:], strict=True)]
        solid = [np.concatenate(p) for p in pairs if len(p) > 2 or np.ptp(np.concatenate(p)[:, 2]) > 1e-6]
        self.add(shapes.lofted(rings), material, [shapes.hull(p) for p in solid] if self._collides else [])

    def sections(
        self,
        box: Box,
        rows: Sequence[Sequence[float]],
        material: Look,
        radius: float | None = None,
        convex: bool = False,
        hollow: int = 0,
        holds: bool = True,
    ) -> Box:
        """A skin over level sections of a box, from bottom to top: a `loft` by shares.

        Args:
            box: What shares are of.
            rows: Of each section depth, width and height, and if need be how far its middle lies from the box's along
                x and y, all as shares of the box.
            material: Its finish.
            radius: Of the corners, as a share of the section's shorter side; None: sections are ellipses.
            convex: As in `loft`; so is ``hollow``.
            hollow: How many of the last sections run down again inside.
            holds: As in `loft`.
        """
        x, y, z = box.anchor("bottom")
        rings = []
        for depth, width, height, *shift in rows:
            dx, dy = (*shift, 0.0, 0.0)[:2]
            own = Box.sized(depth * box.depth, width * box.width, 0.0, (x + dx * box.depth, y + dy * box.width, 0.0))
            level = z + height * box.height
            if radius is None:
                rings.append(shapes.ellipse(own.depth / 2, own.width / 2, level, 20, own.center[0], own.center[1]))
            else:
                rings.append(shapes.rectangle(own.x, own.y, level, radius * min(own.depth, own.width), 4))
        self.loft(rings, material, convex, hollow, holds)
        return box

    def hull(self, points, material: Look) -> None:
        """The convex hull of points [N, 3]: tapered legs, wedges, gems."""
        self.add(shapes.hull(np.asarray(points, dtype=np.float64)), material)

    def pillow(self, box: Box, material: Look) -> Box:
        """A stuffed pillow, lying flat, that fills a box; its hull stays inside."""
        points, faces = shapes.pillow(*box.size)
        x, y, _ = box.center
        points = points + np.array([x, y, box.z[0]])
        self.add((points, faces), material, [shapes.containing_hull(points)])
        return box

    def sheet(self, grid: np.ndarray, thickness: float, material: Look, cells: tuple[int, int] = (1, 1)) -> None:
        """Cloth, a leaf or a bent shell: points [N, M, 3]; its hulls are those of so many patches along N and M."""
        shape, uv = shapes.sheet(grid, thickness), shapes.sheet_uv(grid)
        n, m = grid.shape[:2]
        both = shape[0].reshape(2, n, m, 3)
        down, across = (
            np.unique(np.linspace(0, k - 1, c + 1).round().astype(int)) for k, c in zip((n, m), cells, strict=True)
        )
        hulls = [
            shapes.hull(both[:, a : b + 1, e : f + 1].reshape(-1, 3))
            for a, b in zip(down[:-1], down[1:], strict=True)
            for e, f in zip(across[:-1], across[1:], strict=True)
        ]
        self.add(shape, material, hulls, uv[shape[1]])

    # What others may do with it

    def surface(self, name: str, box: Box, headroom: float | None = None, inset: float = 0.0, polygon=None) -> None:
        """A flat place for other things: the top of a box, moved in by ``inset``, or a polygon [V, 2] at its height.

        It is where footprints may be, so leave out lips and back panels; ``headroom`` is free above it [m].
        """
        inner = box.inset(x=inset, y=inset)
        corners = [(x, y) for x, y in zip((*inner.x, *inner.x[::-1]), np.repeat(inner.y, 2), strict=True)]
        plan = np.array([(x, y, box.z[1]) for x, y in (corners if polygon is None else polygon)], dtype=np.float64)
        placed = plan @ self._frame[:3, :3].T + self._frame[:3, 3]
        flat = tuple((float(a), float(b)) for a, b, _ in placed)
        self.drawn.surfaces.append(Surface(name=name, polygon=flat, z=float(placed[0, 2]), headroom=headroom))

    def zone(self, name: str, x: Interval, y: Interval, z: Interval = (0.0, ZONE_HEIGHT), hard: bool = True) -> None:
        """Room that must stay free for use; replaces the zone that the category's ``clearance`` gives that side."""
        polygon = ((x[0], y[0]), (x[1], y[0]), (x[1], y[1]), (x[0], y[1]))
        self.drawn.zones.append(Zone(name=name, polygon=polygon, z=z, hard=hard))

    def clear(self, box: Box) -> None:
        """Room that prisms should not fill: where knees, or a chair, go."""
        self.drawn.clear.append(box)

    def even(self, which: Literal["box", "round", "cube"]) -> Box:
        """The bounds with equal sides where the request leaves them open: "cube" in all, "round" in plan.

        Of what hangs on a wall, "round" is its front.
        """
        size, asked = list(self.size), self.request.size
        axes = {"box": [], "round": list(self.outline_axes), "cube": [0, 1, 2]}[which]
        lead = next((size[k] for k in axes if asked[k] is not None), size[axes[0]] if axes else 0.0)
        assert self.category.size is not None
        for k in axes:
            if asked[k] is None:
                low, high = self.category.size.ranges[k]
                size[k] = min(max(lead, low), high)
        d, w, h = size
        return Box.sized(d, w, h)

    def fit(self, size: Vec3 | None = None) -> None:
        """Stretch all that was drawn until its box has this size, by default the one to draw.

        Surfaces, zones, clear boxes, hinges and the travel of drawers are stretched with it.
        """
        drawn = self.drawn
        points = np.concatenate([piece.placed for piece in drawn.pieces])
        scale = np.asarray(size or self.size) / np.ptp(points, axis=0)
        stretch = np.diag([*scale, 1.0])
        s = vec3(scale)
        for piece in drawn.pieces:
            piece.frame = stretch @ piece.frame
        drawn.hulls[:] = [replace(h, vertices=h.vertices * scale) for h in drawn.hulls]
        drawn.surfaces[:] = [
            Surface(
                name=k.name,
                polygon=tuple((x * s[0], y * s[1]) for x, y in k.polygon),
                z=k.z * s[2],
                headroom=None if k.headroom is None else k.headroom * s[2],
            )
            for k in drawn.surfaces
        ]
        drawn.zones[:] = [
            Zone(
                name=k.name,
                polygon=tuple((x * s[0], y * s[1]) for x, y in k.polygon),
                z=(k.z[0] * s[2], k.z[1] * s[2]),
                hard=k.hard,
            )
            for k in drawn.zones
        ]
        drawn.clear[:] = [_scaled(box, s) for box in drawn.clear]
        drawn.links[:] = [_stretched(link, scale) for link in drawn.links]
        drawn.grasps[:] = [_stretched_grasp(grasp, scale) for grasp in drawn.grasps]
        drawn.interiors[:] = [
            replace(room, low=vec3(room.low * scale), high=vec3(room.high * scale)) for room in drawn.interiors
        ]


def _scaled(box: Box, s: Vec3) -> Box:
    return Box(*((a * k, b * k) for (a, b), k in zip((box.x, box.y, box.z), s, strict=True)))


def _stretched(link: Link, scale: np.ndarray) -> Link:
    axis = np.array(link.axis) * scale
    far = float(np.linalg.norm(axis))
    limits = (link.limits[0] * far, link.limits[1] * far) if link.joint == "slide" else link.limits
    return replace(link, axis=vec3(axis / far), anchor=vec3(np.array(link.anchor) * scale), limits=limits)


def _stretched_grasp(grasp: Grasp, scale: np.ndarray) -> Grasp:
    """The third axis of a grasp is along neither ``approach`` nor ``closing``."""
    closing = np.array(grasp.closing)
    along = np.cross(grasp.approach, closing)
    width, length = (
        grasp_extent * float(np.linalg.norm(axis * scale))
        for grasp_extent, axis in ((grasp.width, closing), (grasp.length, along))
    )
    return replace(grasp, position=vec3(np.array(grasp.position) * scale), width=width, length=length)
