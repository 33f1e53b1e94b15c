"""What is said of rooms beside their name: how many, how large, what they are like."""

from __future__ import annotations

from sceneweaver.language.vocabulary import vocabulary

from .lexicon import activities
from .limits import LIMITS, say_limit
from .parts import Named, Reading
from .tokens import Token

_DEFINITE = ("the", "our", "my", "their", "his", "her", "its", "your")
_LOOK_KINDS = (
    "styles",
    "moods",
    "color",
    "materials",
    "material",
    "finish",
    "adjective",
    "density",
    "room_scale",
    "scale",
    "shape",
)


def read_before(reading: Reading, found: Named) -> None:
    """What stands before the name of a room: how many, how large, what it is like."""
    tokens = reading.tokens
    k, strange, own = found.first - 1, 0, False
    while k >= 0:
        token = tokens[k]
        if (
            token.breaks
            or k == reading.use_at
            or token.done == "rooms"
            or token.has("joint", "place")
            and not token.has("own", "size")
        ):
            break
        if token.get("number") is not None and not token.has("area"):
            found.count, found.told = int(token.get("number")), "number"
            if token.text == "one" and tokens[found.at].plural:
                found.count, found.told = None, ""
        elif token.text in ("a", "an", "another"):
            found.count, found.told = 1, "article"
        elif token.text in _DEFINITE:
            found.definite = True
        elif token.has("size"):
            found.size = token.get("size")
        elif token.has("area"):
            found.area = token.get("area")
        elif token.has("equal"):
            found.equal = True
        elif token.has("accessible"):
            found.accessible = True
        elif token.text in ("each", "both", "every", "all"):
            found.all = True
        elif token.has("own", "soft"):
            found.open = found.open or token.text == "open"
            own = own or token.text == "own"
            if token.has("unmeasured"):
                reading.say_vague(token)
            if token.has("vague") and is_look(token):
                found.looks.insert(0, token.text)
            elif token.has("vague"):
                reading.say_vague(token)
            if token.text in ("several", "many", "few"):
                found.count = None
        elif token.has("person", "visitors", "staff", "me", "we") or token.text in ("guest", "staff"):
            if not (token.text.endswith(("'s", "s'")) or token.text in ("guest", "staff")):
                break
            found.definite = found.definite or not found.told
        elif token.text.endswith("'s") and not token.kinds:
            found.definite = found.definite or not found.told
        elif token.text in activities() and k == found.at - 1:
            pass
        elif is_look(token) and strange < 3:
            found.looks.insert(0, token.text)
            strange += 1
        else:
            break
        found.first = k
        k -= 1
    if own and not found.told and not tokens[found.at].plural:
        found.count, found.told = 1, "article"  # "its own bathroom" is one more


def is_look(token: Token) -> bool:
    """Whether a word says what a room is like."""
    kinds = vocabulary().get(token.text, {})
    return any(kind in kinds for kind in _LOOK_KINDS) and "verb" not in kinds and not token.has("function")


def read_behind(reading: Reading, found: Named) -> None:
    """The area behind the name of a room: "of 12 to 14 sqm each", "(18 m2)", "20 m2"."""
    tokens = reading.tokens
    k, seen = found.at + 1, False
    while k < len(tokens) and k < found.at + 7:
        token = tokens[k]
        if token.has("area"):
            low, high = token.get("area")
            seen, found.last = True, k
            found.area = (low, high)
            say_limit(reading, found, k)
        elif token.has("equal"):
            found.equal, found.last = True, k
        elif (
            token.text == "("
            and k + 2 < len(tokens)
            and tokens[k + 1].number
            and tokens[k + 2].text == ")"
            and not found.told
        ):
            found.count, found.told, found.last = tokens[k + 1].number, "number", k + 2
            break
        elif seen and token.text in ("each", ")", "per"):
            found.last = k
        elif seen or not (
            token.text
            in (
                "of",
                "all",
                "the",
                "about",
                "around",
                "(",
                "approx",
                "roughly",
                "ca",
                "circa",
                "with",
                "each",
                "some",
                "is",
                "only",
                *LIMITS,
            )
            or token.has("soft")
        ):
            break
        k += 1
