"""Requests with marks: what each mentions and how that is linked, written by hand, to train and to measure readers.

A line is a request in which mentions are marked, ``{coffee table|3T}``, and after `` || `` the links between them,
``on(5,3)``, and how many of each there are in the room, ``n5=2`` (``+``: some). 0 is the room as a whole.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from sceneweaver.language.learned.labels import KINDS, LINKS

FOLDER = Path(__file__).parent / "data" / "annotated_requests"
HELD_OUT = "held_out"
"""The writer of whom nothing is trained on."""

LETTERS = dict(zip("TNPOWFMAGRI", KINDS, strict=True))
"""Kinds of mentions by their letters."""

_MARK = re.compile(r"\{([^{}|]+)\|(\d+)([" + "".join(LETTERS) + r"])\}")
_LINK, _COUNT = re.compile(r"([a-z]+)\((\d+),(\d+)\)"), re.compile(r"n(\d+)=(\d+|\+)")


@dataclass(frozen=True)
class Annotated:
    """A request with what it mentions.

    Attributes:
        text: the request.
        mentions: by number, from 1: where it begins and ends in the text, and its kind.
        links: name, from, to.
        counts: of things and persons by number, None for some; what is not in it is one.
        writer: who wrote it.
    """

    text: str
    mentions: Mapping[int, tuple[int, int, str]]
    links: tuple[tuple[str, int, int], ...]
    counts: Mapping[int, int | None]
    writer: str = ""


def annotated(line: str, writer: str = "") -> Annotated:
    """What a line says.

    Raises:
        ValueError: a mark or a link is not as it should be.
    """
    marked, _, told = line.strip().partition(" || ")
    text, mentions, at = "", dict[int, tuple[int, int, str]](), 0
    for found in _MARK.finditer(marked):
        text += marked[at : found.start()]
        number = int(found[2])
        if number in mentions or number == 0:
            raise ValueError(f"mention {number} is there twice, or 0: {line[:60]}")
        mentions[number] = (len(text), len(text) + len(found[1]), LETTERS[found[3]])
        text, at = text + found[1], found.end()
    text += marked[at:]
    if not {"{", "}", "|"}.isdisjoint(text):
        raise ValueError(f"a mark is broken: {line[:60]}")
    links, counts = list[tuple[str, int, int]](), dict[int, int | None]()
    for word in told.split():
        if (found := _COUNT.fullmatch(word)) and int(found[1]) in mentions:
            counts[int(found[1])] = None if found[2] == "+" else int(found[2])
        elif (found := _LINK.fullmatch(word)) and found[1] in LINKS and found[2] != found[3]:
            links.append((found[1], int(found[2]), int(found[3])))
            if not {int(found[2]), int(found[3])} <= {0, *mentions} or found[2] == "0":
                raise ValueError(f"{word} links what is not there: {line[:60]}")
        else:
            raise ValueError(f"{word} is no link: {line[:60]}")
    return Annotated(text, mentions, tuple(links), counts, writer)


def annotated_requests(held_out: bool = False) -> Iterator[Annotated]:
    """All requests of the writers that are trained on, or those of the one who is held out."""
    for file in sorted(FOLDER.glob("*.requests")):
        if (file.stem == HELD_OUT) is held_out:
            yield from (annotated(line, file.stem) for line in file.read_text("utf-8").splitlines() if line.strip())
