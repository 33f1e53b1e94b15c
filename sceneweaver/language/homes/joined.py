"""What a request says of rooms to each other: doors, open passages, near, apart, between, each with its own."""

from __future__ import annotations

from typing import Any

from sceneweaver.plans.programme import AdjacencyKind

from .lexicon import data
from .owners import is_own
from .parts import Joint, Named, Reading
from .pronouns import PER_EACH, read_pronouns
from .relations import deny, is_denied, no_room

_GAP = (
    "the",
    "a",
    "an",
    "our",
    "my",
    "their",
    "his",
    "her",
    "its",
    "of",
    "to",
    "as",
    "it",
    "is",
    "on",
    "only",
    "both",
    "very",
    "right",
    "that",
)


def read_joints(reading: Reading) -> None:
    """Reads what rooms are to each other; see above."""
    read_pronouns(reading)
    for sentence in reading.sentences():
        at_names = {k: one for k, one in reading.named_at().items() if k in sentence}
        for k in sentence:
            token = reading.tokens[k]
            if token.text == "/":
                _slash(reading, at_names, k)
            elif token.has("shared_by") and not token.done:
                _shared(reading, at_names, sentence, k)
            elif token.has("joint") and not token.done and k not in at_names:
                _joint(reading, at_names, sentence, k, token.get("joint"))
            elif token.text == "with" and not token.done:
                _with(reading, at_names, sentence, k)
        _en_suites(reading, at_names, sentence)


def _slash(reading: Reading, names: dict[int, Named], at: int) -> None:
    left, right = _before(names, at), _after(names, at)
    if left is not None and right is not None and left.last == at - 1 and right.first == at + 1:
        reading.joints.append(Joint(left, right, "open", reading.tokens[at].span))
        reading.did(at, "joint")


def _joint(reading: Reading, names: dict[int, Named], sentence: range, at: int, kind: Any) -> None:
    """A word for what rooms are to each other, with the rooms on both of its sides."""
    token = reading.tokens[at]
    left = _before(names, at)
    if kind == "together":
        _together(reading, names, at)
        return
    if left is None or _something_between(reading, left, at):
        return
    how = ""
    if kind in ("across", "across_each", "not_through"):
        how, kind = (
            ("not through" if kind == "not_through" else "opposite"),
            ("opposite_ends" if kind == "across_each" else "near"),
        )
    start = max(left.last + 1, *(k + 1 for k in range(left.last, at) if reading.tokens[k].breaks), 0)
    if kind in ("near", "door", "open") and not how and is_denied(reading.tokens, start, at):
        deny(reading, start, at)
        kind = "apart"
    if kind == "near" and not how and no_room(reading, left):
        kind = "apart"
    if kind == "opposite_ends":
        _opposite(reading, names, at, left, how)
        return
    if kind == "with_own":
        _with(reading, names, sentence, at)
        return
    if kind == "between":
        _between(reading, names, sentence, at, left)
        return
    end = _behind(reading, names, sentence, at)
    if isinstance(end, Named):
        _put(reading, left, end, kind, at, how)
        if kind == "apart" and (more := _and_more(reading, names, end)) is not None:
            _put(reading, left, more, kind, at)
        elif kind == "apart" and (place := _and_place(reading, end, sentence)):
            reading.joints.append(Joint(left, place, kind, token.span))
    elif isinstance(end, str) and end:
        for one in _subjects(reading, names, left, at):
            reading.joints.append(Joint(one, end, kind, token.span))
        reading.did(at, "joint")
    elif end == "" and left.of is None:
        _to_pronoun(reading, names, at, left, kind, how)


def _something_between(reading: Reading, left: Named, at: int) -> bool:
    """Whether something else stands between rooms and a word of place, which is said of that: "a garage, garden access
    from the living room"; or a side of the compass: "west facing"."""
    gap = reading.tokens[left.last + 1 : at]
    if gap and gap[-1].text in ("north", "south", "east", "west"):
        return True
    breaks = [k for k, token in enumerate(gap) if token.breaks]
    return bool(breaks) and any(not t.kinds or t.has("place") for t in gap[breaks[-1] + 1 :])


