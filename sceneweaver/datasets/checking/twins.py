"""Twins of a scene checked: each differs from it in what is stated alone, and its verdict is the one that is stated."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping

from sceneweaver.scene import InputError, Scene
from sceneweaver.verify import check

SCENE, DIFFERENCE = ".scene.json", ".difference.json"

_MEASURED = ("valid", "collisions", "out_of_bounds")


def twin_names(files: Mapping[str, bytes]) -> list[str]:
    """The names of the twins among the files of a scene, by suffix: twin-0, twin-1 ..."""
    return sorted({suffix.partition(".")[0] for suffix in files if suffix.startswith("twin-")})


def twin_faults(scene: Scene, files: Mapping[str, bytes]) -> Iterator[str]:
    """Lines about twins that are not what is stated of them."""
    for name in twin_names(files):
        try:
            twin = Scene.loads(files[name + SCENE])
            stated = json.loads(files[name + DIFFERENCE])
            changed, report = {stated["object"], *stated["carried"]}, check(twin, walkable=False)
            for key in _MEASURED:
                said, measured = stated["measured"][key][1], getattr(report, key)
                if said != measured:
                    yield f"{name}: {key} is {measured!r}; its difference says {said!r}"
        except (InputError, ValueError, TypeError, LookupError) as error:
            yield f"{name}: {type(error).__name__}: {error}"
            continue
        old, new = ({obj.id: obj for obj in one.objects} for one in (scene, twin))
        differ = {i for i in old.keys() | new.keys() if old.get(i) != new.get(i)}
        if differ - changed or twin.room != scene.room:
            more = ", ".join(sorted(differ - changed)) or "the room"
            yield f"{name}: {more} differs as well, which is not stated"
        if stated["object"] not in differ and twin.relations == scene.relations:
            yield f"{name}: nothing differs"
