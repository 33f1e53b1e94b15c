"""MJCF that somebody else wrote: its XML, what it includes, and the files that it names, all in its own folder."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

from sceneweaver.runtime.mujoco_module import load_mujoco

from .errors import InputError
from .messages import clean
from .reading import Place, open_regular, reason
from .references import required_inside
from .xml_text import load_xml

MAX_INCLUDED = 1_000
"""Files that a model includes, at any depth."""

MAX_ASSET = 2**30
"""Largest mesh, texture or height field [bytes]."""

_FOLDERS = {"mesh": "meshdir", "skin": "meshdir", "texture": "texturedir", "hfield": "meshdir"}


def load_mjcf(path: Place, folder: Path | None = None) -> ElementTree.Element:
    """The root element of a model, after all files that it names were found to lie in a folder.

    Args:
        path: the model.
        folder: where the files have to lie; that of the model unless given.

    Raises:
        InputError: as `load_xml`; a file that it includes or names lies elsewhere, or is a pipe or a device.
    """
    place = Path(path)
    folder = place.parent if folder is None else folder
    root = load_xml(place)
    name = clean(place.name)
    base = {key: "" for key in ("meshdir", "texturedir")}
    todo, seen = [root], 0
    while todo:
        model = todo.pop()
        for compiler in model.iter("compiler"):
            for key in base:
                base[key] = compiler.get(key) or compiler.get("assetdir") or base[key]
        for included in model.iter("include"):
            seen += 1
            if seen > MAX_INCLUDED:
                raise InputError(f"{name}: includes more than {MAX_INCLUDED} files, or itself")
            todo.append(load_xml(required_inside(folder, place.parent / included.get("file", ""), name)))
        for kind, key in _FOLDERS.items():
            for asset in model.iter(kind):
                for attribute, value in asset.items():
                    if attribute.startswith("file"):
                        found = required_inside(folder, place.parent / base[key] / value, name)
                        if os.path.exists(found):  # also of a name that is too long
                            open_regular(found, MAX_ASSET).close()
    return root


def read_spec(path: Place) -> Any:
    """A ``mujoco.MjSpec`` of a model.

    Raises:
        InputError: as `load_mjcf`, and when MuJoCo refuses it.
    """
    mujoco = load_mujoco()
    load_mjcf(path)
    try:
        return mujoco.MjSpec.from_file(os.fspath(path))
    except (ValueError, TypeError, RuntimeError) as error:
        raise InputError(f"{clean(Path(path).name)}: MuJoCo refuses it ({reason(error)})") from None
