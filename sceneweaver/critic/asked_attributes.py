"""What became of the words about what things are like: colour, material, style, shape, size, parts."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

from sceneweaver.assets import categories
from sceneweaver.assets.category import Category
from sceneweaver.assets.looks import Words, read_words
from sceneweaver.assets.materials import STYLES, color_named, color_words, finishes_named
from sceneweaver.assets.roles import has_role
from sceneweaver.language import Attribute, Entity
from sceneweaver.language.told_states import (
    colors_as_told,
    detail_as_told,
    posture_as_told,
    pulled_as_told,
    state_as_told,
)
from sceneweaver.language.vocabulary import words
from sceneweaver.rules.faults import fault_kind
from sceneweaver.scene import InputError, Window
from sceneweaver.verify.measure import Measurement
from sceneweaver.verify.solids import Body

from . import kinds
from .asked_roles import AS, serves_as
from .asked_states import measured_state
from .grade import Call
from .shape_measures import plan_shape
from .verdict import Asked, counted, met, not_understood, partly, unmet

_BE = re.compile(r"^(?:(?:is|are|was|were|has been|have been)\s)+")
"""How words about a state may begin."""

SIZES = fault_kind("wrong_asked_size").limits
"""Shares and factors of sizes that are as asked."""

EXTENTS = {"plan": "area", "long": "length", "short": "breadth"}
"""Names of extents that are none of the three of a size."""

SEPARATE = ("color", "material", "style")
"""Fields of an entity that say what attributes say as well."""

Answer = tuple[bool, str]
"""Whether one object is so, and what it is."""


class _Test(NamedTuple):
    """How each object answers; None where nothing is known of it."""

    of: Callable[[Body], Answer | None]
    number: Callable[[Body], Measurement | None] = lambda body: None


def outcomes(
    asked: Entity, bodies: Sequence[Body], lengths: int = 0, windows: Sequence[Window] = ()
) -> Iterator[Asked]:
    """Each attribute of an entity; of a thing that is missing they are unmet; ``lengths`` are told elsewhere."""
    for k, attribute in enumerate(_all(asked)):
        if pulled_as_told(attribute) is not None:
            continue  # of seats and tables together, see `asked_states`
        item = attribute.id or f"{asked.id}.{attribute.kind}" + (f"-{k}" if attribute.kind in ("other", "part") else "")
        yield _outcome(asked, attribute, item, bodies, windows)
    if sum(size is not None for size in asked.size) > lengths and bodies and not asked.sized_for_people:
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


def _outcome(
    asked: Entity, attribute: Attribute, item: str, bodies: Sequence[Body], windows: Sequence[Window]
) -> Asked:
    words = attribute.words or attribute.value
    if not bodies:
        reason = f"no '{asked.noun}' is there to be {words}"
        return unmet("attribute", item, (), reason, fault="missing_attribute")
    if colors := colors_as_told(attribute):
        return _varied(attribute, item, bodies, colors)
    test = _test(attribute, asked, windows)
    answers = [(b, answer) for b in bodies if test is not None and (answer := test.of(b)) is not None]
    ids = [b.id for b in bodies]
    if not answers or test is None:
        return not_understood("attribute", item, ids, f"'{words}': what is drawn here does not show it")
    bare = len(windows) - len(bodies) if asked.count is None and _dresses_windows(asked, attribute) else 0
    if bare > 0:
        reason = f"{bare} of {len(windows)} windows have no '{asked.noun}' to be {words}"
        return unmet("attribute", item, ids, reason, fault="wrong_state", share=bare / len(windows))
    good = [b for b, (holds, _) in answers if holds]
    wrong = [(b, is_) for b, (holds, is_) in answers if not holds]
    least, most = attribute.count or (len(answers), len(answers))
    if attribute.count is not None and least <= len(good) <= most or not wrong:
        number = test.number(good[0]) if good else None
        return met(
            "attribute",
            item,
            [b.id for b in good or bodies],
            f"{(good or bodies)[0].id} is {_BE.sub('', words)}",
            number,
        )
    body, is_ = wrong[0] if wrong else (good[0], words)
    names = ", ".join(b.id for b, _ in wrong)
    number = test.number(body) or counted("objects that are so", len(good), least, most)
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
        call=_resized(attribute, asked, body, number) if attribute.kind == "size" else None,
    )


def _varied(attribute: Attribute, item: str, bodies: Sequence[Body], colors: Sequence[str]) -> Asked:
    """Whether things have the colours between them that are listed, or so many of them as there are things."""
    wanted = {_color(color) for color in colors}
    there = {_color(str(b.item.attributes.get("color"))) for b in bodies}
    good, least = len(there & wanted), min(len(wanted), len(bodies))
    ids, number = [b.id for b in bodies], counted("different colours", good, least, len(wanted))
    words = attribute.words or attribute.value
    if good >= least and _IN_ORDER.search(words):
        reason = f"'{words}': {', '.join(sorted(there))}; their order is not measured"
        return partly("attribute", item, ids, reason, number)
    if good >= least:
        return met("attribute", item, ids, f"'{words}': {', '.join(sorted(there))}", number)
    return unmet("attribute", item, ids, f"'{words}': only {', '.join(sorted(there))}", number, fault="wrong_color")


_IN_ORDER = re.compile(r"sorted|arranged|ordered|graded|organi[sz]ed|(?:a|in) rainbow")
"""Words after which things of several colours are in an order as well."""


def _test(attribute: Attribute, asked: Entity, windows: Sequence[Window]) -> _Test | None:
    """How to tell; None where nothing can."""
    if attribute.kind in ("state", "other") and state_as_told(asked.category, attribute) is not None:
        return _Test(lambda b: _of_state(b, attribute, windows), lambda b: _in_state(b, attribute, windows))
    words = read_words(attribute.value)
    match attribute.kind:
        case "part" if (detail := detail_as_told(attribute)) is not None:
            return _Test(lambda b: _of_detail(b, *detail))
        case "color":
            return _Test(lambda b: _of_color(b, attribute.value))
        case "material" | "finish":
            return _Test(lambda b: _of_material(b, attribute.value))
        case "style" if words.style in STYLES:
            return _Test(lambda b: _of_style(b, words.style or ""))
        case "shape" if words.shape:
            return _Test(lambda b: _of_shape(b, words.shape or ""))
        case "size" if words.extents:
            return _Test(lambda b: _of_size(b, asked, words), lambda b: _extent(b, asked, words))
        case "other" if attribute.value.startswith(AS):
            return _Test(lambda b: serves_as(b, attribute.value.removeprefix(AS)))
        case _ if words.parts:
            return _Test(lambda b: _of_parts(b, dict(words.parts)))
        case "part" | "size" | "other" | "state" | "shape":
            return _Test(lambda b: _of_name(b, attribute.value))
    return None


def _dresses_windows(asked: Entity, attribute: Attribute) -> bool:
    """Whether a state is said of what is before the windows: of all of it, then."""
    return attribute.kind == "state" and has_role(asked.category, "curtain", "blind")


def _in_state(body: Body, attribute: Attribute, windows: Sequence[Window]) -> Measurement | None:
    state = state_as_told(body.item.category, attribute)
    return measured_state(body, state, posture_as_told(state, attribute), windows) if state is not None else None


def _of_state(body: Body, attribute: Attribute, windows: Sequence[Window]) -> Answer | None:
    m = _in_state(body, attribute, windows)
    return None if m is None else (m.ok(), f"as usual ({m.quantity} {m.value:.2f})")


def _of_color(body: Body, want: str) -> Answer | None:
    given = body.item.attributes.get("color")
    if given is None:
        return None
    wanted, is_ = _color(want), _color(str(given))
    return wanted == is_ or wanted in is_.split() or is_ in wanted.split(), str(given)


def _of_detail(body: Body, part: str, want: str) -> Answer | None:
    """Whether a part is in a colour and of a material, as far as the words name them."""
    given = body.item.attributes.get(f"{part} finish")
    if given is None:
        return None
    is_, words = str(given), read_words(want)
    named = {_undyed(f.material.name) for f in finishes_named(words.material or want)}
    if not named and words.color is None:
        return None
    holds = not named or _undyed(is_) in named
    if words.color is not None:
        holds = holds and (words.color in is_ or _color(words.color) in (is_.split()[0], _color(is_.split()[0])))
    return holds, f"of {is_}"


def _color(words: str) -> str:
    """The basic colour of some words, the words themselves where they name none."""
    try:
        return color_named(words)
    except InputError:
        return " ".join(words.lower().split())


def _of_material(body: Body, want: str) -> Answer | None:
    """By the words themselves, or by the finishes that they name: a dyed velvet is a velvet, oak is wood."""
    given = body.item.attributes.get("material")
    if given is None:
        return None
    is_, wanted = str(given).lower(), want.lower()
    named = {_undyed(f.material.name) for f in finishes_named(wanted)}
    families = {f.family for f in finishes_named(is_)}
    plain = wanted == is_ or wanted in is_.split() or (" " in wanted and wanted in is_)
    alike = plain or _undyed(is_) in named or wanted in families
    return alike and _dyed_as(body, wanted) and (_see_through(is_) or not _see_through(wanted)), str(given)


def _dyed_as(body: Body, wanted: str) -> bool:
    """Whether it has the colour that words about a material begin with, where they do: "black leather" is no tan."""
    first, _, rest = wanted.partition(" ")
    color = _of_color(body, first) if rest and _color(first) in color_words() else None
    return color is None or color[0]


def _see_through(words: str) -> bool:
    """Whether words are the name of a material that one sees through."""
    return any(f.material.name == words and f.material.opacity < 1.0 for f in finishes_named(words))


def _undyed(finish: str) -> str:
    return finish.rpartition(" ")[2]


def _of_style(body: Body, want: str) -> Answer | None:
    given = body.item.attributes.get("style")
    return None if given is None else (given == want, str(given))


def _of_shape(body: Body, want: str) -> Answer | None:
    """Its own word for its shape as far as its outline from above bears it out, else that outline."""
    given, seen = body.item.attributes.get("shape"), plan_shape(body)
    angular = seen in ("rectangular", "square") and body.item.mount != "wall"
    is_ = seen if given is None or (angular and str(given) not in ("rectangular", "square")) else str(given)
    return is_ == want or (want == "rectangular" and is_ == "square" and given is None), is_


def _of_parts(body: Body, want: dict[str, int]) -> Answer | None:
    """Counts of its drawers, seats ... where the asset says them."""
    given = {name: body.item.attributes.get(name) for name in want}
    if None in given.values():
        return None
    return given == want, "with " + " and ".join(f"{value} {name}" for name, value in given.items())


def _of_name(body: Body, want: str) -> Answer | None:
    """Whether its category, a name of that, or its description has the words; nothing is known where they have not.

    What is called bent has to have such an outline.
    """
    if want.lower() in words("bearing_words")["bent"].split() and body.item.mount == "floor":
        seen = plan_shape(body)
        return seen not in ("rectangular", "square"), seen
    row = categories().get(body.item.category)
    names = (body.item.category, body.item.description or "", *(row.synonyms if row is not None else ()))
    text = {word for name in names for word in name.lower().replace("_", " ").replace("-", " ").split()}
    wanted = {word for word in want.lower().replace("-", " ").split() if word not in ("size", "sized")}
    return (True, want) if wanted and wanted <= text else None


# ---- sizes -----------------------------------------------------------------------------------------------------------


def _extent(body: Body, asked: Entity, words: Words) -> Measurement | None:
    """An extent of an object as a share of the middle of what is usual for its category."""
    row = categories().get(asked.category)
    if row is None or row.size is None:
        return None
    axis, share = _axis(words)
    sides = sorted(body.size[:2])
    if axis == "long" and sides[1] < SIZES["oblong"] * sides[0]:  # however large it is
        return Measurement("length by its breadth", sides[1] / sides[0], SIZES["oblong"], math.inf, "", 1e-6)
    low, high = (
        (1.0, math.inf) if share > 0.5 else (0.0, 1.0) if share < 0.5 else (1.0 / SIZES["medium"], SIZES["medium"])
    )
    return Measurement(
        f"{EXTENTS.get(axis, axis)} by the usual one", _usual_share(body, row, axis), low, high, "", 1e-6
    )


def _axis(words: Words) -> tuple[str, float]:
    """The extent that words are about, and where in its usual range they put it; both sides together are the area."""
    extents = dict(words.extents)
    return ("plan", extents["depth"]) if {"depth", "width"} <= set(extents) else words.extents[0]


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


def _of_size(body: Body, asked: Entity, words: Words) -> Answer | None:
    m = _extent(body, asked, words)
    if m is None:
        return None
    if m.low == SIZES["oblong"]:
        return m.ok(), f"{m.value:.2f} times as long as it is broad"
    return m.ok(), f"{m.value:.2f} of the usual {m.quantity.split()[0]}"


def _resized(attribute: Attribute, asked: Entity, body: Body, number: Measurement) -> Call | None:
    """Scale it so that the extent is as far beyond the usual as the request's scale says."""
    words = read_words(attribute.value)
    if not words.extents or number.value <= 0.0:
        return None
    axis, share = _axis(words)
    if number.low == SIZES["oblong"]:
        scale = SIZES["longer"] * SIZES["oblong"]
    else:
        scale = (
            asked.scale
            if asked.scale != 1.0
            else SIZES["larger"]
            if share > 0.5
            else SIZES["smaller"]
            if share < 0.5
            else 1.0
        )
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
        low, high = (target[k] * (1.0 + s * SIZES["metres"]) for s in (-1, 1))
        if worst is None or off > worst[0]:
            worst = (off, body, target, Measurement(("depth", "width", "height")[k], body.size[k], low, high, "m"))
    assert worst is not None
    off, body, target, number = worst
    said = f"{body.id} measures {_show(body.size)} m"
    if off <= SIZES["metres"]:
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
        call=("update_size", {"sizes": {body.id: target}}),
    )


def _show(size: Sequence[float]) -> str:
    return " x ".join(f"{s:.2f}" for s in size)
