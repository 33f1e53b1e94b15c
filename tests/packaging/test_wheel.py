"""The two archives hold the whole library as real files, and the wheel works away from the repository."""

import ensurepip
import json
import os
import stat
import subprocess
import sys
import sysconfig
import tarfile
import tomllib
import venv
import zipfile
from pathlib import Path

import pytest

pytestmark = pytest.mark.packaging

ROOT = Path(__file__).resolve().parents[2]
LINKED = ("kernels", "optimizers", "tools", "toolcards")
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
VERSION = PROJECT["version"]
STEM = f"{PROJECT['name'].replace('-', '_')}-{VERSION}"


def run(*command: object, cwd: Path, codes: tuple[int, ...] = (0,)) -> str:
    """Run a command without the variables that could lead it back to this checkout; returns what it printed."""
    env = {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "VIRTUAL_ENV"))}
    env |= {"PIP_NO_INDEX": "1", "PIP_CONFIG_FILE": os.devnull, "COLUMNS": "120"}
    result = subprocess.run(
        [str(part) for part in command], cwd=cwd, env=env, capture_output=True, text=True, timeout=120, check=False
    )
    assert result.returncode in codes, f"{command} ended with {result.returncode}\n{result.stdout}\n{result.stderr}"
    return result.stdout


def library_files() -> set[str]:
    """Every file of the library, links followed, as its path in the wheel."""
    found = set()
    for folder, folders, names in os.walk(ROOT / "sceneweaver", followlinks=True):
        folders[:] = [name for name in folders if name != "__pycache__"]
        inside = Path(folder).relative_to(ROOT)
        found |= {(inside / name).as_posix() for name in names if not name.endswith(".pyc")}
    return found


@pytest.fixture(scope="module")
def archives(tmp_path_factory):
    """Wheel and source archive, built from the checkout with the locked backend, so without the network."""
    out = tmp_path_factory.mktemp("dist")
    expected = library_files()
    run(sys.executable, "-m", "hatchling", "build", "-t", "sdist", "-t", "wheel", "-d", out, cwd=ROOT)
    return expected, out / f"{STEM}-py3-none-any.whl", out / f"{STEM}.tar.gz"


@pytest.fixture(scope="module")
def python(archives, tmp_path_factory):
    """An interpreter with the wheel installed and this environment's dependencies behind it."""
    home = tmp_path_factory.mktemp("clean")
    # The pip that Python would install there is run as it lies: to install and compile it takes as long as all else.
    bundled = sorted(Path(ensurepip.__file__).parent.glob("_bundled/pip-*.whl"))
    venv.create(home, with_pip=not bundled)
    interpreter = home / "bin" / "python"
    pip = [interpreter, bundled[-1] / "pip"] if bundled else [interpreter, "-m", "pip"]
    run(*pip, "install", "--quiet", "--no-deps", "--no-compile", archives[1], cwd=home)
    # Added after the install, so that pip does not see the editable install of this checkout; as an entry of a .pth
    # file the folder's own .pth files, such as the editable one, stay without effect.
    packages = Path(run(interpreter, "-c", "import sysconfig; print(sysconfig.get_path('purelib'))", cwd=home).strip())
    (packages / "outer.pth").write_text(sysconfig.get_path("purelib") + "\n")
    return interpreter


def test_wheel_holds_the_library_and_nothing_else(archives):
    expected, wheel, _ = archives
    with zipfile.ZipFile(wheel) as archive:
        names = set(archive.namelist())
        links = [info.filename for info in archive.infolist() if stat.S_ISLNK(info.external_attr >> 16)]
        entry_points = archive.read(f"{STEM}.dist-info/entry_points.txt").decode()
    assert {name.partition("/")[0] for name in names} == {"sceneweaver", f"{STEM}.dist-info"}
    assert {name for name in names if name.startswith("sceneweaver/")} == expected
    assert links == []
    assert "sceneweaver/py.typed" in names
    assert f"{STEM}.dist-info/licenses/LICENSE" in names
    assert "sceneweaver = sceneweaver.cli:main" in entry_points
    for folder in LINKED:
        assert any(name.startswith(f"sceneweaver/{folder}/") for name in names), folder


def test_source_archive_builds_the_same_wheel(archives, tmp_path):
    _, wheel, source = archives
    with tarfile.open(source) as archive:
        assert all(member.isfile() or member.isdir() for member in archive.getmembers())
        archive.extractall(tmp_path, filter="data")
    run(sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", tmp_path, cwd=tmp_path / STEM)
    with zipfile.ZipFile(wheel) as ours, zipfile.ZipFile(tmp_path / wheel.name) as theirs:
        assert {info.filename: info.CRC for info in ours.infolist()} == {
            info.filename: info.CRC for info in theirs.infolist()
        }


@pytest.mark.slow  # that all modules are in it is quick to see; that they can be imported, the other tests show
def test_every_module_imports_away_from_the_repository(python, tmp_path):
    program = (
        "import importlib, pkgutil, sceneweaver\n"
        "for module in pkgutil.walk_packages(sceneweaver.__path__, 'sceneweaver.'):\n"
        "    # operators of PyTorch, which the wheel does not bring, are imported by who uses them\n"
        "    if not module.name.endswith(('.__main__', '.torch.operators')):\n"
        "        importlib.import_module(module.name)\n"
        "print(sceneweaver.__file__)"
    )
    place = Path(run(python, "-c", program, cwd=tmp_path).splitlines()[-1])
    assert place.is_relative_to(python.parents[1])


def test_wheel_brings_nothing_generic(python, tmp_path):
    program = f"import importlib.util as u; print([n for n in {LINKED} if u.find_spec(n) is not None])"
    assert run(python, "-c", program, cwd=tmp_path).strip() == "[]"


def test_wheel_brings_the_command(python, tmp_path):
    printed = run(python.with_name("sceneweaver"), "--help", cwd=tmp_path)
    assert "refine" in printed
    assert "check" in printed


def test_command_judges_a_scene_away_from_the_repository(python, tmp_path):
    # 3: judged, and found not valid. Here it only counts that nothing is missing.
    command = python.with_name("sceneweaver"), "check", ROOT / "tests/zoo/bedroom.json", "--json"
    judged = json.loads(run(*command, cwd=tmp_path, codes=(0, 3)))
    assert judged["schema"] == "sceneweaver.metrics/1"
    assert judged["placed"] == len(json.loads((ROOT / "tests/zoo/bedroom.json").read_text())["objects"])


def test_a_missing_extra_is_named_with_what_the_wheel_asks_for(python, tmp_path):
    program = "from sceneweaver.runtime.package import missing_extra; print(missing_extra('envs', 'no gymnasium'))"
    wanted = PROJECT["optional-dependencies"]["envs"][0]
    assert run(python, "-c", program, cwd=tmp_path).strip() == (
        f"no gymnasium (extra 'envs'); install it with: pip install '{wanted}' (in a clone: make install)"
    )
