"""A user's program that is typed strictly passes pyright without a word."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.test_repository import ROOT


@pytest.mark.slow
def test_pyright_is_content_in_strict_mode(tmp_path):
    pyright = Path(sys.executable).parent / "pyright"
    if not pyright.exists():
        pytest.skip("pyright is not installed")
    shutil.copy(ROOT / "tests" / "clients" / "typed_user.py", tmp_path / "program.py")
    settings = {"include": ["program.py"], "typeCheckingMode": "strict", "extraPaths": [str(ROOT)]}
    (tmp_path / "pyrightconfig.json").write_text(json.dumps(settings))
    command = [str(pyright), "-p", str(tmp_path), "--pythonpath", sys.executable]
    run = subprocess.run(command, capture_output=True, text=True, timeout=300, check=False)
    assert run.returncode == 0, run.stdout
    assert "0 errors, 0 warnings" in run.stdout
