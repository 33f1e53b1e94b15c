"""What single rooms are to have besides: the words behind their names, and before "in the ...". What is not wanted."""

from __future__ import annotations

from sceneweaver.language.model import Span

from .described import is_look
from .loose import is_style, read_loose, said_words, thing_end
from .mentions import is_thing
from .parts import Named, Reading

_BEGIN = (
    "with",
    "for",
    "has",
    "have",
    "where",
    "that",
    "which",
    "big",
    "of",
    "seats",
    "seating",
    "without",
    "to",
    "it",
    "in",
    "no",
)
_FILLED = ("lined", "filled", "full", "fitted", "equipped", "furnished", "complete", "packed")
"""Words before "with" or "of" that say that a room has something."""

_BEFORE_PLACE = ("the", "a", "an", "our", "my", "for", "for each", "each", "each of them", "each of us", "of them")

_BEDS = ("double", "single", "twin", "queen", "king", "bunk")
"""Sizes of beds, by which one is meant."""

_COPULAS = ("is", "are", "should", "must", "be", "painted", "all", "please", "to", "has")

_KEEP_SMALL = ("at", "next", "under", "by", "beside", "behind", "above", "in", "to", "on")


def read_wishes(reading: Reading) -> None:
    """Gives each room the words that are said of it alone, see above; what is in no room stays loose."""
    for sentence in reading.sentences():
        _unwanted(reading, sentence)
        _before_rooms(reading, sentence)
        _behind_rooms(reading, sentence)
        read_loose(reading, sentence)
    _styles(reading)


def _unwanted(reading: Reading, sentence: range) -> None:
    """Rooms and things that are not to be there."""
    tokens = reading.tokens
    for at in sentence:
        if not tokens[at].has("no") or tokens[at].done or at + 1 < len(tokens) and tokens[at + 1].text == "be":
            continue
        if (words := _other_size(reading, sentence, at)) is not None:
            reading.unwanted.append(words)
            continue
        barring = True
        for k in range(at + 1, min(at + 12, sentence.stop)):
            token = tokens[k]
            named = next((one for one in reading.named if one.first <= k <= one.last and one.of is None), None)
            if named is not None and named.first == at + 1:  # right behind it: nothing else can be said of the room
                reading.joints = [j for j in reading.joints if j.a is not named and j.b is not named]
            if named is not None and barring and not any(j.a is named or j.b is named for j in reading.joints):
                if named.told in ("", "article") and k == named.at:
                    named.barred = True
                    reading.rows.append((named.span, "not wanted", named.kind.name))
                    reading.did(at, "not wanted")
                continue
            if token.has("joint") and not token.done:
                break
            if token.breaks and token.text != "," or token.text in ("but", "with", "please", "if"):
                break
            if is_thing(token) and not token.done:
                end = thing_end(reading, k, sentence.stop)
                words = " ".join(t.text for t in tokens[k:end])
                reading.unwanted.append((words, Span(tokens[k].span.start, tokens[end - 1].span.end)))
                for j in (at, *range(k, end)):
                    reading.did(j, "not wanted")
            elif (
                token.text == ","
                and k + 1 < sentence.stop
                and not tokens[k + 1].has("no")
                and tokens[k + 1].text != "or"
                or token.text not in ("a", "an", "the", "any", "or", "and", ",")
                and not token.done
                and not token.has("no", "size", "own")
            ):
                break


def _other_size(reading: Reading, sentence: range, at: int) -> tuple[str, Span] | None:
    """ "Two single beds, not a double": the thing that was named before, of another size."""
    tokens = reading.tokens
    k = at + 1 + (at + 1 < sentence.stop and tokens[at + 1].text in ("a", "an", "the"))
    if k >= sentence.stop or tokens[k].text not in _BEDS or k + 1 < sentence.stop and not tokens[k + 1].breaks:
        return None
    if not any(word in ("bed", "beds") for j in range(sentence.start, at) for word in tokens[j].text.split()):
        return None
    for j in range(at, k + 1):
        reading.did(j, "not wanted")
    return f"{tokens[k].text} bed", tokens[k].span


def _before_rooms(reading: Reading, sentence: range) -> None:
    """ "A crib in the parents' bedroom": the words before belong to the room."""
    tokens = reading.tokens
    for one in reading.named:
        k = one.first - 1
        if one.at not in sentence or k <= sentence.start or tokens[k].text not in ("in", "inside", "into", "for"):
            continue
        start = k
        while start > sentence.start and not tokens[start - 1].breaks and not tokens[start - 1].done and k - start < 9:
            start -= 1
        while start < k and tokens[start].text in (
            "and",
            "put",
            "with",
            "we",
            "need",
            "want",
            "would",
            "like",
            "there",
            "is",
            "there's",
            "be",
            "should",
        ):
            start += 1
        if any(is_thing(tokens[j]) for j in range(start, k)):
            words = said_words(tokens[start:k])
            one.wishes.append(words)
            for j in range(start, k + 1):
                reading.did(j, f"request of {one.kind.name}")


