"""The examples of docs/building.md run, in their order."""

from __future__ import annotations

from typing import Any

from tests.test_repository import ROOT, code_blocks


def test_the_examples_run(capsys):
    names: dict[str, Any] = {"__name__": "__main__"}
    for number, block in enumerate(code_blocks((ROOT / "docs" / "building.md").read_text(), "python")):
        exec(compile(block, f"<example {number} in building.md>", "exec"), names)
    assert capsys.readouterr().out.split()[0] == "True"