def _together(reading: Reading, names: dict[int, Named], at: int) -> None:
    """ "Open-plan kitchen and living room", or "kitchen, dining and living room in one": open to each other."""
    tokens = reading.tokens
    after = _after(names, at)
    if tokens[at].text == "in one" and after is not None and after.first == at + 1:
        return  # "in one open room"
    chain: list[Named] = []
    if after is not None and after.first - at <= 2 and not any(t.breaks for t in tokens[at + 1 : after.first]):
        chain = [after, *_list_from(names, after)[:1]]
    left = _before(names, at)
    if len(chain) < 2 and left is not None and not any(t.breaks for t in tokens[left.last + 1 : at]):
        chain = [*_list_to(names, left), left]
    for one, two in zip(chain, chain[1:], strict=False):
        reading.joints.append(Joint(one, two, "open", tokens[at].span))
        reading.did(at, "joint")


def _opposite(reading: Reading, names: dict[int, Named], at: int, left: Named, how: str) -> None:
    """ "Two bedrooms at opposite ends", "study and bathroom share no wall": apart; or across from each other."""
    others = _list_to(names, left)
    other = others[-1] if others and left.count == 1 else left
    reading.joints.append(Joint(other, left, "near" if how else "apart", reading.tokens[at].span, how=how))
    reading.did(at, "joint")


def _list_to(names: dict[int, Named], last: Named) -> list[Named]:
    """The rooms of the list that ends with one."""
    found = [last]
    for one in sorted(names.values(), key=lambda n: -n.at):
        if one.at < found[-1].at and one.of is None and found[-1].first - one.last <= 2:
            found.append(one)
    return found[:0:-1]


def _list_from(names: dict[int, Named], first: Named) -> list[Named]:
    """The rooms of the list that begins with one, without it."""
    found = [first]
    for one in sorted(names.values(), key=lambda n: n.at):
        if one.at > found[-1].at and one.of is None and one.first - found[-1].last <= 2:
            found.append(one)
    return found[1:]


def _between(reading: Reading, names: dict[int, Named], sentence: range, at: int, left: Named) -> None:
    token = reading.tokens[at]
    end = _behind(reading, names, sentence, at)
    if isinstance(end, Named):
        reading.joints.append(Joint(left, end, "near", token.span, each=True))
        if (more := _and_more(reading, names, end)) is not None:
            reading.joints.append(Joint(left, more, "near", token.span))
        reading.did(at, "joint")
    elif end == "":
        before = [one for one in reading.named if one.at < left.first and one.of is None and (one.count or 2) > 1]
        if before and any(j.b is left or j.a is left for j in reading.joints if isinstance(j.b, Named)):
            reading.did(at, "joint")  # "that share a bathroom between them"
            _done_pronoun(reading, at)
        elif before:
            reading.joints.append(Joint(left, before[-1], "near", token.span, each=True))
            reading.did(at, "joint")
            _done_pronoun(reading, at)


def _to_pronoun(
    reading: Reading, names: dict[int, Named], at: int, left: Named, kind: AdjacencyKind, how: str = ""
) -> None:
    """ "A bathroom off each of them", "with a kitchen behind it"."""
    tokens = reading.tokens
    before = [one for one in reading.named if one.at < left.first and one.of is None and one.root is not left]
    if not before:
        return
    near = [one for one in before if one.at >= left.first - 14] or before[-1:]
    pronoun = next((tokens[k] for k in range(at + 1, min(at + 4, len(tokens))) if tokens[k].has("them", "each")), None)
    each = pronoun is not None and (pronoun.has("each") or pronoun.text in ("them", "these"))
    to_each = {"door", "doors", "reached", "accessible", "entered"} & {*tokens[at].text.split()}
    target = next((one for one in reversed(near) if not each or one.count is None or one.count > 1), near[-1])
    if each and left.told != "number" and (target.count or 2) > 1 and pronoun is not None and pronoun.has("each"):
        left.per = None if to_each else target  # one room with a door to each, or one off each
    reading.joints.append(Joint(left, target, kind, tokens[at].span, each=left.per is not None or each, how=how))
    reading.did(at, "joint")
    _done_pronoun(reading, at)


