"""`sceneweaver.envs` where there is no Gymnasium."""

from __future__ import annotations

import subprocess
import sys


def test_it_says_what_is_missing():
    code = "import sys; sys.modules['gymnasium'] = None\nimport sceneweaver.envs"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    assert (
        "MissingDependencyError: gymnasium is not installed (extra 'envs'); install it with: pip install 'gymnasium"
        in done.stderr
    )
