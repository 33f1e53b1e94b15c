"""Files, page, and exit codes."""

from __future__ import annotations

import json

import pytest

from benchmarks import children, cli, plots
from benchmarks.markdown import blocks, result_lines, show, table_lines
from benchmarks.results import Column, Plot, Result, Table

COLUMNS = [Column("room", "room"), Column("share", "share", "share"), Column("time", "time [s]", "number")]
ROWS = [{"room": "a", "share": 0.5, "time": 1.0}, {"room": "b", "share": None}]


def _result(settings, judge) -> Result:
    result = Result("quality", "Quality", "About it.")
    result.add("t", "A table", COLUMNS).rows += [dict(row) for row in ROWS]
    result.plots.append(Plot("p", "A plot", "t", "room", ("share",)))
    result.notes.append("A note.")
    return result


def _wrong(settings, judge) -> Result:
    result = _result(settings, judge)
    result.failures.append("room, candidate 3: status valid, but collision: bed sinks 2 cm into desk")
    return result


def _broken(settings, judge) -> Result:
    raise RuntimeError("no such kernel")


@pytest.fixture
def families(monkeypatch):
    table = {"quality": _result, "soundness": _wrong, "edits": _broken}
    monkeypatch.setattr(cli, "FAMILIES", table)
    return table


@pytest.mark.parametrize(
    ("value", "form", "text"),
    [
        (1.0, "share", "100 %"),
        (0.9999, "share", "99.9 %"),
        (0.0001, "share", "0.1 %"),
        (0.0, "share", "0 %"),
        (0.123, "share", "12.3 %"),
        (12345, "count", "12,345"),
        (1234.5, "number", "1,234"),
        (12.345, "number", "12.3"),
        (0.01, "number", "0.0100"),
        (0.0000123, "number", "1.2e-05"),
        (0.3, "mm", "300"),
        (1e-7, "mm", "< 0.001"),
        (2.25, "mib", "2.2"),
        (None, "share", "-"),
    ],
)
def test_cells(value, form, text):
    assert show(value, form) == text


def test_wide_tables_are_continued():
    columns = [Column("room", "room"), *(Column(f"c{k}", f"a long heading {k}") for k in range(10))]
    table = Table("wide", "Wide", columns, [{"room": "living", **{f"c{k}": "x" for k in range(10)}}])
    parts = blocks(table)
    assert len(parts) == 2
    assert [c.key for part, _ in parts for c in part if c.key != "room"] == [f"c{k}" for k in range(10)]
    assert all(part[0].key == "room" for part, _ in parts)
    assert max(map(len, table_lines(table))) <= 120


def test_results_survive_their_file(tmp_path):
    result = _wrong(None, None)
    assert Result.load(result.save(tmp_path)) == result
    (tmp_path / "other.json").write_text("[]")
    with pytest.raises(ValueError, match="other.json is no result"):
        Result.load(tmp_path / "other.json")


def test_failures_come_first_in_the_text():
    lines = result_lines(_wrong(None, None))
    assert lines.index("**1 answers were wrong:**") < lines.index("A table:")


def test_run_and_report(families, tmp_path):
    out = tmp_path / "out"
    assert cli.main(["quality", "--device", "cpu", "--quick", "--out", str(out), "--commit", "abc"]) == 0
    data = json.loads((out / "quality.json").read_text())
    assert data["schema"] == "sceneweaver.benchmark/1"
    assert {"cpu", "cores", "device", "device_name", "versions", "commit", "date"} <= set(data["machine"])
    assert data["machine"]["commit"] == "abc"
    assert data["options"]["quick"] is True and data["options"]["seed"] == 0
    assert (out / "quality.md").read_text().startswith("## Quality\n")
    page = tmp_path / "page.md"
    assert cli.main(["report", "--from", str(out), "--to", str(page)]) == 0
    text = page.read_text()
    assert "| a | 50.0 % | 1.00 |" in text and "Commit abc" in text and "Quick sizes" in text
    assert str(tmp_path) not in text
    assert max(map(len, text.splitlines())) <= 120
    assert all(line == line.rstrip() for line in text.splitlines())


def test_wrong_answers_and_breakdowns_end_with_1(families, tmp_path, capsys):
    assert cli.main(["soundness", "--device", "cpu", "--out", str(tmp_path)]) == 1
    assert "bed sinks 2 cm into desk" in capsys.readouterr().out
    assert cli.main(["edits", "quality", "--device", "cpu", "--out", str(tmp_path)]) == 1
    assert json.loads((tmp_path / "edits.json").read_text())["failures"] == [
        "edits broke down: RuntimeError: no such kernel"
    ]
    assert (tmp_path / "quality.json").is_file()


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["speed"], 'family "speed" is unknown'),
        (["--rooms", "cellar"], 'room "cellar" is unknown'),
        (["--rivals", "nobody"], 'rival "nobody" is unknown'),
        (["--most", "0"], "--most: 0 is not at least 1"),
        (["--seed", "-1"], "--seed: -1 is not from 0"),
        (["--device", "abacus"], "abacus"),
    ],
)
def test_bad_input_ends_with_2(words, said, capsys):
    assert cli.main(words) == 2
    assert said in " ".join(capsys.readouterr().out.split())


def test_report_of_nothing_ends_with_2(tmp_path, capsys):
    assert cli.main(["report", "--from", str(tmp_path), "--to", str(tmp_path / "page.md")]) == 2
    assert "holds no results" in " ".join(capsys.readouterr().out.split())


def test_plots(tmp_path):
    pytest.importorskip("matplotlib")
    result = _result(None, None)
    result.plots.append(Plot("q", "Lines", "t", "time", ("share",), log=True))
    result.table("t").rows = [dict(ROWS[0])]
    assert [p.name for p in plots.draw(result, tmp_path)] == ["p.png", "q.png"]


def test_the_page_shows_some_plots(families, tmp_path, monkeypatch):
    pytest.importorskip("matplotlib")

    def shown(settings, judge) -> Result:
        result = _result(settings, judge)
        result.plots.append(Plot("curve", "A curve", "t", "time", ("share",), series="room", log_x=True, page=True))
        return result

    monkeypatch.setitem(families, "quality", shown)
    assert cli.main(["quality", "--device", "cpu", "--out", str(tmp_path / "out")]) == 0
    assert cli.main(["report", "--from", str(tmp_path / "out"), "--to", str(tmp_path / "docs" / "page.md")]) == 0
    assert "![Quality](images/curve-cpu.png)" in (tmp_path / "docs" / "page.md").read_text()
    assert [p.name for p in (tmp_path / "docs" / "images").iterdir()] == ["curve-cpu.png"]


def test_without_matplotlib_there_are_no_plots(tmp_path, monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "matplotlib", None)
    assert plots.draw(_result(None, None), tmp_path) is None


def test_a_failing_child_says_why():
    with pytest.raises(RuntimeError, match="nowhere"):
        children.run({"scenes": ["nowhere"], "candidates": 1, "seed": 0, "device": "cpu"})
