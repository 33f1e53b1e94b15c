"""Meaning is read from typed fields: nobody takes sentences for people apart, or steers by free attributes."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
FOLDERS = ("sceneweaver", "kernels", "optimizers", "tools", "benchmarks")
PROSE = ("detail", "finished", "reason")
"""Fields that hold sentences: of a violation, of the end of a run, of a fault, a call or what was dropped."""
LOOKS = {"color", "material", "style", "label", "shape", "posture"}
"""Attributes that say how a thing looks or what it is called; all that code may read of them by name."""


def sources(words: Iterable[str]) -> Iterator[tuple[str, ast.AST]]:
    """Every source with one of these words in it, by name, as a tree; without the words there is nothing to find."""
    for folder in FOLDERS:
        for path in sorted((ROOT / folder).rglob("*.py")):
            text = path.read_text("utf-8")
            if any(word in text for word in words):
                yield path.relative_to(ROOT).as_posix(), ast.parse(text)


def is_prose(node: ast.expr) -> bool:
    """Whether an expression is such a field: ``x.detail``, ``x["detail"]`` or str() of them."""
    match node:
        case ast.Attribute(attr=name) | ast.Subscript(slice=ast.Constant(value=name)):
            return name in PROSE
        case ast.Call(func=ast.Name(id="str"), args=[inner]):
            return is_prose(inner)
    return False


def parsed_prose(tree: ast.AST) -> Iterator[int]:
    """Lines that take such a sentence apart: a method or slice of it, a search in it, a pattern on it."""
    for node in ast.walk(tree):
        match node:
            case ast.Attribute(value=inner) | ast.Subscript(value=inner) if is_prose(inner):
                yield node.lineno
            case ast.Compare(left=left, comparators=others) if any(map(is_prose, (left, *others))):
                yield node.lineno
            case ast.Call(func=ast.Attribute(value=ast.Name(id="re")), args=given) if any(map(is_prose, given)):
                yield node.lineno


def named_attributes(tree: ast.AST) -> Iterator[tuple[int, str]]:
    """Line and key of every attribute that is read by name."""
    for node in ast.walk(tree):
        match node:
            case (
                ast.Call(
                    func=ast.Attribute(value=ast.Attribute(attr="attributes"), attr="get" | "pop"),
                    args=[ast.Constant(value=str(key)), *_],
                )
                | ast.Subscript(value=ast.Attribute(attr="attributes"), slice=ast.Constant(value=str(key)))
                | ast.Compare(left=ast.Constant(value=str(key)), comparators=[ast.Attribute(attr="attributes")])
            ):
                yield node.lineno, key


@pytest.mark.parametrize(
    "code",
    [
        'v.detail.split(":")[0]',
        "v.detail.removeprefix(name).strip()",
        "v.detail[:4]",
        '"gap" in v.detail',
        're.search("gap", v.detail)',
        'row["detail"].partition(": ")',
        'str(row["detail"]).startswith("a")',
        'memory.finished.endswith(" steps")',
    ],
)
def test_the_rule_on_sentences_sees(code):
    assert list(parsed_prose(ast.parse(code)))


@pytest.mark.parametrize("code", ["print(v.detail)", 'f"{v.kind}: {v.detail}"', "if v.detail: pass", "Fault(v.detail)"])
def test_the_rule_on_sentences_lets_through(code):
    assert not list(parsed_prose(ast.parse(code)))


@pytest.mark.parametrize("code", ['o.attributes.get("need", 1)', 'o.attributes["need"]', '"need" in a.b.attributes'])
def test_the_rule_on_attributes_sees(code):
    assert [key for _, key in named_attributes(ast.parse(code))] == ["need"]


def test_nobody_parses_sentences():
    found = [f"{name}:{line}" for name, tree in sources(PROSE) for line in parsed_prose(tree)]
    assert not found, "read a typed field instead, as of Violation relation, zone and measurement"


def test_attributes_say_how_things_look_and_no_more():
    read = [(name, line, key) for name, tree in sources(["attributes"]) for line, key in named_attributes(tree)]
    assert {"color", "material"} <= {key for _, _, key in read}
    found = [f"{name}:{line} {key}" for name, line, key in read if key not in LOOKS]
    assert not found, "what steers belongs to Intent (sceneweaver/scene/intent.py)"