def _behind_rooms(reading: Reading, sentence: range) -> None:
    """ "With a table for six", "where two can work": to the next room, or where something else is said."""
    tokens = reading.tokens
    for one in sorted(reading.named, key=lambda n: n.at):
        if one.at not in sentence:
            continue
        k = one.last + 1
        while (
            k < sentence.stop
            and tokens[k].text in (",",)
            and k + 1 < sentence.stop
            and tokens[k + 1].text in ("with", "for", "without")
        ):
            k += 1
        if _is_like(reading, one, sentence):
            continue
        k = _behind_place(reading, one, k, sentence)
        if k >= sentence.stop or tokens[k].breaks or tokens[k].text not in _BEGIN and not tokens[k].has("size"):
            continue
        end = k
        while end < sentence.stop and not tokens[end].breaks and not any(n.first == end for n in reading.named):
            whose = tokens[end].done == "people" and end + 1 < sentence.stop and is_thing(tokens[end + 1])
            if tokens[end].text in ("is", "are") and tokens[end - 1].has("me", "we", "person"):
                break  # "a little one will do for us"
            if tokens[end].done not in ("", "request") and not whose or tokens[end].has("storey"):
                break
            end += 1
        follows = end < sentence.stop and any(n.first == end for n in reading.named)
        last = end
        while last > k and (
            tokens[last - 1].text in ("and", "with", "a", "an", "the", "or", "plus", "in", "by", "of", "at", "to")
            or tokens[last - 1].has("joint")
            and follows
        ):
            last -= 1
        told = tokens[k:last]
        if not told or not any(
            is_thing(t) or t.has("person", "staff", "visitors", "number", "groups", "size", "animal") or not t.kinds
            for t in told
        ):
            continue
        said = said_words(told)
        if tokens[k - 1].text in _FILLED:
            said = f"with {said_words(told[1:])}"
            reading.did(k - 1, f"request of {one.root.kind.name}")
        sizes = [t for t in told if t.has("size")]
        if sizes and len([t for t in told if t.has("size") or is_thing(t) or not t.kinds]) == len(sizes):
            one.root.size = one.root.size or sizes[0].get("size")
        else:
            (one.root if one.of is None or one.count is None else one).wishes.append(said)
        for j in range(k, last):
            reading.did(j, f"request of {one.root.kind.name}")


def _behind_place(reading: Reading, one: Named, at: int, sentence: range) -> int:
    """Where what a room has begins: behind a place that it faces, light that it has or not, and "lined" or "full"."""
    tokens = reading.tokens
    k = at
    while k < sentence.stop and not tokens[k].breaks and not any(n.first == k for n in reading.named):
        if tokens[k].text in _FILLED and k + 1 < sentence.stop and tokens[k + 1].text in ("with", "of", "in"):
            return k + 1
        if tokens[k].text == "with" and k > at:
            return k
        if not (tokens[k].done in ("joint", "light") or tokens[k].text in _BEFORE_PLACE):
            break
        k += 1
    return at


def _is_like(reading: Reading, one: Named, sentence: range) -> bool:
    """ "The kitchen is red", "both bedrooms should be bright": what rooms are like."""
    tokens = reading.tokens
    k = one.last + 1
    while k < sentence.stop and tokens[k].text in _COPULAS:
        k += 1
    end = k
    while end < sentence.stop and (is_look(tokens[end]) or end > k and tokens[end].text in ("and", "or")):
        end += 1
    if k == one.last + 1 or end == k:
        return False
    one.root.looks += [token.text for token in tokens[k:end] if is_look(token)]
    for j in range(k, end):
        reading.did(j, f"request of {one.root.kind.name}")
    return True


def _styles(reading: Reading) -> None:
    """Words for a style that belong to no room are for all of them."""
    for at, token in enumerate(reading.tokens):
        if not is_style(token) or token.done:
            continue
        reading.styles.append(token.text)
        reading.rows.append((token.span, "style", f"{token.text}, in the request of each room"))
        reading.did(at, "style")
        after = reading.tokens[at + 1] if at + 1 < len(reading.tokens) else None
        if after is not None and after.text in ("style", "styled", "look", "feel"):
            reading.did(at + 1, "style")
