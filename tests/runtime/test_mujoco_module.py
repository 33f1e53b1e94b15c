"""MuJoCo warns in the log, and writes nothing where somebody works."""

from __future__ import annotations

import logging
import re
from pathlib import Path

from sceneweaver.runtime.mujoco_module import load_mujoco

ROOT = Path(__file__).resolve().parents[2]
BALL = '<mujoco><worldbody><body><freejoint/><geom size="1"/></body></worldbody></mujoco>'


def test_a_warning_is_a_line_of_the_log_and_no_file(tmp_path, monkeypatch, caplog, capfd):
    monkeypatch.chdir(tmp_path)
    mujoco = load_mujoco()
    model = mujoco.MjModel.from_xml_string(BALL)
    data = mujoco.MjData(model)
    data.qpos[0] = float("nan")
    with caplog.at_level(logging.INFO, "sceneweaver"):
        mujoco.mj_step(model, data)
    assert "MuJoCo: Nan, Inf or huge value in QPOS" in caplog.text
    assert not list(tmp_path.iterdir())
    assert capfd.readouterr().err == ""


def test_nothing_else_loads_it():
    sources = {path: path.read_text() for path in (ROOT / "sceneweaver").rglob("*.py")}
    found = [
        path.name
        for path, text in sources.items()
        if re.search(r'import_module\("mujoco"\)|^\s*import mujoco$', text, re.M)
    ]
    assert found == ["mujoco_module.py"]
