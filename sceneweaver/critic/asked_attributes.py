"""What became of the words about what things are like: colour, material, style, shape, size, parts."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from typing import Any, NamedTuple

from sceneweaver.assets import categories
from sceneweaver.assets.category import Category
from sceneweaver.assets.materials import STYLES, color_named, palette
from sceneweaver.brief import Attribute, Entity
from sceneweaver.scene import InputError
from sceneweaver.verify.measure import Measurement
from sceneweaver.verify.solids import Body

from . import kinds
from .shape_measures import plan_shape
from .verdict import Asked, counted, met, not_understood, unmet

SIZE_SLACK = 0.15
"""Share by which a size may differ from what was asked."""

FAMILIES = {
    "wooden": "wood",
    "timber": "wood",
    "metallic": "metal",
    "steel": "metal",
    "iron": "metal",
    "cloth": "fabric",
    "upholstered": "fabric",
    "textile": "fabric",
}
"""Words for materials that mean a whole family of them."""

SIZES: dict[str, tuple[str, int]] = {
    **dict.fromkeys(("large", "big", "huge", "spacious", "oversized", "giant", "massive"), ("plan", 1)),
    **dict.fromkeys(("small", "little", "tiny", "compact", "mini", "miniature", "petite"), ("plan", -1)),
    **dict.fromkeys(("tall", "high", "floor-to-ceiling", "full-length"), ("height", 1)),
    **dict.fromkeys(("low", "short", "low-profile"), ("height", -1)),
    **dict.fromkeys(("wide", "broad"), ("width", 1)),
    **dict.fromkeys(("narrow", "slim", "slender", "thin"), ("short", -1)),
    **dict.fromkeys(("long", "elongated"), ("long", 1)),
    **dict.fromkeys(("deep",), ("depth", 1)),
    **dict.fromkeys(("shallow",), ("depth", -1)),
}
"""Words for sizes: which extent, and whether it is more (1) or less (-1) than the middle of what is usual."""

SEPARATE = ("color", "material", "style")
"""Fields of an entity that say what attributes say as well."""

Answer = tuple[bool, str]
"""Whether one object is so, and what it is."""


class _Test(NamedTuple):
    """How each object answers; None where nothing is known of it."""

    of: Callable[[Body], Answer | None]
    number: Callable[[Body], Measurement | None] = lambda body: None


def outcomes(asked: Entity, bodies: Sequence[Body]) -> Iterator[Asked]:
    """Each attribute of an entity; of a thing that is missing they are unmet."""
    for k, attribute in enumerate(_all(asked)):
        item = attribute.id or f"{asked.id}.{attribute.kind}" + (f"-{k}" if attribute.kind in ("other", "part") else "")
        yield _outcome(asked, attribute, item, bodies)
    if any(size is not None for size in asked.size) and bodies:
        yield _measured_size(asked, bodies)


def _all(asked: Entity) -> list[Attribute]:
    """The attributes, with those that only the fields of the entity say."""
    found = list(asked.attributes)
    said = {a.kind for a in found}
    for kind in SEPARATE:
        value = getattr(asked, kind)
        if value is not None and kind not in said:
            found.append(Attribute(kind=kind, value=value, words=value))
    if asked.scale != 1.0 and "size" not in said and asked.size == (None, None, None):
        found.append(Attribute(kind="size", value="large" if asked.scale > 1.0 else "small"))
    return found


def _outcome(asked: Entity, attribute: Attribute, item: str, bodies: Sequence[Body]) -> Asked:
    words = attribute.words or attribute.value
    if not bodies:
        reason = f"no '{asked.noun}' is there to be {words}"
        return unmet("attribute", item, (), reason, fault="missing_attribute")
    test = _test(attribute, asked)
    answers = [(b, answer) for b in bodies if test is not None and (answer := test.of(b)) is not None]
    ids = [b.id for b in bodies]
    if not answers or test is None:
        return not_understood("attribute", item, ids, f"'{words}': what is drawn here does not show it")
    good = [b for b, (holds, _) in answers if holds]
    wrong = [(b, is_) for b, (holds, is_) in answers if not holds]
    least, most = attribute.count or (len(answers), len(answers))
    if attribute.count is not None and least <= len(good) <= most or not wrong:
        number = test.number(good[0]) if good else None
        return met("attribute", item, [b.id for b in good or bodies], f"{(good or bodies)[0].id} is {words}", number)
    body, is_ = wrong[0] if wrong else (good[0], words)
    names = ", ".join(b.id for b, _ in wrong)
    number = test.number(body) or counted("objects that are so", len(good), least, most)
    tool, inputs = _resized(attribute, asked, body, number) if attribute.kind == "size" else (None, None)
    return unmet(
        "attribute",
        item,
        ids,
        f"{body.id} is {is_}, '{words}' was asked for",
        number,
        fault=f"wrong_{'asked_size' if attribute.kind == 'size' else attribute.kind}",
        wrong=[b.id for b, _ in wrong],
        share=len(wrong) / len(answers),
        suggestion=f"replace {names} by {words} {kinds.words(asked.category)}",
        tool=tool,
        inputs=inputs,
    )


def _test(attribute: Attribute, asked: Entity) -> _Test | None:
    """How to tell; None where nothing can."""
    value = attribute.value.lower()
    match attribute.kind:
        case "color" | "material" | "finish":
            key = "material" if attribute.kind == "finish" else attribute.kind
            return _Test(lambda b: _of_key(b, key, value))
        case "style":
            return _Test(lambda b: _of_key(b, "style", value)) if value in STYLES else None
        case "shape":
            return _Test(lambda b: _of_shape(b, value))
        case "size" if value in SIZES:
            return _Test(lambda b: _of_size(b, asked, value), lambda b: _extent(b, asked, value))
        case "part" | "size" | "other" | "state":
            return _Test(lambda b: _of_words(b, value))
    return None


def _of_key(body: Body, key: str, want: str) -> Answer | None:
    if key not in body.item.attributes:
        return None
    return alike(body, key, want), str(body.item.attributes[key])


def alike(body: Body, key: str, want: str) -> bool:
    """Whether an attribute says what was asked, in its own words or by the name of a shade or a family."""
    given = str(body.item.attributes.get(key, "")).lower()
    if key == "color":
        wanted, given = _color(want), _color(given)
        return wanted == given or wanted in given.split() or given in wanted.split()
    if want.lower() in given.split():
        return True
    wanted = FAMILIES.get(want.lower(), want.lower())
    if key == "material":
        finish = palette().get(str(body.item.attributes.get("material", "")))
        if finish is not None and wanted in (finish.family, FAMILIES.get(finish.family)):
            return True
    return wanted == given or wanted in given.split() or (" " in wanted and wanted in given)


def _color(words: str) -> str:
    """The basic colour of some words, the words themselves where they name none."""
    try:
        return color_named(words)
    except InputError:
        return " ".join(words.lower().split())


def _of_shape(body: Body, want: str) -> Answer | None:
    """Its own word for its shape, else its outline from above; of what hangs on a wall only its name tells."""
    want = want.replace("-", "_").replace(" ", "_").removesuffix("_shaped")
    given = body.item.attributes.get("shape")
    is_ = str(given) if given is not None else plan_shape(body)
    if want in ("rectangular", "oblong") and is_ == "square" and given is None:
        return True, is_
    return is_.removesuffix("_shaped") == want, is_


def _of_words(body: Body, want: str) -> Answer | None:
    """What the asset itself says of such a word: a count of a part by name, a word of its description."""
    number, _, noun = want.partition(" ")
    for name, value in body.item.attributes.items():
        if noun and number.isdigit() and name.rstrip("s") == noun.rstrip("s") and isinstance(value, int):
            return value == int(number), f"with {value} {name}"
    text = " ".join((body.item.category.replace("_", " "), body.item.description or "")).lower().split()
    return (True, want) if want and all(word in text for word in want.split()) else None


# ---- sizes -----------------------------------------------------------------------------------------------------------


def _extent(body: Body, asked: Entity, word: str) -> Measurement | None:
    """An extent of an object as a share of the middle of what is usual for its category."""
    row = categories().get(asked.category)
    if row is None or row.size is None:
        return None
    axis, sign = SIZES[word]
    ratio = _usual_share(body, row, axis)
    low, high = (1.0, math.inf) if sign > 0 else (-math.inf, 1.0)
    return Measurement(f"{'area' if axis == 'plan' else axis} by the usual one", ratio, low, high, "", 1e-6)


def _usual_share(body: Body, row: Category, axis: str) -> float:
    assert row.size is not None
    middles = [(low + high) / 2 for low, high in row.size.ranges]
    if axis == "plan":
        return body.size[0] * body.size[1] / (middles[0] * middles[1])
    if axis in ("long", "short"):
        choose = max if axis == "long" else min
        return choose(body.size[:2]) / choose(middles[:2])
    k = ("depth", "width", "height").index(axis)
    return body.size[k] / middles[k]


def _of_size(body: Body, asked: Entity, word: str) -> Answer | None:
    m = _extent(body, asked, word)
    return None if m is None else (m.ok(), f"{m.value:.2f} of the usual {m.quantity.split()[0]}")


def _resized(attribute: Attribute, asked: Entity, body: Body, number: Measurement) -> tuple[str | None, Any]:
    """Scale it so that the extent is as far beyond the usual as the request's scale says."""
    axis, sign = SIZES.get(attribute.value.lower(), ("", 0))
    if not axis or number.value <= 0.0:
        return None, None
    scale = asked.scale if asked.scale != 1.0 else 1.15 if sign > 0 else 0.87
    size = list(body.size)
    if axis == "plan":
        factor = math.sqrt(scale / number.value)
        size = [size[0] * factor, size[1] * factor, size[2]]
    else:
        longer = int(body.size[1] > body.size[0])
        k = {"depth": 0, "width": 1, "height": 2, "long": longer, "short": 1 - longer}[axis]
        size[k] *= scale / number.value
    return "update_size", {"sizes": {body.id: [round(s, 3) for s in size]}}


