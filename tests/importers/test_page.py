"""The page about importers lists every format as its reader describes it."""

import textwrap
from pathlib import Path

from sceneweaver.importers import formats

PAGE = Path(__file__).parents[2] / "docs" / "importers.md"


def sections() -> str:
    """A section a format, in lines of the page's width."""
    parts: list[str] = []
    for name, entry in sorted(formats().items()):
        parts.append(f"### `{name}`: {entry.title}")
        parts.append(
            "\n".join(textwrap.wrap(" ".join(entry.notes), 118, break_on_hyphens=False, break_long_words=False))
        )
    return "\n\n".join(parts)


def test_the_page_lists_every_format():
    text = PAGE.read_text(encoding="utf-8")
    listed = text.split("<!-- formats: compared with the readers by a test -->")[1].split("<!-- end -->")[0].strip()
    assert listed == sections()


def test_every_format_says_what_it_reads():
    for entry in formats().values():
        assert entry.title and entry.notes, entry.name
