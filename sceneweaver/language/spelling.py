"""Slips of the pen: a word that is in no list becomes the known one that differs by a letter, and a note says so."""

from __future__ import annotations

from functools import cache, lru_cache

from .vocabulary import vocabulary, words

SHORT = 6
"""Letters that both words must have; a short word has too many neighbours."""

MOST = 40
"""Letters that a word with a slip has at most; no known word is longer."""

LONG = 8
"""Letters of a word in which one may be wrong: a letter too many or missing makes a word of its own less often."""

_ENDINGS = ("ed", "ing", "er", "or", "ly", "al", "ous", "est", "ness", "ion", "ive", "ist", "ish", "y", "s")
_USEFUL = ("noun", "room", "color", "styles", "preposition", "place", "material")


def mended(word: str, notes: list[str]) -> str | None:
    """The known word that was probably meant; None when there is none, or when the word may be one of its own."""
    if not SHORT <= len(word) <= MOST or not word.isascii() or not word.isalpha():
        return None
    found = _neighbour(word)
    if found is not None:
        note = f"'{word}' was read as '{found}'"
        if note not in notes:
            notes.append(note)
    return found


def mended_place(word: str, after: str, notes: list[str]) -> str | None:
    """The word of place that was probably meant by a word that is not known and stands before an article: "undr the".
    Those are short, and few; None where it is like none of them."""
    if after not in _ARTICLES or not 4 <= len(word) <= MOST or word in _real_words():
        return None
    fitting = [p for p in _places() if p[0] == word[0] and (_slip(word, p) or _one_wrong(word, p))]
    if not fitting:
        return None
    note = f"'{word}' was read as '{fitting[0]}'"
    if note not in notes:
        notes.append(note)
    return fitting[0]


_ARTICLES = frozenset(("the", "a", "an", "my", "our", "his", "her", "its", "their", "each", "every", "both"))


def _one_wrong(a: str, b: str) -> bool:
    return len(a) == len(b) and sum(x != y for x, y in zip(a, b, strict=True)) == 1


@cache
def _places() -> tuple[str, ...]:
    """Single words of place that are long enough to be known with a slip."""
    return tuple(w for w, kinds in vocabulary().items() if "preposition" in kinds and w.isalpha() and len(w) >= 5)


@lru_cache(maxsize=4096)
def _neighbour(word: str) -> str | None:
    """A known word one letter away (wrong, missing, too many or changed round) that is no other form of it.

    A real word that the lexicon lacks must not be taken for one that it has, so inflections and derivations stay, and
    so do the words of ``spelling.yaml``.
    """
    if word in _real_words():
        return None
    candidates = {near for key in (word, *_without_one(word)) for near in _by_key().get(key, ()) if near != word}
    fitting = sorted(
        near for near in candidates if near[0] == word[0] and _slip(word, near) and not _derived(word, near)
    )
    return fitting[0] if fitting else None


def _without_one(word: str) -> list[str]:
    return [word[:k] + word[k + 1 :] for k in range(len(word))]


@cache
def _by_key() -> dict[str, list[str]]:
    """Known words by themselves and by themselves with a letter left out."""
    table: dict[str, list[str]] = {}
    for word, kinds in vocabulary().items():
        if " " not in word and len(word) >= SHORT and any(kind in kinds for kind in _USEFUL):
            for key in {word, *_without_one(word)}:
                table.setdefault(key, []).append(word)
    return table


@cache
def _real_words() -> frozenset[str]:
    return frozenset(words("spelling")["words"])


def _slip(a: str, b: str) -> bool:
    """Whether one letter is wrong, missing or too many, or two neighbours are changed round."""
    if len(a) == len(b):
        wrong = [k for k in range(len(a)) if a[k] != b[k]]
        swapped = (
            len(wrong) == 2 and wrong[1] == wrong[0] + 1 and a[wrong[0]] == b[wrong[1]] and a[wrong[1]] == b[wrong[0]]
        )
        return swapped or (len(wrong) == 1 and len(a) >= LONG)
    long, short = (a, b) if len(a) > len(b) else (b, a)
    return len(long) - len(short) == 1 and short in _without_one(long)


def _derived(word: str, near: str) -> bool:
    """Whether two words differ in their endings alone: printed and printer, dresses and dresser."""
    same = next((k for k, (a, b) in enumerate(zip(word, near, strict=False)) if a != b), min(len(word), len(near)))
    tails = word[same:], near[same:]
    ends = any(w.endswith(e) and len(w) - len(e) <= same for w in (word, near) for e in _ENDINGS)
    return ends and max(map(len, tails)) <= 3 and same >= len(word) - 3
