"""Writes ``builder.pyi`` of the floor ``building`` from the catalogue: ``python -m tests.building.builder_stub``."""

from __future__ import annotations

import textwrap
from pathlib import Path

from sceneweaver.building.relating import SHORT
from sceneweaver.scene import CATALOGUE, ParamSpec, RelationSpec
from sceneweaver.scene.catalogue import BUILT_IN

STUB = Path(__file__).resolve().parents[2] / "sceneweaver" / "building" / "builder.pyi"

HEAD = """\
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
"""
ADD = """\
    def {method}(
        self,
{first}
        *,
{own}
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
{relations}
    ) -> {result}: ...
"""
HANDLE = """\
    def relate(self, subject: Thing, type: str, target: Any = True, *, hard: bool = True, **params: Any) -> None: ...
    def remove(self, what: Thing, *, cascade: bool = False) -> None: ...

class ObjectHandle:
    id: str
    def __init__(self, builder: SceneBuilder, name: str) -> None: ...
    @property
    def object(self) -> SceneObject: ...
"""
KEYWORD = {
    "none": "bool",
    "wall": "Wall",
    "object": "Things",
    "objects": "tuple[Thing, Thing]",
    "window": "str | bool",
    "door": "str | bool",
}
METHOD = {**KEYWORD, "object": "Thing", "objects": "tuple[Thing, Thing]"}


def keywords() -> str:
    """The keywords of ``add`` that are relations."""
    names = {**SHORT, **{name: name for name in CATALOGUE if name in BUILT_IN and name != "inside"}}
    kinds = {keyword: KEYWORD[CATALOGUE[name].target_kind] for keyword, name in names.items()}
    return "\n".join(f"        {keyword}: {kind} | None = None," for keyword, kind in kinds.items())


def type_of(param: ParamSpec) -> str:
    """The type of a relation's parameter."""
    plain = {"number": "float", "integer": "int", "range": "Range"}
    found = plain.get(param.type) or f"Literal[{', '.join(repr(c) for c in param.choices)}]".replace("'", '"')
    return f'{found} | Literal["tucked"]' if param.default == "tucked" else found


def method(spec: RelationSpec) -> str:
    """The method of a relation type."""
    lines = [f"    def {spec.type}(", "        self,"]
    if spec.target != "none":
        lines += [
            f"        target: {METHOD[spec.target_kind]}{' = True' if spec.target_optional else ''},",
            "        /,",
        ]
    lines += ["        *,", "        hard: bool = True,"]
    lines += [f"        {p.name}: {type_of(p)}{'' if p.required else ' = ...'}," for p in spec.params.values()]
    text = textwrap.wrap(spec.description, 108)
    doc = (
        [f'        """{text[0]}"""']
        if len(text) == 1
        else [f'        """{text[0]}', *(f"        {t}" for t in text[1:])]
    )
    return "\n".join(
        [*lines, "    ) -> ObjectHandle:", *doc, *([] if len(text) == 1 else ['        """']), "        ..."]
    )


def stub() -> str:
    """The text of the stub."""
    first, own = "        what: str | SceneObject,", "        name: str | None = None,"
    one = ADD.format(method="add", first=first, own=own, relations=keywords(), result="ObjectHandle")
    many = ADD.format(
        method="add_many",
        first="        count: int,\n        what: str,",
        own="",
        relations=keywords(),
        result="list[ObjectHandle]",
    ).replace("        *,\n\n", "        *,\n")
    methods = "\n".join(method(CATALOGUE[name]) for name in CATALOGUE if name in BUILT_IN)
    return HEAD + one + many + HANDLE + methods + "\n"


if __name__ == "__main__":
    STUB.write_text(stub(), "utf-8")