def _done_pronoun(reading: Reading, at: int) -> None:
    for k in range(at + 1, min(at + 4, len(reading.tokens))):
        if reading.tokens[k].has("them", "each", "of_them"):
            reading.did(k, "joint")


def _with(reading: Reading, names: dict[int, Named], sentence: range, at: int) -> None:
    """ "A bedroom with its own bathroom", "eight studios, each with a shower room"."""
    tokens = reading.tokens
    left, right = _before(names, at), _after(names, at)
    if left is None or right is None or right.of is not None or not _close(reading, at, right):
        return
    gap = [tokens[k] for k in range(left.last + 1, at)]
    if any(t.breaks or t.has("use", "person") for t in gap) or any(k == reading.use_at for k in range(left.at, at)):
        return
    rights = [right]
    while (more := _and_more(reading, names, rights[-1])) is not None and len(rights) < 4:
        rights.append(more)
    whole = left.root
    for one in rights:
        if one.kind.type not in data("words")["annexes"] or one.kind.name == whole.kind.name:
            continue
        follows = tokens[one.last + 1] if one.last + 1 < len(tokens) else None
        pointed = (
            follows is not None and follows.has("joint") and follows.get("joint") in ("door", "between", "open", "near")
        )
        many = whole.count is None or whole.count > 1
        private = tokens[at].has("joint") or any(
            t.has("own") or t.text in ("their", "its") for t in tokens[at : one.at]
        )
        if is_own(tokens[one.last + 1 : one.last + 4]):
            private = True  # "with a bathroom of its own"
        own = private or one.kind.name == "ensuite"
        each = (
            left.of is not None
            and left.count is None
            or any(t.text in PER_EACH for t in [*gap, *tokens[one.last + 1 : one.last + 3]])
        )
        if private and not one.told and not tokens[one.at].plural:
            one.count, one.told = 1, "article"  # "its own bathroom" is one more
        if not own and not each and many and _is_of_use(reading, whole):
            continue  # "a flat of three bedrooms with a kitchen"
        if many and (own or each) and (one.told != "number" or one.count == 1):
            one.per = left
        elif many and not each and left.of is None and one.count == 1 and not pointed and whole.told == "total":
            continue
        if pointed and follows is not None and follows.get("joint") == "between" and many:
            continue
        reading.joints.append(Joint(one, left, "door", tokens[at].span, each=one.per is not None))
        reading.did(at, "joint")
        for t in tokens[one.last + 1 : one.last + 3]:
            if t.text in PER_EACH:
                t.done = t.done or "joint"


def _is_of_use(reading: Reading, one: Named) -> bool:
    """Whether rooms say what a home is: "a flat of three bedrooms"."""
    if reading.use_at is None or reading.use_at > one.first:
        return False
    return [t.text for t in reading.tokens[reading.use_at + 1 : one.first]] in (["of"], ["with"])


def _shared(reading: Reading, names: dict[int, Named], sentence: range, at: int) -> None:
    """ "Two rooms that share a bathroom": doors from both."""
    left, right = _before(names, at), _after(names, at)
    if left is None or right is None or right.count not in (1, None) or not _close(reading, at, right):
        return
    right.count = 1
    reading.joints.append(Joint(right, left, "door", reading.tokens[at].span, each=True, hard=False))
    reading.did(at, "joint")


