"""Who imports whom: the tables in CONTRIBUTING.md, the contracts that lint checks, and no circles."""

from __future__ import annotations

import re
import sys
import tomllib
from pathlib import Path

import grimp
import pytest

ROOT = Path(__file__).resolve().parents[1]
CONTRACTS = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["importlinter"]["contracts"]
NO_FLOORS = {"__init__", "__main__", "toolcards"}  # the public names, `python -m sceneweaver`, and a folder of data


def table(heading: str) -> list[list[str]]:
    """The cells of a table's rows in CONTRIBUTING.md, without backquotes."""
    lines = (ROOT / "CONTRIBUTING.md").read_text().splitlines()
    start = lines.index(heading) + 2
    end = next(i for i in range(start, len(lines)) if not lines[i].startswith("|"))
    return [[cell.strip().strip("`") for cell in line.strip("|").split("|")] for line in lines[start:end]]


def allowed_imports() -> dict[str, set[str]]:
    """What each floor may import by the table, lowest floor first."""
    allowed: dict[str, set[str]] = {}
    for floor, _, may_import in table("| floor | what it does | may import |"):
        all_but = re.fullmatch(r"all above but (.+)", may_import)
        names = set((all_but[1] if all_but else may_import).split(", ")) - {"-"}
        assert names <= set(allowed), f"{floor} may import {names - set(allowed)}, which stands below it in the table"
        allowed[floor] = set(allowed) - names if all_but else names
    return allowed


def protected(contract: dict) -> tuple[str, set[str]]:
    """The one module that a contract protects, and who may import it, without the name of the package."""
    (module,) = contract["protected_modules"]
    return module.removeprefix("sceneweaver."), {n.removeprefix("sceneweaver.") for n in contract["allowed_importers"]}


def circles(package: str, path: Path) -> dict[str, list[tuple[str, str]]]:
    """Per package the imports between its parts that go round; those inside functions and for types count."""
    sys.path.insert(0, str(path))
    try:
        graph = grimp.build_graph(package, cache_dir=None)
    finally:
        sys.path.remove(str(path))
    packages = [module for module in graph.modules if graph.find_children(module)]
    return {p: sorted(found) for p in packages if (found := graph.nominate_cycle_breakers(p))}


def test_every_floor_of_the_library_stands_in_the_table_once():
    there = {path.stem for path in (ROOT / "sceneweaver").iterdir() if path.suffix == ".py" or path.is_dir()}
    floors = [row[0] for row in table("| floor | what it does | may import |")]
    assert sorted(floors) == sorted(there - NO_FLOORS - {"__pycache__"})


def test_the_contracts_are_the_tables():
    allowed = allowed_imports()
    wanted = {floor: {other for other, names in allowed.items() if floor in names} for floor in allowed}
    wanted["cli"] = {"__main__"}
    wanted |= {library: set(names.split(", ")) for library, names in table("| library | who may import it |")}
    found = [protected(contract) for contract in CONTRACTS if contract["type"] == "protected"]
    assert dict(found) == wanted
    assert len(found) == len(wanted)


def test_no_contract_looks_away():
    for contract in CONTRACTS:
        if contract["type"] == "acyclic_siblings":
            assert contract.keys() == {"name", "type", "ancestors"} and contract["ancestors"] == ["sceneweaver"]
        else:
            assert contract["type"] == "protected"
            assert set(contract.get("ignore_imports", [])) <= {"sceneweaver -> sceneweaver.**"}  # the public names


def test_no_import_goes_round():
    assert circles("sceneweaver", ROOT) == {}


@pytest.mark.parametrize(
    "back",
    ["def f():\n    from . import a", "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from . import a"],
)
def test_a_circle_is_found_wherever_the_import_stands(tmp_path, back):
    package = tmp_path / "round_trip"
    package.mkdir()
    (package / "__init__.py").write_text("")
    (package / "a.py").write_text("from . import b\n")
    (package / "b.py").write_text(back + "\n")
    assert list(circles("round_trip", tmp_path)) == ["round_trip"]
