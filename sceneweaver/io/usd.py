"""USD that somebody else wrote: its layers are regular files in its own folder."""

# pxr has no stubs:
# pyright: reportAttributeAccessIssue=false

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from .errors import InputError
from .messages import clean
from .reading import Place, open_regular
from .references import required_inside

MAX_BYTES = 2**30
"""Largest layer [bytes]."""

MAX_LAYERS = 10_000


def open_stage(path: Place) -> Any:
    """A ``pxr.Usd.Stage`` of a file; a layer that is missing is left to USD, which goes on without it.

    Raises:
        InputError: as `open_regular`, also for the layers that it refers to by references, payloads or sublayers; a
            layer that lies outside of its folder; damaged.
    """
    from pxr import Tf, Usd

    place = Path(path)
    name = clean(place.name)
    try:
        _check_layers(place, name)
        return Usd.Stage.Open(str(place))
    except Tf.ErrorException as error:
        raise InputError(f"{name}: the file is damaged or cut off ({clean(str(error).strip())[:120]})") from None


def _check_layers(path: Path, name: str) -> None:
    from pxr import Sdf

    todo, seen = [str(path)], set()
    while todo:
        place = todo.pop()
        if place in seen or not os.path.exists(place):
            continue
        seen.add(place)
        if len(seen) > MAX_LAYERS:
            raise InputError(f"{name}: more than {MAX_LAYERS} layers")
        open_regular(place, MAX_BYTES).close()
        layer = Sdf.Layer.FindOrOpen(place)
        if layer is not None:
            for asset in layer.GetCompositionAssetDependencies():
                found = layer.ComputeAbsolutePath(asset)
                if os.path.exists(found):
                    todo.append(str(required_inside(path.parent, Path(found), name)))