def _en_suites(reading: Reading, names: dict[int, Named], sentence: range) -> None:
    """En-suites belong to the bedrooms that are named with them: "one of them en-suite", "en-suite bedrooms"."""
    for k, one in sorted(names.items()):
        if one.kind.name != "ensuite" or any(j.a is one or j.b is one for j in reading.joints):
            continue
        next_ = _after(names, k)
        last = _before(names, one.first)
        if next_ is not None and next_.first == one.last + 1 and "bedroom" in (next_.kind.name, *next_.kind.counts_as):
            owner: Named | None = next_
        elif last is not None and "bedroom" in (last.root.kind.name, *last.root.kind.counts_as):
            owner = last
        else:
            beds = [r for r in reading.named if r.of is None and "bedroom" in (r.kind.name, *r.kind.counts_as)]
            couples = any(p.role == "couples" for p in reading.people)
            owner = None if couples or not beds else next((b for b in beds if b.kind.name == "master_bedroom"), beds[0])
        if owner is None:
            continue
        if owner.of is not None and owner.count is not None:
            one.count = owner.count
        elif owner.count is None or owner.count > 1 and (one.told == "" or owner is next_):
            one.per = owner
        reading.joints.append(Joint(one, owner, "door", one.span, each=one.per is not None))


def _before(names: dict[int, Named], at: int) -> Named | None:
    found = [one for k, one in names.items() if one.last < at]
    return max(found, key=lambda one: one.at) if found else None


def _after(names: dict[int, Named], at: int) -> Named | None:
    found = [one for k, one in names.items() if one.first > at]
    return min(found, key=lambda one: one.at) if found else None


def _close(reading: Reading, at: int, right: Named) -> bool:
    """Whether only small words stand between a word and the room behind it."""
    return all(
        t.text in _GAP or t.has("own", "soft", "size") and not t.breaks or t.text in ("one",)
        for t in reading.tokens[at + 1 : right.first]
    )


def _behind(reading: Reading, names: dict[int, Named], sentence: range, at: int) -> Named | str | None:
    """What stands behind a word of place: rooms, a place by its name, "" for a pronoun, None for something else."""
    tokens = reading.tokens
    for k in range(at + 1, sentence.stop):
        token = tokens[k]
        found = next((one for one in reading.named if one.first == k and one.of is None), None)
        if found is not None:
            return found
        if token.has("place"):
            reading.did(k, "joint")
            return str(token.get("place"))
        if token.has("them", "each") and token.text not in ("the rooms",):
            return ""
        if token.get("number") is not None and (k + 1 == sentence.stop or tokens[k + 1].breaks):
            return ""  # "between the two"
        if any(one.first == k for one in reading.named):
            return ""
        if (
            not (
                token.text in (*_GAP, "first", "second", "third", "last", "nearest") or token.has("own", "soft", "size")
            )
            or token.breaks
        ):
            return None
    return None


def _and_more(reading: Reading, names: dict[int, Named], one: Named) -> Named | None:
    """The room that "and" joins to another one."""
    tokens = reading.tokens
    if one.last + 1 >= len(tokens) or tokens[one.last + 1].text not in ("and", "&"):
        return None
    return next(
        (
            o
            for o in names.values()
            if o.first == one.last + 2 or o.first == one.last + 3 and tokens[one.last + 2].text in _GAP
        ),
        None,
    )


def _and_place(reading: Reading, one: Named, sentence: range) -> str:
    """The place that "and" joins to a room: "far from the kitchen and the front door"; empty where there is none."""
    tokens = reading.tokens
    if one.last + 1 >= sentence.stop or tokens[one.last + 1].text not in ("and", "&"):
        return ""
    k = one.last + 2
    while k < sentence.stop and tokens[k].text in _GAP:
        k += 1
    if k >= sentence.stop or not tokens[k].has("place"):
        return ""
    reading.did(k, "joint")
    return str(tokens[k].get("place"))


def _subjects(reading: Reading, names: dict[int, Named], left: Named, at: int) -> list[Named]:
    return [left]


def _put(reading: Reading, left: Named, right: Named, kind: AdjacencyKind, at: int, how: str = "") -> None:
    tokens = reading.tokens
    each = any(t.text in PER_EACH for t in tokens[at : right.first])
    if each and left.told != "number":
        left.per = right
    elif right.definite and right.told == "":
        right.count = right.count if right.count is not None else None
    if left.root is right.root and left is not right:
        return
    reading.joints.append(Joint(left, right, kind, tokens[at].span, each=each or kind == "apart", how=how))
    reading.did(at, "joint")
