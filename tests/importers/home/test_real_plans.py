"""Plans of a folder against a profile of rules: what is counted, what is left out."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from benchmarks import real_plans
from sceneweaver.plans import Profile
from sceneweaver.scene import InputError
from tests.importers.home.plans import file_of


def test_plans_by_source(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for name in ("resplan", "rplan"):
        (tmp_path / "plans" / name).mkdir(parents=True)
        file_of(name, tmp_path / "plans" / name)
    (tmp_path / "plans" / "rplan" / "source.yaml").write_text("not_judged:\n  shared-toilet: there is none\n")
    (tmp_path / "plans" / "rplan" / "broken.svg").write_text("<svg/>")
    report = tmp_path / "out.json"
    assert real_plans.main(["--plans", str(tmp_path / "plans"), "--json", str(report)]) == 0
    resplan, rplan = json.loads(report.read_text())
    assert set(resplan["plans"][0]["broken"]) >= {"shared-toilet"} and not resplan["left_out"]
    assert {"shared-toilet", "daylight"} <= set(rplan["left_out"]) and len(rplan["refused"]) == 1
    assert not {"shared-toilet", "daylight", "glazing"} & set(rplan["plans"][0]["broken"])
    said = capsys.readouterr().out
    assert "| resplan | 1 | 0 | 1 | 0 | 0.0 % |" in said


def test_a_plan_without_a_door_to_each_room_is_not_whole(tmp_path: Path) -> None:
    file = file_of("resplan", tmp_path)
    data = json.loads(file.read_text())
    del data["door"]
    file.write_text(json.dumps(data))
    found = real_plans.judge(tmp_path, Profile.named("base"), None, False)
    assert [plan.whole for plan in found.plans] == [False]


def test_no_folder() -> None:
    with pytest.raises(InputError, match="--plans: "):
        real_plans.main(["--plans", "/nowhere"])
