"""The columns of results are those of the page."""

from __future__ import annotations

import re

from sceneweaver.bench.results import COLUMNS, arrow_schema
from tests.test_repository import ROOT


def test_the_page_has_the_columns():
    text = (ROOT / "docs" / "harness.md").read_text()
    rows = re.findall(r"^\| `(\w+)` \| (\w+) \| (.+) \|$", text, re.MULTILINE)
    assert {name: (kind, about) for name, kind, about in rows} == COLUMNS


def test_files_say_what_columns_are():
    schema = arrow_schema(b"{}")
    assert [field.name for field in schema] == list(COLUMNS)
    assert schema.field("seconds").metadata[b"about"].decode() == COLUMNS["seconds"][1]
