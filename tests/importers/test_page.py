"""The page about importers lists every format as its reader describes it."""

from pathlib import Path

from sceneweaver.importers import formats

PAGE = Path(__file__).parents[2] / "docs" / "importers.md"


def table() -> str:
    rows = ["| `--from` | files of | what is read, assumed and lost |", "| --- | --- | --- |"]
    for name, entry in sorted(formats().items()):
        rows.append(f"| `{name}` | {entry.title} | {' '.join(entry.notes)} |".replace("\n", " "))
    return "\n".join(rows)


def test_the_page_lists_every_format():
    text = PAGE.read_text(encoding="utf-8")
    listed = text.split("<!-- formats: compared with the readers by a test -->")[1].split("<!-- end -->")[0].strip()
    assert listed == table()


def test_every_format_says_what_it_reads():
    for entry in formats().values():
        assert entry.title and entry.notes, entry.name
