"""A session of live edits: the compiled problem is kept, and each edit is followed by a small solve."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Collection
from dataclasses import dataclass
from typing import Any

from sceneweaver.assets import Library
from sceneweaver.building import SceneBuilder
from sceneweaver.layout.live import LiveLayout
from sceneweaver.repairs.report import Move, moves_between
from sceneweaver.scene import AnyEdit, InputError, Named, Scene, SceneObject, id_of
from sceneweaver.scene.edits import edited_ids
from sceneweaver.verify import Report, check

from .settling import Freed, settle

RESIZED = 0.25
"""How far [m] something that was resized may be pushed from where it stands before others make way."""

LEAST = 0.1
"""The same at least, however short the way was that something was moved."""


@dataclass(frozen=True)
class EditResult:
    """A scene after an edit.

    Attributes:
        scene: the scene as it is now.
        report: the judge on it; without the share of floor that can be walked on.
        moves: what was moved so that the scene is valid, beyond the edit itself.
        freed: what was free to move in the end, see `Freed`.
        seconds: from call to return.

    Examples:
        >>> import sceneweaver as sw
        >>> session = sw.EditSession(sw.Scene.example("bedroom"), device="cpu")
        >>> result = session.move("chair", by=(0.0, 0.05))
        >>> result.valid, result.scene is session.scene
        (True, True)
    """

    scene: Scene
    report: Report
    moves: tuple[Move, ...]
    freed: Freed
    seconds: float

    def __repr__(self) -> str:
        valid = "valid" if self.valid else f"{sum(v.hard for v in self.report.violations)} violations"
        return f"EditResult({valid}, {len(self.moves)} moved, {1e3 * self.seconds:.0f} ms)"

    @property
    def valid(self) -> bool:
        """Whether the judge calls the scene valid."""
        return self.report.valid


class EditSession:
    """A scene under live edits.

    Every edit gives a valid scene where one is found, and moves as little as possible for it: first what was edited
    alone, then what is in its way, then both; everything only where that does not do. Chance comes from ``seed`` alone.

    Args:
        scene: what to begin with; it is left as it is.
        device: "auto", "cpu", "cuda" or "cuda:k".
        seed: of the search, and of furniture that is added by words.
        library: where such furniture comes from; None: the library of this user.
        ready: whether to load the kernels and compile the scene now; else the first edit that can be done does.

    Examples:
        >>> import sceneweaver as sw
        >>> session = sw.EditSession(sw.Scene.example("bedroom"), device="cpu")
        >>> session.resize("wardrobe", height=1.9).valid
        True
        >>> added = session.add("plant", near="armchair")
        >>> added.valid, added.scene.objects[-1].category
        (True, 'potted_plant')
        >>> session.undo().scene.object("wardrobe").size[2]
        1.9
    """

    def __init__(
        self,
        scene: Scene,
        *,
        device: str = "auto",
        seed: int = 0,
        library: Library | None = None,
        ready: bool = True,
    ) -> None:
        if not isinstance(scene, Scene):
            raise InputError(f"scene: {type(scene).__name__} is not a Scene")
        self._live, self._seed, self._library = LiveLayout(device), seed, library
        self._scene, self._report = scene, check(scene, walkable=False)
        self._past: list[tuple[Scene, Report]] = []
        if ready:
            self._live.settle(scene, scene.ids[:1])  # loads the kernels and compiles the scene

    @property
    def scene(self) -> Scene:
        """The scene as it is now."""
        return self._scene

    @property
    def report(self) -> Report:
        """The judge on the scene as it is now."""
        return self._report

    def move(self, what: Named, *, to: Any = None, by: Any = None, turn: float = 0.0) -> EditResult:
        """Move or turn an object; arguments as for `Scene.move`."""
        name = id_of(what)
        return self._run(lambda scene: (scene.move(name, to=to, by=by, turn=turn), {name}))

    def resize(
        self, what: Named, *, depth: float | None = None, width: float | None = None, height: float | None = None
    ) -> EditResult:
        """Resize an object [m]; what is not given stays."""
        name = id_of(what)
        return self._run(lambda scene: (scene.resize(name, depth=depth, width=width, height=height), {name}))

    def add(self, what: str | SceneObject, **options: Any) -> EditResult:
        """Add furniture by words, or an object; arguments as for `SceneBuilder.add`. It is the last of the objects.

        It stands as near as possible to where it is put, ``at`` or in the middle of the room.
        """

        def changed(scene: Scene) -> tuple[Scene, Collection[str]]:
            builder = SceneBuilder.of(scene, seed=self._seed, library=self._library)
            handle = builder.add(what, **options)
            return builder.scene(), {handle.id}

        return self._run(changed)

    def remove(self, what: Named, *, cascade: bool = False) -> EditResult:
        """Take an object out, and the relations that name it; with ``cascade`` what stands on it as well."""
        name = id_of(what)
        return self._run(lambda scene: (scene.remove(name, cascade=cascade), set()))

    def relate(self, subject: Named, type: str, target: Any = True, **options: Any) -> EditResult:  # noqa: A002
        """Add a relation; arguments as for `SceneBuilder.relate`."""
        name = id_of(subject)

        def changed(scene: Scene) -> tuple[Scene, Collection[str]]:
            builder = SceneBuilder.of(scene)
            builder.relate(name, type, target, **options)
            return builder.scene(), {name}

        return self._run(changed)

    def unrelate(self, subject: Named, type: str, target: Any = None) -> EditResult:  # noqa: A002
        """Take out a relation; arguments as for `Scene.unrelate`."""
        return self._run(lambda scene: (scene.unrelate(subject, type, target), set()))

    def edit(self, *edits: AnyEdit) -> EditResult:
        """Apply typed edits (`sceneweaver.scene.edits`) as one."""
        return self._run(lambda scene: (scene.edit(*edits), edited_ids(edits)))

    def update(self, scene: Scene, edited: Collection[str] = ()) -> EditResult:
        """Go on with a scene that was edited elsewhere; ``edited`` are the ids of what was changed in it."""
        if not isinstance(scene, Scene):
            raise InputError(f"update: {type(scene).__name__} is not a Scene")
        for name in edited:
            scene.index(name)
        return self._run(lambda _: (scene, set(edited)))

    def undo(self) -> EditResult:
        """Take the last edit back, with all that it moved; InputError where there is none."""
        began = time.perf_counter()
        if not self._past:
            raise InputError("undo: there is no edit to take back")
        before = self._scene
        self._scene, self._report = self._past.pop()
        moves = moves_between(before, self._scene)
        return EditResult(self._scene, self._report, moves, "nothing", time.perf_counter() - began)

    def _run(self, change: Callable[[Scene], tuple[Scene, Collection[str]]]) -> EditResult:
        """Change the scene, settle it, and remember what it was. A change that fails leaves all as it was."""
        began, before = time.perf_counter(), self._scene
        after, named = change(before)
        edited = {name: _leeway(before, after, name) for name in named if name in after.ids}
        settled = settle(self._live, after, edited, frozenset(after.ids).difference(before.ids), self._seed)
        self._past.append((before, self._report))
        self._scene, self._report = settled.scene, settled.report
        moves = moves_between(after, settled.scene)
        return EditResult(settled.scene, settled.report, moves, settled.freed, time.perf_counter() - began)


def _leeway(before: Scene, after: Scene, name: str) -> float:
    """How far [m] an object may be pushed from where an edit put it before others make way for it."""
    if name not in before.ids:
        return math.inf
    old, new = before.object(name), after.object(name)
    if old.pose != new.pose:
        return max(LEAST, 0.5 * math.dist(old.pose.position[:2], new.pose.position[:2]))
    return math.inf if old.size == new.size else RESIZED
