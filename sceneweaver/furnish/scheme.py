"""The look of a whole home: one style, one palette, floors of one family, doors and skirtings alike."""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from sceneweaver.generate.finish import finished, tile_color
from sceneweaver.generate.look import look_of
from sceneweaver.generate.room import kept
from sceneweaver.knowledge import RoomType
from sceneweaver.knowledge.palettes import Palette, floor_for, groups_of, palette_for
from sceneweaver.language import SceneGraph
from sceneweaver.scene import Palette as ScenePalette
from sceneweaver.scene import Room
from sceneweaver.scene.finish import FloorFinish, FloorMaterial

LEADING = ("living_room", "bedroom", "office", "waiting_room")
"""Kinds of rooms of which the first that a home has leads its palette."""

OTHERS = ("home", "wet")
"""Groups of palettes whose rooms have the home's own; of the others they have colours of cloth of their own."""

WET = frozenset(("tile", "stone"))
"""Floors of rooms with water: no floor of living rooms is of them."""

OWN_FLOORS = frozenset(("balcony", "garage", "cellar", "boiler_room", "workshop"))
"""Kinds of rooms whose floor has nothing to do with that of the home."""


@dataclass(frozen=True)
class Scheme:
    """The look of a home.

    Attributes:
        style: of all furniture.
        palette: woods, paints, metals, colours.
        dry: the floor of living rooms, halls and bedrooms.
        wet: that of rooms with water.
        trim: finish of skirtings, frames and doors; None: white.
        seed: what the palette leaves open is drawn by it, in every room alike.
    """

    style: str
    palette: Palette
    dry: FloorFinish
    wet: FloorFinish
    trim: str | None
    seed: int

    def shell(self, room: Room, kind: RoomType, brief: SceneGraph, floor: FloorFinish | None) -> Room:
        """The room finished in the look of the home, but for what its own request states.

        Args:
            room: the shell.
            kind: the kind of room.
            brief: its request.
            floor: ``dry`` or ``wet``, see `floor_of`; None: that of its kind, as on a balcony.
        """
        made = finished(room.model_copy(update={"finish": None}), kind, self.palette, self.seed, brief)
        if made.finish is None:
            return made
        update: dict[str, object] = {}
        if floor is not None and brief.finish_of("floor") is None and brief.finish_of("everything") is None:
            update["floor"] = floor
        if made.finish.trim is None and self.trim is not None:
            update["trim"] = self.trim
        return made.model_copy(update={"finish": made.finish.model_copy(update=update)})

    def floor_of(self, kind: RoomType, *, outdoor: bool = False, opens_to_dry: bool = False) -> FloorFinish | None:
        """The floor of a room: of tiles where there is water, but where it opens into a room without; None: its own.

        Args:
            kind: the kind of room.
            outdoor: whether it is a balcony or terrace.
            opens_to_dry: whether a passage without a leaf leads to a room with the dry floor.
        """
        if outdoor or {*groups_of(kind.name)} <= {"utility"} or kind.name in OWN_FLOORS:
            return None
        return self.wet if is_wet(kind) and not opens_to_dry else self.dry

    def look(self, kind: RoomType, brief: SceneGraph) -> ScenePalette | None:
        """Style and colours of the furniture of a room; None where its request has a look of its own."""
        if brief.style or brief.colors or brief.finish_of("furniture") or brief.finish_of("everything"):
            return None
        if look_of(brief) is not None:
            return None
        palette = self.palette
        if not {*groups_of(kind.name)} & {*OTHERS, *palette.groups}:
            own = palette_for(kind.name, self.style, (), self.seed)
            palette = palette.model_copy(update={"textiles": own.textiles})
        return kept(palette, self.style, self.seed)


def scheme_of(kinds: Sequence[RoomType], brief: SceneGraph, seed: int) -> Scheme:
    """The look of a home with such rooms.

    Args:
        kinds: of its rooms.
        brief: the request for the home; a style or colours that it names are those of all rooms.
        seed: draws among the looks that suit.
    """
    look = look_of(brief)
    named = brief.style or (look.style if look is not None else None)
    style = named or _common_style(kinds, seed)
    known = {kind.name: kind for kind in kinds}
    leading = next((name for name in LEADING if name in known), kinds[0].name)
    palette = palette_for(leading, style, brief.colors, seed, look)
    material = floor_for(leading, known[leading].floor, seed)
    dry: FloorMaterial = "wood" if material in WET else material
    tone = palette.floors.get("tile") or tile_color(palette)
    trim = look.trim if look is not None else None
    return Scheme(
        style=style,
        palette=palette,
        dry=FloorFinish(material=dry, tone=palette.floors.get(dry)),
        wet=FloorFinish(material="tile", tone=tone),
        trim=trim,
        seed=seed,
    )


def _common_style(kinds: Sequence[RoomType], seed: int) -> str:
    """A style that most of the rooms have."""
    count = Counter(style for kind in kinds for style in kind.styles)
    most = max(count.values())
    return random.Random(f"style of a home {seed}").choice(sorted(s for s, n in count.items() if n == most))


def is_wet(kind: RoomType) -> bool:
    """Whether a kind of room has a floor for water: its own one is of tiles, or its walls are tiled."""
    return kind.floor == "tile" or kind.tiles is not None
