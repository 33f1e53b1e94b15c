"""`sceneweaver bench` from the command line."""

from __future__ import annotations

import json
import sys

import pytest

from sceneweaver.cli import main
from tests.kernels.harness import ZOO

ROOM = str(ZOO / "bedroom-small.json")
FEW = ["--problems", ROOM, "--seeds", "1", "--candidates", "4", "--seconds", "0.1", "--device", "cpu"]


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    out = tmp_path_factory.mktemp("bench")
    names = "adam,langevin,broken=tests.bench.optimizers:Failing"
    assert main(["bench", "run", "--optimizers", names, *FEW, "--no-isolate", "-o", str(out)]) == 0
    return out


@pytest.mark.slow
def test_results_are_compared(results, capsys):
    assert main(["bench", "compare", str(results), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert {line["method"] for line in found["methods"]} == {"adam", "langevin", "broken"}
    assert found["target"] == "50% of candidates valid" and found["settings"]["candidates"] == 4
    assert main(["bench", "compare", str(results / "results.parquet"), "--target", "objective:0.5"]) == 0
    text = capsys.readouterr().out
    assert "| adam |" in text and "broken: ZeroDivisionError: one over nothing (1 runs: bedroom-small)" in text


@pytest.mark.slow
def test_results_are_plotted(results, tmp_path):
    assert main(["bench", "plot", str(results), "-o", str(tmp_path), "--format", "svg"]) == 0
    paths = sorted(tmp_path.iterdir())
    assert [path.name for path in paths] == ["curves.svg", "profiles.svg"]
    assert all(path.read_bytes().startswith(b"<?xml") and path.stat().st_size > 10_000 for path in paths)


def test_a_process_of_its_own(tmp_path, capsys):
    assert main(["bench", "run", "--optimizers", "adam", *FEW, "-o", str(tmp_path), "--json"]) == 0
    (line,) = json.loads(capsys.readouterr().out)["methods"]
    assert line["method"] == "adam" and line["failed"] == 0


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["run", "--optimizers", "sgd", *FEW], "sgd"),
        (["run", "--optimizers", "adam", "--problems", "nowhere"], "nowhere"),
        (["run", "--optimizers", "adam", "--clock", "sun", *FEW], "clock"),
        (["run", "--optimizers", "adam", *FEW, "--seconds", "0"], "seconds"),
        (["plot", "nowhere"], "no results"),
    ],
)
def test_bad_input_ends_with_two(tmp_path, capsys, words, text):
    assert main(["bench", *words, "-o", str(tmp_path / "out")]) == 2
    assert text in capsys.readouterr().err


def test_bad_results_end_with_two(tmp_path, results, capsys):
    assert main(["bench", "compare", str(tmp_path)]) == 2
    assert main(["bench", "compare", str(results), "--target", "half"]) == 2
    assert main(["bench", "compare", str(results), "--family", "none"]) == 2
    assert "no results" in capsys.readouterr().err


def test_what_is_missing_ends_with_four(tmp_path, monkeypatch, capsys):
    monkeypatch.setitem(sys.modules, "pyarrow.parquet", None)
    assert main(["bench", "run", "--optimizers", "adam", *FEW, "-o", str(tmp_path)]) == 4
    said = capsys.readouterr().err.strip()
    assert said.startswith("sceneweaver: pyarrow is not installed (extra 'bench'); install it with: pip install ")
