"""How kernels are written down: arguments in named blocks, what is written says so, no reverse mode."""

from __future__ import annotations

import ast
import re
from dataclasses import dataclass, field
from pathlib import Path

import pytest

import sceneweaver.kernels

FOLDER = Path(sceneweaver.kernels.__file__).parent
PICTURES = Path(sceneweaver.__file__).parent / "render"
FILES = [
    *sorted(p for p in FOLDER.glob("*.py") if p.name != "__init__.py"),
    *sorted((PICTURES / "tracing").glob("*_kernels.py")),
    *sorted((PICTURES.parent / "envs" / "batched").glob("*_kernels.py")),
]
BLOCKS = ("Problem", "State in", "State in and out", "State out")


def _dotted(node: ast.AST) -> str:
    return ast.unparse(node).split("(")[0]


def _root(node: ast.AST) -> str | None:
    """The name that a chain of subscripts and attributes begins with."""
    while isinstance(node, ast.Subscript | ast.Attribute):
        node = node.value
    return node.id if isinstance(node, ast.Name) else None


@dataclass
class Function:
    """A ``wp.func`` or ``wp.kernel``: its arguments, the block of each, and those that it writes to."""

    file: Path
    node: ast.FunctionDef
    kernel: bool
    options: dict[str, object]
    args: list[str] = field(default_factory=list)
    arrays: set[str] = field(default_factory=set)  # arguments that are arrays, or structs that may hold some
    blocks: dict[str, str | None] = field(default_factory=dict)
    order: list[str] = field(default_factory=list)
    written: set[str] = field(default_factory=set)

    @property
    def name(self) -> str:
        return f"{self.file.stem}.{self.node.name}"


def _read(file: Path, node: ast.FunctionDef, decorator: ast.expr, lines: list[str]) -> Function:
    options = {}
    if isinstance(decorator, ast.Call):
        options = {k.arg: getattr(k.value, "value", None) for k in decorator.keywords if k.arg}
    found = Function(file, node, _dotted(decorator).endswith("kernel"), options)
    block = None
    at = {a.lineno: a for a in node.args.args}
    for number in range(node.lineno, node.body[0].lineno):
        comment = re.match(r"\s*# (.+):$", lines[number - 1])
        if comment:
            block = comment[1]
            found.order.append(block)
        for arg in (a for line, a in at.items() if line == number):
            found.blocks[arg.arg] = block
    for arg in node.args.args:
        found.args.append(arg.arg)
        kind = _dotted(arg.annotation) if arg.annotation else ""
        if "array" in kind or not kind.startswith("wp."):
            found.arrays.add(arg.arg)
    return found


def functions() -> list[Function]:
    found = []
    for file in FILES:
        text = file.read_text()
        for node in ast.walk(ast.parse(text)):
            if isinstance(node, ast.FunctionDef):
                for decorator in node.decorator_list:
                    if _dotted(decorator) in ("wp.func", "wp.kernel"):
                        found.append(_read(file, node, decorator, text.splitlines()))
    return found


def _stores(function: Function) -> set[str]:
    """Arguments whose elements are stored to in the function itself."""
    names = set()
    for node in ast.walk(function.node):
        targets = getattr(node, "targets", [node.target] if isinstance(node, ast.AugAssign) else [])
        if isinstance(node, ast.Call) and _dotted(node.func).startswith("wp.atomic"):
            names.add(_root(node.args[0]))
        for target in targets:
            for part in target.elts if isinstance(target, ast.Tuple) else [target]:
                if isinstance(part, ast.Subscript):
                    names.add(_root(part))
    return names & function.arrays


def _through_calls(function: Function, known: dict[str, Function]) -> set[str]:
    """Arguments that are handed to a function which stores to them."""
    names = set()
    for node in ast.walk(function.node):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in known:
            callee = known[node.func.id]
            names |= {_root(arg) for arg, name in zip(node.args, callee.args, strict=False) if name in callee.written}
    return names & function.arrays


def analysed() -> list[Function]:
    found = functions()
    known = {f.node.name: f for f in found if not f.kernel}
    for f in found:
        f.written = _stores(f)
    changed = True
    while changed:
        changed = False
        for f in found:
            more = _through_calls(f, known) - f.written
            f.written |= more
            changed |= bool(more)
    return found


FUNCTIONS = analysed()
KERNELS = [f for f in FUNCTIONS if f.kernel]
each_kernel = pytest.mark.parametrize("kernel", KERNELS, ids=lambda k: k.name)


def test_kernels_are_found():
    expected = {
        "evaluator.evaluate",
        "verdict.judge_objects",
        "search.search",
        "descent.step",
        "view_kernels.light_pixels",
    }
    assert expected <= {k.name for k in KERNELS}
    mover = next(f for f in FUNCTIONS if f.node.name == "move_with_members")
    assert mover.written == {"s"}, "writing through a call and an attribute is seen"


@each_kernel
def test_arguments_stand_in_blocks(kernel):
    assert None not in kernel.blocks.values(), "an argument without a block"
    assert len(kernel.blocks) == len(kernel.args), "one argument a line"
    places = [BLOCKS.index(block) for block in kernel.order]
    assert places == sorted(set(places)), f"blocks are {', '.join(BLOCKS)}, in this order"


@each_kernel
def test_what_is_written_says_so(kernel):
    for arg in kernel.args:
        block, out = kernel.blocks[arg], arg.endswith("_out")
        assert out == (block == "State out"), f"{arg} stands under {block}"
        if arg in kernel.written:
            assert block in ("State out", "State in and out"), f"{arg} stands under {block} and is written"
        elif out:
            pytest.fail(f"{arg} is not written")


@each_kernel
def test_kernels_have_a_docstring(kernel):
    assert ast.get_docstring(kernel.node) or kernel.options.get("module") == "unique"


@pytest.mark.parametrize("file", FILES, ids=lambda f: f.stem)
def test_reverse_mode_is_off(file):
    mine = [f for f in FUNCTIONS if f.file == file]
    apart = [f for f in mine if f.options.get("module") == "unique"]
    assert all(f.options.get("enable_backward") is False for f in apart)
    at_top = [n for n in ast.parse(file.read_text()).body if isinstance(n, ast.FunctionDef | ast.ClassDef)]
    if any(_dotted(d).startswith("wp.") for n in at_top for d in n.decorator_list):
        source = file.read_text()
        assert 'wp.set_module_options({"enable_backward": False' in source
        assert source.index("wp.set_module_options") < source.index("\n@wp."), "set before the first function"
