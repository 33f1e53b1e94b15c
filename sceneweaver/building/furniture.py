"""Objects of a scene out of words: which furniture, how large, what holds it, where it begins."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sceneweaver.assets import Asset, Library, Wish, drawable, resolve
from sceneweaver.assets.asset import Mount
from sceneweaver.assets.taxonomy import category_named
from sceneweaver.io.messages import show
from sceneweaver.scene import InputError, Intent, Pose, Scene, SceneObject, Support, Surface

HUNG = (1.2, 1.5)
"""Heights [m] of the bottom of what hangs on a wall, where its category says nothing."""

BELOW_CEILING = 0.02
"""Least distance [m] of what hangs on a wall from the ceiling."""

Size = tuple[float | None, float | None, float | None]


@dataclass(frozen=True)
class Furniture:
    """A piece of furniture that words name: its asset, what holds it, and a note where the words were unknown."""

    asset: Asset
    mount: Mount
    note: str


def find_furniture(
    what: str, library: Library, *, size: Size, mount: Mount | None, carried: bool, style: str | None, seed: int
) -> Furniture:
    """The furniture that words such as "large white desk" name.

    Args:
        what: a noun, with words about its look before it.
        library: where assets come from.
        size: wanted depth, width and height [m]; None: as usual, or as the words say.
        mount: what is to hold it; None: what usually does.
        carried: whether it is to stand on something.
        style: such as scandinavian.
        seed: which of several that suit.

    Raises:
        InputError: nothing suits, or it usually stands on something and nothing is named.
    """
    if not isinstance(what, str) or not what.strip():
        raise InputError("add: name what to add, such as desk or small round table")
    for side, extent in zip(("depth", "width", "height"), size, strict=True):
        if extent is not None and (isinstance(extent, bool) or not isinstance(extent, int | float)):
            raise InputError(f"add: {side} is {show(extent)}; give metres")
    match = resolve(what, "surface" if carried else mount)
    usual = category_named(match.category).mount
    held: Mount = "surface" if carried else mount or usual[0]
    if held == "surface" and not carried:
        others: list[Mount] = [m for m in usual if m != "surface"]
        if not others:
            word = match.category.replace("_", " ")
            raise InputError(f"add: a {word} stands on something; say on=..., or inside=... for a shelf")
        held = others[0]
    words = " ".join(match.modifiers)
    said = drawable(match.category, words).size if words and not match.generic else (None, None, None)
    depth, width, height = (own if own is not None else meant for own, meant in zip(size, said, strict=True))
    wish = Wish(
        size=(depth, width, height),
        style=style,
        words=words,
        mount=held,
        seed=seed,
        count=1,
        beyond=any(extent is not None for extent in said),
    )
    return Furniture(library.choose(what, 1, wish)[0], held, match.note)


def object_of(furniture: Furniture, name: str, scene: Scene, pose: Pose, support: Support | None) -> SceneObject:
    """The object of a piece of furniture, to begin at a pose; what hangs gets the heights that are usual for it."""
    asset, mount = furniture.asset, furniture.mount
    heights = None
    top = max(0.0, scene.room.height - asset.size[2])
    x, y, z = pose.position
    if mount == "ceiling":
        z = top
    if mount == "wall":
        low, high = category_named(asset.category).bottom or HUNG
        most = max(0.0, top - BELOW_CEILING)
        heights = round(min(low, max(0.0, most - 0.1)), 3), round(min(high, most), 3)
        z = sum(heights) / 2
    placed = Pose(position=(x, y, z), quaternion=pose.quaternion)
    made = asset.object(name, pose=placed, mount=mount, support=support)
    return made.model_copy(update={"intent": Intent(mounting_height=heights, keep_clear=mount == "wall")})


def surface_for(carrier: SceneObject, asset: Asset, inner: bool, name: str | None) -> Surface:
    """The surface of a carrier that something goes on: one by name, else the roomiest that it fits on.

    Args:
        carrier: what carries it.
        asset: what is to stand there.
        inner: whether a board inside is meant (one with something above it), or the top.
        name: of the surface; None: any.

    Raises:
        InputError: no such surface, or none that it fits on.
    """
    import shapely

    known = [s for s in carrier.surfaces if name in (None, s.name) and (name or inner == (s.headroom is not None))]
    if not known:
        names = ", ".join(s.name for s in carrier.surfaces)
        what = f"has no surface {name!r}" if name else "has no board inside" if inner else "has no top to stand on"
        raise InputError(f'add: "{carrier.id}" {what}{f"; its surfaces are {names}" if names else ""}')
    fitting = [s for s in known if _fits(s, asset.size)]
    if not fitting:
        size = " x ".join(f"{v:.2f}" for v in asset.size)
        raise InputError(f'add: {asset.category} ({size} m) fits on no surface of "{carrier.id}"; give a smaller size')
    return max(fitting, key=lambda s: shapely.Polygon(s.polygon).area)


def _fits(surface: Surface, size: Sequence[float]) -> bool:
    """Whether an empty surface could carry a box (depth, width, height) [m], as far as its bounds say."""
    xs, ys = zip(*surface.polygon, strict=True)
    room, own = sorted((max(xs) - min(xs), max(ys) - min(ys))), sorted(size[:2])
    return room[0] >= own[0] and room[1] >= own[1] and (surface.headroom is None or surface.headroom >= size[2])