def _measured_size(asked: Entity, bodies: Sequence[Body]) -> Asked:
    """Lengths that were given in metres."""
    item, ids = f"{asked.id}.metres", [b.id for b in bodies]
    worst: tuple[float, Body, list[float], Measurement] | None = None
    for body in bodies:
        target = [s if want is None else want for s, want in zip(body.size, asked.size, strict=True)]
        k = max(range(3), key=lambda k: abs(body.size[k] - target[k]) / target[k])
        off = abs(body.size[k] - target[k]) / target[k]
        low, high = (target[k] * (1.0 + s * SIZE_SLACK) for s in (-1, 1))
        if worst is None or off > worst[0]:
            worst = (off, body, target, Measurement(("depth", "width", "height")[k], body.size[k], low, high, "m"))
    assert worst is not None
    off, body, target, number = worst
    said = f"{body.id} measures {_show(body.size)} m"
    if off <= SIZE_SLACK:
        return met("attribute", item, ids, f"{said}, as asked", number)
    return unmet(
        "attribute",
        item,
        ids,
        f"{said}, {_show(target)} m was asked for",
        number,
        fault="wrong_asked_size",
        wrong=[body.id],
        suggestion=f"resize {body.id}",
        tool="update_size",
        inputs={"sizes": {body.id: target}},
    )


def _show(size: Sequence[float]) -> str:
    return " x ".join(f"{s:.2f}" for s in size)
