"""Damaged files of every kind end as they should, and the fuzzer that says so sees what is wrong."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from random import Random

import pytest

from tests.io import mutations

ROOT = Path(__file__).resolve().parents[2]


def fuzzed(*options: str) -> subprocess.CompletedProcess[str]:
    """The program in a process of its own: it forks, which the process of the tests should not."""
    command = [sys.executable, "-m", "tests.io.mutated_files", *options]
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)


def test_damaged_files_of_cheap_kinds_end_as_they_should():
    cheap = "records,spec,gltf,manifest,objathor,textures,results,card,library,bank,store"
    done = fuzzed("--count", "22", "--seed", "1", "--kinds", cheap)
    assert done.returncode == 0, done.stdout + done.stderr
    assert done.stdout.splitlines()[-2].split()[-1] == "22"


@pytest.mark.slow
def test_2000_damaged_files_of_all_kinds_end_as_they_should():
    done = fuzzed("--count", "2000", "--seed", "2", "--jobs", "2")
    assert done.returncode == 0, done.stdout + done.stderr


def test_equal_seeds_damage_alike(tmp_path):
    data = {"objects": [{"id": "a", "size": [1, 2, 3]}, {"id": "b"}], "schema": "x"}
    said = []
    for folder in (tmp_path / "a", tmp_path / "b"):
        folder.mkdir()
        for number in range(40):
            file = folder / f"{number}.json"
            file.write_text(json.dumps(data))
            way = mutations.mutate(file, Random(f"7/{number}"), tmp_path)
            said.append((number, way, file.read_bytes() if file.is_file() and way != "file: unreadable" else b""))
    assert said[:40] == said[40:]
    assert len({way for _, way, _ in said}) > 15


SINS = {
    "exit 1": "code = 1",
    "Traceback": "raise RuntimeError",
    "exit 2 without": "code = 2",
    "changed: outside/known.txt": "from pathlib import Path; Path('outside/known.txt').write_text('mine')",
    "changed: outside/new.txt": "from pathlib import Path; Path('outside/new.txt').write_text('mine')",
    "changed: in/a.json": "from pathlib import Path; Path('in/a.json').unlink()",
    "left: out/.sceneweaver-1": "from pathlib import Path; Path('out/.sceneweaver-1').touch()",
    "left: tmp/x": "from pathlib import Path; Path('tmp/x').touch()",
    "took": "import time; time.sleep(3)",
    "memory": "x = b'1' * (1 << 28)",
    "no terminal": "import sys; sys.stderr.write('\\x1b[2J')",
    "": "pass",
}
"""What the fuzzer has to call a fault, and programs that do it."""

DRIVER = """
import json, sys
from tests.io import mutated_files, specimens
mutated_files._import = lambda: None
mutated_files.MEMORY = 1 << 28
mutated_files.mutate = lambda *_: ""
def called(argv):
    said = {"code": 0}
    exec(program, said)
    return said["code"]
mutated_files._called = called
specimens.KINDS.clear()
specimens.KINDS["sin"] = specimens.Kind(
    lambda folder: (folder / "a.json").write_text("[1]"), ("*.json",), (specimens.Call("@sin {in}", 0.5),)
)
found = {}
for sin, program in json.loads(sys.argv[1]).items():
    failures = mutated_files.fuzz(1, 1, 1, ["sin"]).failures
    found[sin] = [fault for _, result in failures for fault in result.faults]
print(json.dumps(found))
"""


def test_what_is_wrong_is_seen():
    given = [sys.executable, "-c", DRIVER, json.dumps(SINS)]
    done = subprocess.run(given, cwd=ROOT, capture_output=True, text=True, check=True)
    found = json.loads(done.stdout)
    assert found.pop("") == []
    assert [sin for sin, faults in found.items() if not any(sin in fault for fault in faults)] == []
