"""Slips of the pen: a word that is in no list becomes the known one that differs by a letter, and a note says so.

Words that are run together become two, and of the commonest words short ones are mended as well.
"""

from __future__ import annotations

from functools import cache, lru_cache

from sceneweaver.assets.wordnet import noun_named

from .vocabulary import vocabulary, words

SHORT = 6
"""Letters that both words must have; a short word has too many neighbours."""

LEAST = 4
"""Letters that a slip of a common word has at least."""

MOST = 40
"""Letters that a word with a slip has at most; no known word is longer."""

LONG = 8
"""Letters of a word in which one may be wrong: a letter too many or missing makes a word of its own less often."""

_ENDINGS = ("ed", "ing", "er", "or", "ly", "al", "ous", "est", "ness", "ion", "ive", "ist", "ish", "y", "s")
_USEFUL = ("noun", "room", "color", "styles", "preposition", "place", "material")


def mended(word: str, notes: list[str]) -> str | None:
    """The known word or words that were probably meant; None when there are none, or when the word may be one of its
    own."""
    if word in _spoken() or not len(word) <= MOST or not word.isascii() or not word.isalpha():
        return None
    found = words("spelling")["slips"].get(word) or _common_slips().get(word) or _run_together(word)
    if found is None and len(word) >= SHORT:
        found = _neighbour(word)
    if found is not None:
        note = f"'{word}' was read as '{found}'"
        if note not in notes:
            notes.append(note)
    return found


@cache
def _spoken() -> frozenset[str]:
    """All words of all phrases that are known."""
    return frozenset(word for phrase in vocabulary() for word in phrase.split())


@cache
def _common_slips() -> dict[str, str]:
    """Slips of common words with the word: a letter missing, doubled or changed round with the one after it."""
    data = words("spelling")
    found: dict[str, set[str]] = {}
    for word in data["common"]:
        ways = {word[:k] + word[k + 1 :] for k in range(1, len(word))}
        ways |= {word[:k] + word[k + 1] + word[k] + word[k + 2 :] for k in range(len(word) - 1)}
        ways |= {word[:k] + word[k] + word[k:] for k in range(len(word))}
        for slip in ways:
            if len(slip) >= LEAST:
                found.setdefault(slip, set()).add(word)
    real = _real_words() | frozenset(data["not_common"]) | _spoken()
    return {slip: min(meant) for slip, meant in found.items() if len(meant) == 1 and slip not in real}


@lru_cache(maxsize=4096)
def _run_together(word: str) -> str | None:
    """ "Livingroom": two words that are a known phrase together, written as one."""
    for k in range(2, len(word) - 1):
        kinds = vocabulary().get(f"{word[:k]} {word[k:]}", {})
        if len(word) >= SHORT and kinds.keys() & {"noun", "room", "preposition", "place_adverb", "mutual", "place"}:
            return f"{word[:k]} {word[k:]}"
    return None


@lru_cache(maxsize=4096)
def _neighbour(word: str) -> str | None:
    """A known word one letter away (wrong, missing, too many or changed round) that is no other form of it.

    A real word that the lexicon lacks must not be taken for one that it has, so inflections and derivations stay, and
    so do the nouns of a dictionary and the words of ``spelling.yaml``.
    """
    if word in _real_words() or noun_named(word) is not None:
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
