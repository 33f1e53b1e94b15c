"""The columns of results are those of the page."""

from __future__ import annotations

import re
from dataclasses import asdict

import pytest

from sceneweaver.bench import results
from sceneweaver.bench.results import COLUMNS, arrow_schema
from sceneweaver.scene import InputError
from tests.test_repository import ROOT


def test_the_page_has_the_columns():
    text = (ROOT / "docs" / "harness.md").read_text()
    rows = re.findall(r"^\| `(\w+)` \| (\w+) \| (.+) \|$", text, re.MULTILINE)
    assert {name: (kind, about) for name, kind, about in rows} == COLUMNS


def test_files_say_what_columns_are():
    schema = arrow_schema(b"{}")
    assert [field.name for field in schema] == list(COLUMNS)
    assert schema.field("seconds").metadata[b"about"].decode() == COLUMNS["seconds"][1]


def test_results_that_do_not_say_of_which_settings_they_are_are_one_line(tmp_path):
    pa = results.pyarrow()
    row = asdict(results.Row("adam", "study", "rooms", "0", 4, 12, None, 0, 8))
    for number, metadata in enumerate((None, {b"other": b"{}"}, {results.KEY: b"["})):
        schema = results.arrow_schema(b"{}").with_metadata(metadata)
        path = tmp_path / f"{number}.parquet"
        pa.parquet.write_table(pa.Table.from_pylist([row], schema), path)
        with pytest.raises(InputError, match="does not say of which settings|invalid JSON"):
            results.read_about(path)


def test_results_without_rows_are_one_line(tmp_path):
    pa = results.pyarrow()
    path = tmp_path / "results.parquet"
    pa.parquet.write_table(pa.Table.from_pylist([], results.arrow_schema(b"{}")), path)
    with pytest.raises(InputError, match="there is no row in it"):
        results.read_runs(path)
