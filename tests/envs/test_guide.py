"""The code of docs/environments.md runs."""

from __future__ import annotations

import pytest

from tests.test_repository import ROOT, code_blocks


@pytest.mark.slow
def test_the_guide_runs(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    names: dict = {"__name__": "__main__"}
    for source in code_blocks((ROOT / "docs" / "environments.md").read_text(), "python"):
        exec(compile(source, "docs/environments.md", "exec", dont_inherit=True), names)
    assert names["info"]["instruction"] == "go to the bed" and names["info"]["layout"] == 5
