"""The page about rules of plans lists every row of every profile, every measure and every type of room."""

from __future__ import annotations

import textwrap
from collections.abc import Callable
from pathlib import Path

import pytest

from sceneweaver.plans import MEASURES, Profile, Rule, profile_names, programme_names, room_types
from sceneweaver.plans.programme import Programme

PAGE = Path(__file__).parents[2] / "docs" / "plan_rules.md"
ORDER = ("base", "accessible", "japan")


def wrapped(text: str) -> str:
    """An item of a list, in lines of the page's width."""
    return "\n".join(textwrap.wrap(text, 118, subsequent_indent="  ", break_on_hyphens=False, break_long_words=False))


def row_text(row: Rule) -> str:
    """A row in words, its numbers and its source."""
    kind = "hard" if row.hard else f"soft, weight {row.weight:g}"
    uses = f", {' and '.join(row.uses)}" if row.uses and len(row.uses) < 4 else ""
    bounds = [
        f"{word} {value:g}" for word, value in (("at least", row.least), ("at most", row.most)) if value is not None
    ]
    return wrapped(
        f"- `{row.id}` ({kind}{uses}): {row.says} `{row.measure}` {', '.join(bounds)}. Source: {row.source}."
    )


def rows() -> str:
    """A section a profile; of one that extends another, the rows that it adds or changes."""
    parts: list[str] = []
    assert set(ORDER) == set(profile_names())
    for name in ORDER:
        profile = Profile.named(name)
        below = set(Profile.named(profile.extends).rows) if profile.extends else set()
        on_top = f", on top of `{profile.extends}`" if profile.extends else ""
        parts.append(f"### `{name}`: {profile.title}{on_top}")
        parts.append("\n".join(row_text(row) for row in profile.rows if row not in below))
    return "\n\n".join(parts)


def measures() -> str:
    """A line a measure."""
    return "\n".join(wrapped(f"- `{name}`: {text}") for name, text in MEASURES.items())


def types() -> str:
    """A line a type of room."""
    lines = []
    for kind in room_types().values():
        least, usual, most = kind.area
        roles = ", ".join(sorted(kind.roles)) or "no role"
        lines.append(
            wrapped(f"- `{kind.name}`: {roles}; a way to {kind.transit}; {least:g} to {most:g} m2, usually {usual:g}")
        )
    return "\n".join(lines)


def programmes() -> str:
    """A line a programme that ships."""
    lines = []
    for name in programme_names():
        programme = Programme.example(name)
        floor = sum(room.area[1] for room in programme.rooms)
        storeys = f" on {programme.storeys} storeys" if programme.storeys > 1 else ""
        lines.append(f"- `{name}`: {len(programme.rooms)} rooms{storeys}, {floor:.0f} m2")
    return "\n".join(lines)


@pytest.mark.parametrize("listed", [rows, measures, types, programmes])
def test_the_page_lists(listed: Callable[[], str]):
    text = PAGE.read_text(encoding="utf-8")
    mark = f"<!-- {listed.__name__}: compared with the data by a test -->"
    assert text.split(mark)[1].split("<!-- end -->")[0].strip() == listed()
