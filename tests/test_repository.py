"""The repository itself: links, lock file, texts and targets fit together."""

import importlib.metadata
import os
import re
import shutil
import subprocess
import tomllib
from functools import partial
from pathlib import Path

import pytest

import sceneweaver
from tests.conftest import FIRST

ROOT = Path(__file__).resolve().parents[1]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())
LOCKED = {package["name"]: package for package in tomllib.loads((ROOT / "uv.lock").read_text())["package"]}
TEXTS = ("README.md", "CONTRIBUTING.md", "CHANGELOG.md", "docs/README.md")

# Files that come from elsewhere or that nobody writes by hand.
FOLDED = (".py", ".json", ".ipynb", ".svg", ".requests")  # ruff measures .py; a request is a line
MADE = "docs/datasets_10k/"  # what commands wrote, as they wrote it
NOT_OURS = ("uv.lock", "LICENSE", "tests/oracle/", "tests/zoo/")


def tracked_files() -> list[Path]:
    """Files that are or would be under version control."""
    if not (ROOT / ".git").exists() or shutil.which("git") is None:
        pytest.skip("not a git checkout")
    command = ["git", "ls-files", "--cached", "--others", "--exclude-standard", "-z"]
    names = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout.split("\0")
    return [ROOT / name for name in names if name and (ROOT / name).is_file()]


def our_texts() -> list[tuple[str, str]]:
    """Name and content of every text file that we write ourselves."""
    found = []
    for path in tracked_files():
        name = path.relative_to(ROOT).as_posix()
        if name.startswith(NOT_OURS):
            continue
        try:
            found.append((name, path.read_text(encoding="utf-8")))
        except UnicodeDecodeError:
            continue
    return found


def requirement_name(requirement: str) -> str:
    """Normalised name of a requirement such as ``Foo_Bar[extra]>=1``."""
    return re.sub(r"[-_.]+", "-", re.split(r"[\s\[<>=!~;]", requirement, maxsplit=1)[0]).lower()


def group(name: str) -> list[str]:
    """The requirements of a dependency group, with those of the groups that it includes."""
    entries = PROJECT["dependency-groups"][name]
    return [text for e in entries for text in ([e] if isinstance(e, str) else group(e["include-group"]))]


def code_blocks(text: str, language: str) -> list[str]:
    """Content of the fenced blocks of one language."""
    return re.findall(rf"^```{language}\n(.*?)^```", text, re.DOTALL | re.MULTILINE)


@pytest.mark.parametrize("name", ["kernels", "optimizers", "tools", "toolcards"])
def test_package_links_to_top_level_folder(name):
    link = ROOT / "sceneweaver" / name
    assert link.is_symlink()
    assert os.readlink(link) == f"../{name}"
    assert any((ROOT / name).iterdir()), "git keeps no empty folder, and the link would dangle in a clone"


def test_lock_file_covers_every_dependency():
    extras = [text for extra in PROJECT["project"]["optional-dependencies"].values() for text in extra]
    wanted = PROJECT["project"]["dependencies"] + extras + group("dev")
    assert {requirement_name(requirement) for requirement in wanted} <= set(LOCKED)
    metadata = LOCKED[PROJECT["project"]["name"]]["metadata"]
    listed = {(entry["name"], entry.get("specifier", "")) for entry in metadata["requires-dist"]}
    listed |= {(entry["name"], entry.get("specifier", "")) for entry in metadata["requires-dev"]["dev"]}
    expected = {(requirement_name(text), re.sub(r"^[\w.-]+(\[[\w,-]+\])?", "", text)) for text in wanted}
    assert listed == expected, "pyproject.toml has changed: run `.uv/bin/uv lock`"


def test_lock_file_uses_the_standard_index_only():
    sources = {key: value for package in LOCKED.values() for key, value in package["source"].items()}
    assert sources == {"registry": "https://pypi.org/simple", "editable": "."}


def test_warp_is_pinned():
    pins = [text for text in PROJECT["project"]["dependencies"] if requirement_name(text) == "warp-lang"]
    assert pins == [f"warp-lang=={LOCKED['warp-lang']['version']}"]


