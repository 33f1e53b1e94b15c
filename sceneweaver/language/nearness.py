"""What stands near enough to be meant where a word of place has no target."""

from __future__ import annotations

from itertools import takewhile

from sceneweaver.assets.taxonomy import likeliness

from .parsed import Mention
from .state import State
from .vocabulary import Place, words

_TIES = ("next_to", "near", "facing", "at", "in_front_of", "behind", "on", "inside", "around", "flanking")
"""Relations to what a thing belongs to."""

SIDED = ("left_of", "right_of", "in_front_of", "behind")
"""Relations to one side of a thing."""


def _flat(thing: Mention) -> bool:
    """Whether things stand on it that stand on the floor."""
    return thing.is_rug or thing.category.endswith("mat")


def beside_those(state: State, subjects: list[Mention]) -> list[Mention]:
    """ "A shelf next to a desk against the wall": what stands beside something at a wall stands there as well."""
    last = state.out.said[-1] if state.out.said else None
    if last is None or last.type not in ("next_to", "flanking", "side_by_side") or last.implied:
        return []
    pair = [*last.subjects, *(t for t in last.targets if isinstance(t, Mention))]
    if not all(s in pair for s in subjects):
        return []
    return [m for m in pair if m not in subjects and m.mount == "floor"]


def _apart(state: State, found: list[Mention], subjects: list[Mention]) -> bool:
    """Whether things on the floor would be beside what hangs from the ceiling or on a wall."""
    return all(s.mount == "floor" for s in subjects) and all(
        m.mount in ("ceiling", "wall", "surface") and not m.is_rug for m in found
    )


def main_things(state: State, without: list[Mention]) -> list[Mention]:
    """The first thing on the floor that the request names: what "across the room" is across from."""
    found = [m for m in state.out.mentions[:12] if m.mount == "floor" and m not in without]
    return found[:1] or nearest(state, without)


def carrier_root(state: State, thing: Mention) -> Mention:
    """What carries a thing in the end: the table that the tray stands on."""
    for said in reversed(state.out.said):
        target = said.targets[0]
        if not isinstance(target, Mention) or target is thing or thing not in said.subjects:
            continue
        beside = said.type in ("next_to", "below", "near") and (_flat(thing) or thing.mount == "surface")
        if beside or said.type in ("on", "inside"):
            thing = target
    return thing


def anchor(state: State, thing: Mention, kind: str, subjects: list[Mention]) -> Mention:
    """What something belongs to: nearby a chair that faces a desk is nearby the desk."""
    if kind in ("left_of", "right_of") and not (thing.family == "seat" and subjects[0].mount == "floor"):
        return thing
    for said in reversed(state.out.said):
        target = said.targets[0]
        if not isinstance(target, Mention) or said.type not in _TIES or target in subjects:
            continue
        if target.mount == "floor" and not target.is_rug and thing in said.subjects:
            return target
    return thing


def nearest(state: State, without: list[Mention], apart: bool = False) -> list[Mention]:
    """The thing that a word without a target is said of: whose "with" it is, the subject, what was named before."""
    frame = state.frames[-1] if state.frames else None
    choices = [f.owner for f in reversed(state.frames) if f.kind in ("with", "verb")]
    choices += [state.subject, state.previous]
    choices += [[m] for m in reversed(state.first_items[:-1])]
    choices += reversed(state.refs.topics[-2:])
    if frame is not None and frame.fronted:
        choices.insert(0, frame.fronted_on)
    for group in choices:
        found = [m for m in group if m not in without]
        if found and not (apart and _apart(state, found, without)):
            return found
    if apart:
        return nearest(state, without)
    return [m for m in reversed(state.out.mentions[-6:]) if m not in without][:1]


def carrying(state: State, near: list[Mention], subjects: list[Mention]) -> list[Mention]:
    """ "A chair in front of it and a lamp on it": of what is near, or was meant by "it" before, what rather carries
    such things."""
    meant = [t for said in state.out.said[-3:] for t in said.targets if isinstance(t, Mention)]
    choices = [*near[-1:], *(m for m in reversed(meant) if m not in near and m not in subjects)]
    if not subjects or len(choices) < 2 or not all(s.is_small for s in subjects):
        return near
    ranks = [likeliness(subjects[0].category, m.category) for m in choices]
    if ranks[0] is not None or all(rank is None for rank in ranks):
        return near
    _, best = min((rank, k) for k, rank in enumerate(ranks) if rank is not None)
    return [choices[best]]


def chained(state: State, near: list[Mention], subjects: list[Mention]) -> list[Mention]:
    """Whose "its" is in a list: "a laptop at its center, a lamp to its left and a clock to its right" are about the
    laptop."""
    if not near or not all(s.mount == "surface" for s in subjects):
        return near
    for said in reversed(state.out.said[-4:]):
        target = said.targets[0]
        if said.implied or not isinstance(target, Mention) or target in subjects:
            continue
        if said.type == "centered_on" and target is near[-1]:
            return said.subjects[-1:]
        if said.type in SIDED and near[-1] in said.subjects:
            return [target]
        if said.type != "on":
            break
    return near


def meant_of_list(state: State, place: Place, listed: list[Mention]) -> list[Mention]:
    """Who of a list a relation after it is about: the last, or all that belong together."""
    kind = place.type
    related = {m for s in state.out.said for m in s.subjects}
    if kind == "between":
        return listed[-1:]
    if kind in ("on", "inside"):
        on_top = words("nouns")["hung"]["surface"]  # a clock among small things is one that stands
        small = [*takewhile(lambda m: not m.implied and (m.is_small or m.category in on_top), reversed(listed))][::-1]
        told = {m for s in state.out.said if not s.implied for m in s.subjects}
        return [m for m in small if m not in told or m is listed[-1]] or listed[-1:]
    if state.manner == "hang" and len(listed) == 2 and listed[0] not in related:
        return listed  # "a spade and a rake hanging on the wall"
    if kind in ("flanking", "along", "around") and len(listed) == 2 and listed[0].mount == listed[1].mount:
        told = {m for s in state.out.said if not s.implied for m in s.subjects}
        return listed if listed[0] not in told else listed[1:]
    pair = all(m.mount == "surface" for m in listed[-2:])
    if kind in SIDED and len(listed) > 1 and pair and related.isdisjoint(listed[-2:]):
        return listed[-2:]  # "a keyboard and a mouse in front"
    paired = len(listed) == 2 and listed[0] not in related
    if paired and {m.family for m in listed} in ({"seat", "table"}, {"seat"}):
        return listed  # "two armchairs and a side table by the window"
    return listed[-1:]
