"""Whatever is done to a scene file, loading gives a scene or an InputError of one line, nothing else."""

from __future__ import annotations

import copy
import json
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given
from hypothesis import strategies as st

from sceneweaver.scene import InputError, Scene
from tests.sizes import examples

BEDROOM = (Path(__file__).parents[1] / "zoo" / "bedroom-small.json").read_bytes()
DATA = json.loads(BEDROOM)
FAST = examples(50, 150, suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large])

JUNK = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(-3, 3),
    st.integers(),
    st.floats(),
    st.text(max_size=8),
    st.sampled_from(
        ["wall:0", "bed-0", "door-0", "window-0", "surface", "near", "tucked", "\ud800", "a\nb", "sceneweaver.scene/0"]
    ),
    st.lists(st.floats() | st.integers(-2, 2), max_size=5),
    st.lists(st.lists(st.floats(-2, 2), min_size=2, max_size=2), max_size=6),
    st.dictionaries(
        st.text(max_size=4) | st.sampled_from(["id", "object", "surface", "polygon", "z"]), st.integers(), max_size=3
    ),
)


def loads_or_one_line(load):
    try:
        scene = load()
    except InputError as error:
        text = str(error)
        assert text and text.isprintable() and len(text) < 600, text
    else:
        assert Scene.loads(scene.dumps()) == scene


def paths(data, at=()):
    yield at
    items = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ()
    for key, value in items:
        yield from paths(value, (*at, key))


PATHS = [p for p in paths(DATA) if p]
SHALLOW = [p for p in PATHS if len(p) <= 4]


@FAST
@given(st.integers(0, len(BEDROOM) - 1))
def test_truncation(length):
    with pytest.raises(InputError):
        Scene.loads(BEDROOM[:length])


@FAST
@given(st.lists(st.tuples(st.integers(0, len(BEDROOM) - 1), st.binary(max_size=3)), min_size=1, max_size=4))
def test_bytes_changed(changes):
    text = bytearray(BEDROOM)
    for at, new in changes:
        text[at : at + max(1, len(new) - 1)] = new
    loads_or_one_line(lambda: Scene.loads(bytes(text)))


@FAST
@given(st.data())
def test_values_changed(draw):
    data = copy.deepcopy(DATA)
    for _ in range(draw.draw(st.integers(1, 3))):
        path = draw.draw(st.sampled_from(SHALLOW) | st.sampled_from(PATHS))
        at = data
        try:
            for key in path[:-1]:
                at = at[key]
            kind = draw.draw(st.sampled_from(["set", "set", "delete", "rename", "repeat"]))
            if kind == "set":
                at[path[-1]] = draw.draw(JUNK)
            elif kind == "delete":
                del at[path[-1]]
            elif kind == "repeat" and isinstance(at, list):
                at.append(copy.deepcopy(at[path[-1]]))
            elif isinstance(at, dict):
                at[draw.draw(st.text(max_size=5))] = at.pop(path[-1])
        except (KeyError, IndexError, TypeError):
            continue  # an earlier change took the place away
    loads_or_one_line(lambda: Scene.from_json(data))
    loads_or_one_line(lambda: Scene.loads(json.dumps(data)))


@FAST
@given(
    st.recursive(
        JUNK, lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=5), inner, max_size=3)
    )
)
def test_any_json(data):
    with pytest.raises(InputError):
        Scene.from_json(data)
    with pytest.raises(InputError):
        Scene.loads(json.dumps(data))
    with pytest.raises(InputError):
        Scene.from_json({"schema": "sceneweaver.scene/0", "id": "x", "objects": data})
