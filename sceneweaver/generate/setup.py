"""What every generator starts from, and what it answers."""

from __future__ import annotations

from dataclasses import dataclass, field

from sceneweaver.assets import Library
from sceneweaver.knowledge import RoomType
from sceneweaver.language import SceneGraph
from sceneweaver.scene import Palette, Relation, Room, Scene
from sceneweaver.scene.edits import AnyEdit


@dataclass(frozen=True)
class Setup:
    """A request with its kind of room, the scene so far, where bodies come from, and the seed of all that is drawn.

    ``room`` is the shell where somebody gives it: neither its outline nor its openings change, nor a finish that it
    has. ``palette`` is the look where somebody gives that. None of either: they are drawn.
    """

    brief: SceneGraph
    room_type: RoomType
    scene: Scene
    library: Library
    seed: int
    room: Room | None = field(default=None, kw_only=True)
    palette: Palette | None = field(default=None, kw_only=True)


@dataclass(frozen=True)
class Proposal:
    """What a generator or a tool answers.

    ``scene`` replaces the whole scene (initialisers only), then ``edits`` apply to it in order. Poses in edits are
    proposals: the executor refines them. Each of ``variants`` holds relations that are added to the scene's; of the
    layouts of all variants the best wins. ``rooms`` are others for the same things, with as many walls, doors and
    windows: where the scene's own does not do, the best is taken; ``larger`` ones are for what was asked for and has
    no place. ``notes`` say what was decided, ``unmet`` what could not be done and why. ``fresh`` asks for a layout from
    scratch instead of the least movement. ``origin`` is the scene of somebody else that ``scene`` was made of, as it
    was.
    """

    edits: tuple[AnyEdit, ...] = ()
    scene: Scene | None = None
    variants: tuple[tuple[Relation, ...], ...] = ()
    rooms: tuple[Room, ...] = ()
    larger: tuple[Room, ...] = ()
    fresh: bool = False
    notes: tuple[str, ...] = ()
    unmet: tuple[str, ...] = ()
    origin: Scene | None = None
