"""The builder of scenes. Its types for editors and checkers, with a keyword and a method for every relation type of
the catalogue, are in ``builder.pyi``, which ``tests/building/builder_stub.py`` writes.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable
from typing import Any

from sceneweaver.assets import Library
from sceneweaver.assets.asset import Mount
from sceneweaver.geometry.se2 import SE2
from sceneweaver.scene import CATALOGUE, InputError, Pose, Room, Scene, SceneObject, Support, id_of, point_of

from .furniture import Size, find_furniture, object_of, surface_for
from .relating import relation_type, require_frame, targets_of


def build(
    room: Room,
    *,
    name: str = "scene",
    style: str | None = None,
    seed: int = 0,
    library: Library | None = None,
) -> SceneBuilder:
    """Begin a scene in a room.

    Args:
        room: see `sceneweaver.Room.rectangle`, ``l_shape`` and ``polygon``.
        name: of the scene.
        style: of the furniture, such as scandinavian; None: any.
        seed: which furniture is drawn where several suit; the same words give the same piece.
        library: where furniture comes from; None: the library of this user.

    Examples:
        >>> import sceneweaver as sw
        >>> room = sw.build(sw.Room.rectangle(4, 5, height=2.6, kind="study"))
        >>> door = room.add_door("south", at=0.5)
        >>> desk = room.add("white desk", against="north")
        >>> chair = room.add("office chair", facing=desk, front_against=desk)
        >>> lamp = room.add("lamp", on=desk)
        >>> [o.id for o in room.scene().objects], len(room.scene().relations)
        (['desk-0', 'office_chair-0', 'table_lamp-0'], 3)
    """
    return SceneBuilder(room, name=name, style=style, seed=seed, library=library)


class SceneBuilder:
    """A scene in the making. What is added stays where it was put until `sceneweaver.refine` lays the scene out.

    A call that fails raises InputError with one line and changes nothing. ``notes`` says which words were not known and
    what stands for them.

    Examples:
        >>> import sceneweaver as sw
        >>> room = sw.SceneBuilder(sw.Room.rectangle(3, 4), style="industrial")
        >>> table = room.add("dining table", in_middle=True)
        >>> chairs = room.add_many(4, "dining chair", around=table)
        >>> room
        SceneBuilder(5 objects, 5 relations)
    """

    def __init__(
        self,
        room: Room,
        *,
        name: str = "scene",
        style: str | None = None,
        seed: int = 0,
        library: Library | None = None,
    ) -> None:
        self._scene = Scene(id=name, room=room)
        self._style, self._seed, self._library = style, seed, library or Library()
        self.notes: list[str] = []

    @classmethod
    def of(
        cls, scene: Scene, *, style: str | None = None, seed: int = 0, library: Library | None = None
    ) -> SceneBuilder:
        """A builder that goes on with a scene."""
        builder = cls(scene.room, style=style, seed=seed, library=library)
        builder._scene = scene
        return builder

    def __repr__(self) -> str:
        return f"SceneBuilder({len(self._scene.objects)} objects, {len(self._scene.relations)} relations)"

    @property
    def room(self) -> Room:
        """The room as it is now."""
        return self._scene.room

    @property
    def objects(self) -> tuple[ObjectHandle, ...]:
        """Handles of all objects, in order."""
        return tuple(ObjectHandle(self, name) for name in self._scene.ids)

    def scene(self) -> Scene:
        """The scene as it is now."""
        return self._scene

    def add_door(self, wall: int | str = 0, **options: Any) -> str:
        """Add a door, as `Room.with_door` does; its id."""
        self._set_room(self.room.with_door(wall, **options))
        return self.room.doors[-1].id

    def add_window(self, wall: int | str = 0, **options: Any) -> str:
        """Add a window, as `Room.with_window` does; its id."""
        self._set_room(self.room.with_window(wall, **options))
        return self.room.windows[-1].id

    # All that can be said of a piece is a keyword, so that a call reads as a sentence, hence more than ten.
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
        on: Any = None,
        inside: Any = None,
        surface: str | None = None,
        mount: Mount | None = None,
        fixed: bool = False,
        hard: bool = True,
        seed: int | None = None,
        frame: str | None = None,
        **relations: Any,
    ) -> ObjectHandle:
        """Add a piece of furniture by words, or an object that is there already.

        Args:
            what: a noun with words about its look before it ("small round table"), or a `SceneObject`.
            name: its id; None: its category with a number.
            at: where it begins (x, y) [m]; None: in the middle of the room, or of what it stands on.
            turn: how far it is turned [degrees], counter-clockwise; its front is +x at 0.
            depth, width, height: its size [m]; None: as usual.
            on, inside: what carries it: its top, or a board inside; ``surface`` names one of several.
            mount: floor, wall or ceiling, where it can be had in several ways.
            fixed: whether it must stay where it is.
            hard: whether the relations must hold.
            seed: another piece of the same words; None: the builder's.
            frame: whose left and right relations such as ``left_of`` mean: ``own``, the target's, or ``viewer``.
            relations: where it goes: any type of the catalogue with what it refers to, ``against`` for against_wall.
                Values are objects (handles or ids), names of walls ("north", "wall" for any), ids of doors and windows,
                True where none is needed, two objects for ``between``, or a list for several relations.

        Returns:
            A handle of the object, with a method for every relation type.
        """
        if on is not None and inside is not None:
            raise InputError("add: both on and inside are given; give one of them")
        carrier = on if on is not None else inside
        furniture = None
        if isinstance(what, SceneObject):
            obj = what if name is None else what.model_copy(update={"id": name})
        else:
            furniture = self._find(what, (depth, width, height), mount, carrier is not None, seed)
            support, pose = None, self._begin(at)
            if carrier is not None:
                below = self._scene.object(id_of(carrier))
                top = surface_for(below, furniture.asset, inside is not None, surface)
                support, pose = Support(object=below.id, surface=top.name), _upon(below, top)
                if at is not None:
                    pose = Pose(position=point_of("at", at, pose.position[2]), quaternion=pose.quaternion)
            obj = object_of(furniture, name or self._fresh(furniture.asset.category), self._scene, pose, support)
            obj = obj.model_copy(update={"fixed": bool(fixed)})
        scene = self._scene.add(obj)
        if turn:
            scene = scene.move(obj.id, turn=turn)
        for keyword, value in relations.items():
            kind = relation_type(keyword)
            params: dict[str, Any] = {"frame": frame} if frame is not None and "frame" in CATALOGUE[kind].params else {}
            for target in targets_of(kind, value, self.room):
                require_frame(kind, params)
                scene = scene.relate(obj.id, kind, target, hard=hard, **params)
        self._scene = scene
        if furniture is not None and furniture.note:
            self.notes.append(furniture.note)
        return ObjectHandle(self, obj.id)

    def add_many(self, count: int, what: str, **options: Any) -> list[ObjectHandle]:
        """Add the same thing so many times, each as `add` does."""
        if isinstance(count, bool) or not isinstance(count, int) or count < 1:
            raise InputError(f"add_many: {count!r} is not a whole number of at least 1")
        before, notes = self._scene, len(self.notes)
        try:
            return [self.add(what, **options) for _ in range(count)]
        except InputError:
            self._scene = before
            del self.notes[notes:]
            raise

    def relate(self, subject: Any, type: str, target: Any = True, *, hard: bool = True, **params: Any) -> None:  # noqa: A002
        """Add a relation by the name of its type; ``params`` are its numbers, as the catalogue has them.

        A left or right of the target needs its frame: ``own``, or ``viewer`` for that of who looks at its front.
        """
        kind, scene = relation_type(type), self._scene
        require_frame(kind, params)
        for each in targets_of(kind, True if target is None else target, self.room):
            scene = scene.relate(id_of(subject), kind, each, hard=hard, **params)
        self._scene = scene

    def remove(self, what: Any, *, cascade: bool = False) -> None:
        """Take an object out, with the relations that name it; with ``cascade`` what stands on it as well."""
        self._scene = self._scene.remove(id_of(what), cascade=cascade)

    def _find(self, what: str, size: Size, mount: Mount | None, carried: bool, seed: int | None) -> Any:
        chosen = self._seed if seed is None else seed
        if isinstance(chosen, bool) or not isinstance(chosen, int) or chosen < 0:
            raise InputError(f"seed is {chosen!r}; give a whole number of at least 0")
        return find_furniture(
            what, self._library, size=size, mount=mount, carried=carried, style=self._style, seed=chosen
        )

    def _begin(self, at: tuple[float, float] | None) -> Pose:
        """Where an object begins on the floor."""
        if at is not None:
            return Pose(position=point_of("at", at, 0.0))
        import shapely

        floor = shapely.Polygon(self.room.outline)
        middle = floor.centroid if floor.contains(floor.centroid) else floor.representative_point()
        return Pose(position=(middle.x, middle.y, 0.0))

    def _fresh(self, category: str) -> str:
        """An id ``category-k`` that nothing has."""
        taken = {*self._scene.ids, *(o.id for o in self.room.openings)}
        stem = category.replace(" ", "_")
        return next(name for k in range(len(taken) + 1) if (name := f"{stem}-{k}") not in taken)

    def _set_room(self, room: Room) -> None:
        fields = {name: getattr(self._scene, name) for name in Scene.model_fields if name != "schema_"}
        self._scene = Scene(**{**fields, "room": room})


class ObjectHandle:
    """An object of a `SceneBuilder`. It has a method for every relation type of the catalogue.

    Examples:
        >>> import sceneweaver as sw
        >>> room = sw.build(sw.Room.rectangle(4, 5))
        >>> bed, table = room.add("double bed", against="wall"), room.add("nightstand")
        >>> table.leftright_to_leftright(bed, gap=(0.0, 0.1)).against_wall()
        ObjectHandle('nightstand-0')
        >>> [r.type for r in room.scene().relations]
        ['against_wall', 'leftright_to_leftright', 'against_wall']
    """

    def __init__(self, builder: SceneBuilder, name: str) -> None:
        self._builder = builder
        self.id = name

    def __repr__(self) -> str:
        return f"ObjectHandle({self.id!r})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ObjectHandle) and (other._builder, other.id) == (self._builder, self.id)

    def __hash__(self) -> int:
        return hash((id(self._builder), self.id))

    @property
    def object(self) -> SceneObject:
        """The object as it is now."""
        return self._builder.scene().object(self.id)

    def __getattr__(self, name: str) -> Callable[..., ObjectHandle]:
        if name.startswith("_") or name not in CATALOGUE:
            raise AttributeError(f"{name!r} is no relation type")
        return relation_method(self._builder, self.id, name)

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *CATALOGUE})


def relation_method(builder: SceneBuilder, subject: str, name: str) -> Callable[..., ObjectHandle]:
    """What adds a relation of one type: a function that says in its signature and docstring what it takes."""
    spec = CATALOGUE[name]

    def relate(target: Any = True, /, *, hard: bool = True, **params: Any) -> ObjectHandle:
        builder.relate(subject, name, target, hard=hard, **params)
        return ObjectHandle(builder, subject)

    kinds = inspect.Parameter
    first = [] if spec.target == "none" else [kinds("target", kinds.POSITIONAL_ONLY)]
    if first and spec.target_optional:
        first = [first[0].replace(default=True)]
    named = [kinds("hard", kinds.KEYWORD_ONLY, default=True)]
    named += [kinds(p.name, kinds.KEYWORD_ONLY, default=p.default) for p in spec.params.values()]
    relate.__name__, relate.__doc__ = name, spec.description
    relate.__signature__ = inspect.Signature([*first, *named])  # type: ignore[attr-defined]
    return relate


def _upon(carrier: SceneObject, surface: Any) -> Pose:
    """The middle of a surface, turned as its carrier is."""
    import shapely

    x, y, z = carrier.pose.position
    middle = shapely.Polygon(surface.polygon).centroid
    u, v = SE2(x, y, carrier.pose.yaw).world(middle.x, middle.y)
    return Pose(position=(u, v, z + surface.z), quaternion=carrier.pose.quaternion)