def test_version_is_the_same_everywhere():
    version = PROJECT["project"]["version"]
    assert LOCKED[PROJECT["project"]["name"]]["version"] == version
    assert importlib.metadata.version(PROJECT["project"]["name"]) == version
    assert version in (ROOT / "CHANGELOG.md").read_text()


def test_texts_are_tidy():
    private = re.compile(r"(?<![\w.])/(?:home|root|Users|work)/\w")
    untidy = []
    for name, text in our_texts():
        for number, line in enumerate(text.splitlines(), 1):
            if len(line) > 120 and not name.endswith(FOLDED) and not name.startswith(MADE):
                untidy.append(f"{name}:{number}: {len(line)} characters")
            if line != line.rstrip() and name.endswith((".py", ".md", ".toml", ".yaml", "Makefile")):
                untidy.append(f"{name}:{number}: blanks at the end")
            if private.search(line):
                untidy.append(f"{name}:{number}: a path that exists on one machine only")
    assert untidy == []


def test_links_between_texts_lead_somewhere():
    texts = [ROOT / name for name in TEXTS] + sorted((ROOT / "docs").rglob("*.md"))
    broken = [
        f"{path.relative_to(ROOT)}: {target}"
        for path in texts
        for target in re.findall(r"\]\(([^)#]+)", path.read_text())
        if "://" not in target and not (path.parent / target).exists()
    ]
    assert broken == []


def test_every_decision_is_listed():
    index = (ROOT / "docs" / "README.md").read_text()
    assert [path.name for path in (ROOT / "docs" / "decisions").glob("*.md") if path.name not in index] == []


def test_make_targets_exist_and_are_explained():
    makefile = (ROOT / "Makefile").read_text()
    explained = set(re.findall(r"^([a-z]+):.*## ", makefile, re.MULTILINE))
    phony = re.search(r"^\.PHONY: (.*)$", makefile, re.MULTILINE)
    assert phony is not None and set(phony.group(1).split()) == explained
    assert {"demo", "test", "bench", "lint", "build", "clean", "help"} <= explained
    mentioned = {
        target
        for name in TEXTS
        for target in re.findall(r"(?:^|`)make ([a-z]+)", (ROOT / name).read_text(), re.MULTILINE)
    }
    assert mentioned <= explained


def test_ci_script_can_be_run():
    assert os.access(ROOT / ".ci" / "run", os.X_OK)


@pytest.mark.parametrize("number", range(len(code_blocks((ROOT / "README.md").read_text(), "python"))))
def test_readme_example_runs(number, tmp_path, monkeypatch):
    source = code_blocks((ROOT / "README.md").read_text(), "python")[number]
    shutil.copy(ROOT / "tests" / "zoo" / "bedroom.json", tmp_path / "scene.json")
    monkeypatch.chdir(tmp_path)
    # As it stands there, but for how long it searches.
    quick = {"candidates": 8, "finalists": 2, "generations": 0, "side_by_side": 1}
    monkeypatch.setattr("sceneweaver.design", partial(sceneweaver.design, **quick))
    exec(compile(source, "<example in README.md>", "exec"), {"__name__": "readme"})
    assert (tmp_path / "refined.json").is_file() or ".save(" not in source


def test_nothing_tells_to_install_the_package_of_another():
    """PyPI has another project of the module's name; only a wheel, a file, may be named together with an extra."""
    fetched = r"(?:pip install|uv add|uvx|pipx \w+)\s+(?:-\S+\s+)*[\\'\"]*sceneweaver(?![\w-])"
    wrong = re.compile(fetched + r"|sceneweaver\\*\[(?:[a-z]+[,\\\]])+")
    kinds = (".py", ".md", ".ipynb", ".yaml", ".yml", ".toml", ".j2", ".html", ".txt", "Makefile")
    found = [
        f"{name}:{number}: {line.strip()[:100]}"
        for name, text in our_texts()
        if name.endswith(kinds) and name != "tests/test_repository.py"
        for number, line in enumerate(text.splitlines(), 1)
        if wrong.search(line[:100_000])
    ]
    assert found == []


def test_files_that_begin_first_are_there():
    assert [name for name in FIRST if not (ROOT / "tests" / name).is_file()] == []
