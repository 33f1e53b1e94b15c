"""The notebooks run on small sizes, and what is stored of them is whole, small and says nothing about this machine."""

from __future__ import annotations

import base64
import re

import nbformat
import pytest

from tests.test_repository import ROOT

pytest.importorskip("nbclient")
from notebooks.store import NOTEBOOKS, SWITCH, executed, tidied, with_time  # noqa: E402

MACHINE = re.compile(r"(?<![\w.])/(?:home|root|Users|work|tmp)/\w|site-packages|0x[0-9a-f]{6,}")
STORED = [pytest.param(path, id=path.stem) for path in NOTEBOOKS]


def outputs(book):
    """Every output of a notebook."""
    return [output for cell in book.cells if cell.cell_type == "code" for output in cell.outputs]


def test_the_code_of_the_first_runs(monkeypatch, capsys):
    """Without a kernel of its own, which takes longer to start than the code to run."""
    plot = pytest.importorskip("matplotlib.pyplot")
    plot.switch_backend("agg")
    monkeypatch.setattr(plot, "show", lambda: None)
    monkeypatch.setenv(SWITCH, "small")
    book, names = nbformat.read(NOTEBOOKS[0], as_version=4), {"__name__": "__main__"}
    for cell in book.cells:
        if cell.cell_type == "code":
            exec(compile(cell.source, NOTEBOOKS[0].name, "exec"), names)
    said = capsys.readouterr()
    assert "the judge on the best: valid" in said.out and said.err == ""
    plot.close("all")


@pytest.mark.slow
@pytest.mark.parametrize("path", STORED)
def test_it_runs(path):
    book = tidied(executed(path, small=True))
    said = [output.text for output in outputs(book) if output.output_type == "stream" and output.name == "stderr"]
    assert said == []


@pytest.mark.parametrize("path", STORED)
def test_it_is_stored_with_outputs_of_one_run(path):
    book = nbformat.read(path, as_version=4)
    nbformat.validate(book)
    code = [cell for cell in book.cells if cell.cell_type == "code"]
    assert 8 <= len(book.cells) <= 32 and book.cells[0].source.startswith("# ")
    assert [cell.execution_count for cell in code] == list(range(1, len(code) + 1))
    assert [output for output in outputs(book) if output.output_type == "error" or output.get("name") == "stderr"] == []
    pictures = [
        base64.b64decode(output.data[kind])
        for output in outputs(book)
        for kind in ("image/png", "image/jpeg")
        if kind in output.get("data", {})
    ]
    assert len(pictures) >= 2 and max(map(len, pictures)) <= 150_000
    assert path.stat().st_size < 600_000
    text = re.sub(r'"image/\w+": ".*?"', "", path.read_text())
    assert MACHINE.findall(text) == []


def test_all_are_listed_in_order():
    text = (ROOT / "notebooks" / "README.md").read_text()
    listed = re.findall(r"\]\((\w+\.ipynb)\)(?: \((\d+) s\))?:", text)
    assert [name for name, _ in listed] == [path.name for path in NOTEBOOKS]
    assert all(seconds and 1 <= int(seconds) <= 60 for _, seconds in listed), "measured by: python -m notebooks.store"


def test_the_list_takes_a_measured_time():
    for text in ("- [A](01_a.ipynb): words", "- [A](01_a.ipynb) (99 s): words"):
        assert with_time(text + "\n- [B](02_b.ipynb): more", "01_a.ipynb", 12.4) == (
            "- [A](01_a.ipynb) (12 s): words\n- [B](02_b.ipynb): more"
        )
