"""Damage to files, as accident and malice do it: bytes, values, members of archives, and what is no file at all.

Everything is drawn from the ``random.Random`` that is given, so a case can be made again.
"""

from __future__ import annotations

import contextlib
import io
import json
import os
import re
import shutil
import tarfile
import warnings
import zipfile
from collections.abc import Callable
from pathlib import Path
from random import Random
from typing import Any
from xml.etree import ElementTree

DEEP = 50_000
LEAST_TIMES = 2
MOST_BYTES = 8 << 20
"""A file that damage has made is at most so large [bytes]."""

ODD_NUMBERS = ("1e308", "-1e308", "1e-320", "-1", "0", "NaN", "Infinity", "-Infinity", "1" * 5000, "-0.0", "4294967296")
"""Numbers as texts: JSON of Python would not write all of them."""

OUTSIDE = ("../../outside/known.txt", "../outside/known.txt", "/etc/passwd")
ODD_NAMES = (*OUTSIDE, "a\x00b", "..", ".", "", "CON", "x" * 300)

ODD_TEXTS = (
    *ODD_NAMES,
    "x" * 100_000,
    "\x1b[2J\x07\r\n\x7f",
    "\ud83d\udca9 \u202e\u200b\ufeff",
    "<script>alert(1)</script>",
    "%s%n{0}{x!r}",
    "-" * 40,
)

ODD_VALUES = (
    *ODD_NUMBERS,
    "null",
    "true",
    "[]",
    "{}",
    "[[]]",
    "[" * DEEP + "]" * DEEP,
    '{"a":' * DEEP + "1" + "}" * DEEP,
    "[" + "0," * 99_999 + "0]",
    "[" + "[0, 0, 0]," * 9_999 + "[0, 0, 0]]",
    '{"a": 1, "a": 2}',
    *(json.dumps(text) for text in ODD_TEXTS),
)
"""Values as JSON texts."""


def mutate(path: Path, random: Random, outside: Path) -> str:
    """Damage one file, and say how in a few words."""
    ways = [_structure, _structure, _bytes, _bytes, _bytes, _no_file]
    for _ in range(8):
        said = random.choice(ways)(path, random, outside)
        if said:
            return said
    return "as it was"


def _bytes(path: Path, random: Random, outside: Path) -> str:
    data = bytearray(path.read_bytes())
    if not data:
        return ""
    names = []
    for _ in range(random.choice((1, 1, 1, 2, 5))):
        at = random.randrange(len(data) or 1)
        size = min(random.choice((1, 1, 2, 4, 16, 256, 4096)), max(1, len(data) - at))
        way = random.choice(("flip", "set", "delete", "insert", "repeat", "cut", "splice", "zeros"))
        if way == "flip" and data:
            data[at] ^= 1 << random.randrange(8)
        elif way == "set" and data:
            data[at] = random.choice((0, 9, 10, 34, 45, 91, 123, 127, 128, 255))
        elif way == "delete":
            del data[at : at + size]
        elif way == "insert":
            data[at:at] = random.randbytes(size)
        elif way == "repeat":
            times = min(random.choice((LEAST_TIMES, 10, 1000)), max(1, MOST_BYTES // size))
            data[at:at] = data[at : at + size] * times
        elif way == "cut":
            del data[at:]
        elif way == "splice":
            data[at:] = data[random.randrange(len(data) or 1) :]
        else:
            data[at : at + size] = bytes(size)
        names.append(way)
    path.write_bytes(data)
    return f"bytes: {' '.join(names)}"


def _no_file(path: Path, random: Random, outside: Path) -> str:
    """What stands there instead of a regular file."""
    way = random.choice(("fifo", "zero", "folder", "link", "dangling", "loop", "empty", "missing", "unreadable"))
    if way == "unreadable":
        path.chmod(0)
        return "file: unreadable"
    path.unlink()
    if way == "fifo":
        os.mkfifo(path)
    elif way == "zero":
        path.symlink_to("/dev/zero")
    elif way == "folder":
        path.mkdir()
    elif way == "link":
        path.symlink_to(outside / "known.txt")
    elif way == "dangling":
        path.symlink_to(outside / "new.txt")
    elif way == "loop":
        path.symlink_to(path.name)
    elif way == "empty":
        path.touch()
    return f"file: {way}"


def _structure(path: Path, random: Random, outside: Path) -> str:
    """Damage that keeps the form of the file."""
    way = _FORMS.get(path.suffix.lower())
    if way is None:
        return ""
    try:
        return way(path, random)
    except Exception:  # it was damaged before, by another step, so its reader fails in any way
        return ""


def _json(path: Path, random: Random) -> str:
    data = json.loads(path.read_bytes())
    said, text = mutated_json(data, random)
    path.write_bytes(text)
    return said


def mutated_json(data: Any, random: Random) -> tuple[str, bytes]:
    """Data with one to three odd places, as JSON text, and what was done."""
    raw: dict[str, str] = {}
    holder = [data]
    said = [_one_place(holder, random, raw) for _ in range(random.choice((1, 1, 1, 2, 3)))]
    text = json.dumps(holder[0], indent=random.choice((None, 1)))
    for mark, value in raw.items():
        text = text.replace(f'"{mark}"', value)
    return f"values: {' '.join(said)}", text.encode("utf-8", "surrogatepass")[:MOST_BYTES]


def _one_place(holder: list[Any], random: Random, raw: dict[str, str]) -> str:
    """Change a random place of the data in it."""
    box, key = random.choice(_places(holder))
    value = box[key]
    ways = ["odd", "odd", "odd", "delete", "swap"]
    if isinstance(box, dict):
        ways += ["rename", "add"]
    if isinstance(box, list) and box is not holder:
        ways += ["repeat", "shuffle"]
    if isinstance(value, int | float) and not isinstance(value, bool):
        ways += ["near", "near"]
    way = random.choice(ways)
    if way == "delete" and box is not holder:
        del box[key]
    elif way == "rename":
        box[random.choice((*map(str, box), *ODD_NAMES))] = box.pop(key)
    elif way == "add":
        box[random.choice(("schema", "id", "name", "extra", *ODD_NAMES))] = value
    elif way == "repeat":
        box[key : key + 1] = [value] * min(1000, MOST_BYTES // max(1, len(json.dumps(value))))
    elif way == "shuffle":
        random.shuffle(box)
    elif way == "near":
        box[key] = value * random.choice((-1, 0.001, 10, 1000, 1e9)) + random.choice((0, 0, 1))
    elif way == "swap":
        box[key] = random.choice(_places(holder))[0] if random.random() < 0.5 else _other(holder, random)
        with contextlib.suppress(ValueError):
            json.dumps(holder[0])  # a value within itself is no JSON
            return way
        box[key] = value
    else:
        mark = f"@@{len(raw)}@@"
        raw[mark] = random.choice(ODD_VALUES)
        box[key] = mark
    return way


def _other(holder: list[Any], random: Random) -> Any:
    box, key = random.choice(_places(holder))
    return box[key]


def _places(holder: list[Any]) -> list[tuple[Any, Any]]:
    """All places of the data: the list or object, and the index or key in it."""
    found: list[tuple[Any, Any]] = []
    todo: list[Any] = [holder]
    while todo and len(found) < 20_000:
        box = todo.pop()
        for key in list(box) if isinstance(box, dict) else range(len(box)):
            found.append((box, key))
            if isinstance(box[key], dict | list):
                todo.append(box[key])
    return found


def _yaml(path: Path, random: Random) -> str:
    import yaml

    said, text = mutated_json(yaml.safe_load(path.read_bytes()), random)  # JSON is YAML
    if random.random() < 0.3:
        odd = b"x: &a [1, 2]\n", b"x: !!python/object/apply:os.system ['true']\n", b"d: 2001-99-99\n", b"--- \n---\n"
        text = random.choice(odd) + path.read_bytes()
        said = "yaml: anchors, tags, dates"
    path.write_bytes(text)
    return said


def _xml(path: Path, random: Random) -> str:
    root = ElementTree.parse(path).getroot()
    said = []
    for _ in range(random.choice((1, 1, 2, 4))):
        nodes = list(root.iter())
        node = random.choice(nodes)
        way = random.choice(("value", "value", "value", "delete", "repeat", "deep", "tag", "include"))
        if way == "value" and node.attrib:
            node.set(random.choice(list(node.attrib)), _xml_text(random))
        elif way == "delete" and len(node):
            node.remove(random.choice(list(node)))
        elif way == "repeat" and len(node):
            node.extend([random.choice(list(node))] * random.choice((2, 1000)))
        elif way == "deep":
            for _ in range(random.choice((250, 5000))):
                node = ElementTree.SubElement(node, "body")
        elif way == "tag":
            node.tag = random.choice(nodes).tag
        else:
            ElementTree.SubElement(root, "include", file=_xml_text(random))
        said.append(way)
    deepest = 6000
    text = _xml_of(root, deepest)
    if random.random() < 0.15:
        text = '<!DOCTYPE a [<!ENTITY b SYSTEM "file:///etc/passwd"><!ENTITY c "&b;&b;">]>' + text
        said.append("entity")
    path.write_text(text, encoding="utf-8", errors="replace")
    return f"xml: {' '.join(said)}"


def _xml_of(root: ElementTree.Element, deepest: int) -> str:
    """XML text without recursion, which Python bounds."""
    parts: list[str] = []
    todo: list[Any] = [root]
    while todo and len(parts) < 400_000:
        node = todo.pop()
        if isinstance(node, str):
            parts.append(node)
            continue
        values = "".join(
            f' {key}="' + "".join(c if c.isalnum() or c in " ./_-" else f"&#{ord(c)};" for c in value) + '"'
            for key, value in node.attrib.items()
        )
        parts.append(f"<{node.tag}{values}>")
        todo.append(f"</{node.tag}>")
        todo.extend(reversed(list(node)))
    return "".join(parts)[:MOST_BYTES]


def _xml_text(random: Random) -> str:
    return random.choice((*ODD_NUMBERS, *(t for t in ODD_TEXTS if t.isprintable()), "0 0 0", "1 2", "1e999 0 0"))


_NUMBER = re.compile(rb"-?\d+(\.\d+)?(e-?\d+)?")


def _lines(path: Path, random: Random) -> str:
    """Numbers, words and lines of a text: OBJ, MTL, STL, PLY, OFF, USD, CSV, checksums."""
    data = path.read_bytes()
    said = []
    for _ in range(random.choice((1, 1, 2, 5))):
        rows = data.split(b"\n")
        at = random.randrange(len(rows))
        way = random.choice(("number", "number", "number", "word", "delete", "repeat", "swap"))
        if way == "number" and (found := list(_NUMBER.finditer(data))):
            one = random.choice(found)
            data = data[: one.start()] + random.choice(ODD_NUMBERS).encode() + data[one.end() :]
        elif way == "word":
            words = rows[at].split(b" ")
            words[random.randrange(len(words))] = random.choice(ODD_TEXTS).encode("utf-8", "surrogatepass")
            rows[at] = b" ".join(words)
        elif way == "delete":
            del rows[at]
        elif way == "repeat":
            rows[at:at] = [rows[at]] * min(random.choice((2, 1000, 100_000)), MOST_BYTES // (len(rows[at]) + 1))
        else:
            other = random.randrange(len(rows))
            rows[at], rows[other] = rows[other], rows[at]
        if way != "number":
            data = b"\n".join(rows)
        said.append(way)
    path.write_bytes(data[:MOST_BYTES])
    return f"lines: {' '.join(said)}"


def _glb(path: Path, random: Random) -> str:
    """The JSON of a GLB file; its other parts follow as they were."""
    data = path.read_bytes()
    size = int.from_bytes(data[12:16], "little")
    if data[:4] != b"glTF" or data[16:20] != b"JSON":
        return ""
    document = json.loads(data[20 : 20 + size])
    if random.random() < 0.15:
        chain = random.choice((200, 2_000, 20_000))
        document["nodes"] += [{"children": [len(document["nodes"]) + k + 1]} for k in range(chain)] + [{"mesh": 0}]
        said, text = f"chain of {chain}", json.dumps(document).encode()
    else:
        said, text = mutated_json(document, random)
    text += b" " * (-len(text) % 4)
    rest = data[20 + size :]
    head = b"glTF" + (2).to_bytes(4, "little") + (20 + len(text) + len(rest)).to_bytes(4, "little")
    path.write_bytes(head + len(text).to_bytes(4, "little") + b"JSON" + text + rest)
    return f"glb {said}"


def _zip(path: Path, random: Random) -> str:
    """Members of a zip or npz: their names, contents, kinds and sizes."""
    with zipfile.ZipFile(path) as old:
        members = [(entry.filename, old.read(entry)) for entry in old.infolist()]
    at = random.randrange(len(members))
    name, content = members[at]
    way = random.choice(("name", "damage", "damage", "header", "drop", "twice", "link", "bomb"))
    extra = zipfile.ZipInfo(name)
    if way == "name":
        members[at] = (random.choice(ODD_NAMES).replace("\x00", "") or "x", content)
    elif way == "damage":
        members[at] = (name, _damaged(content, random))
    elif way == "header":
        odd = b"9", b"0", b"-1", b"99999999999"
        members[at] = (name, _NUMBER.sub(lambda _: random.choice(odd), content, count=3))
    elif way == "drop":
        del members[at]
    elif way == "twice":
        members.append(members[at])
    elif way == "link":
        extra.external_attr = 0o120777 << 16
        members.append((name + "-link", b"../../outside/known.txt"))
    else:
        members[at] = (name, content[:128] + bytes(64 << 20))
    with zipfile.ZipFile(path, "w", random.choice((zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED))) as new:
        for member, data in members:
            info = zipfile.ZipInfo(member)
            info.compress_type = zipfile.ZIP_DEFLATED if way == "bomb" else new.compression
            info.external_attr = extra.external_attr
            with warnings.catch_warnings(action="ignore"):  # of a name that stands there twice
                new.writestr(info, data)
    return f"zip: {way}"


def _damaged(content: bytes, random: Random) -> bytes:
    if not content:
        return content
    at = random.randrange(len(content))
    return random.choice((content[:at], content[:at] + b"\xff" + content[at + 1 :], content[:at] + content, b""))


def _tar(path: Path, random: Random) -> str:
    """Members of a tar: their names, kinds and contents."""
    with tarfile.open(path, "r:") as old:
        members = [(entry, (file := old.extractfile(entry)) and file.read() or b"") for entry in old.getmembers()]
    at = random.randrange(len(members))
    entry, content = members[at]
    way = random.choice(("name", "kind", "damage", "values", "drop", "twice", "order"))
    if way == "name":
        entry.name = random.choice(ODD_NAMES).replace("\x00", "") or "x"
    elif way == "kind":
        odd = tarfile.SYMTYPE, tarfile.LNKTYPE, tarfile.FIFOTYPE, tarfile.CHRTYPE, tarfile.DIRTYPE
        entry.type = random.choice(odd)
        entry.linkname, content = "../../outside/known.txt", b""
    elif way == "damage":
        content = _damaged(content, random)
    elif way == "values":
        content = mutated_json(json.loads(content), random)[1]
    entry.size = len(content)
    members[at] = (entry, content)
    if way == "drop":
        del members[at]
    elif way == "twice":
        members.append(members[at])
    elif way == "order":
        random.shuffle(members)
    with tarfile.open(path, "w:", format=tarfile.USTAR_FORMAT) as new:
        for member, data in members:
            with contextlib.suppress(ValueError):  # a name that is too long for this form
                new.addfile(member, io.BytesIO(data))
    return f"tar: {way}"


def _parquet(path: Path, random: Random) -> str:
    """Columns and rows of a table, and the JSON that it says of itself."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    table = pq.read_table(path, use_threads=False)
    at = random.randrange(table.num_columns)
    name = table.column_names[at]
    way = random.choice(("drop", "rename", "rows", "none", "odd", "odd", "words", "metadata", "order"))
    if way == "drop":
        table = table.drop_columns([name])
    elif way == "rename":
        table = table.rename_columns([*table.column_names[:at], "x\x1b[2J", *table.column_names[at + 1 :]])
    elif way == "rows":
        table = pa.concat_tables([table] * random.choice((2, 50)))
    elif way == "none":
        table = table.slice(0, 0)
    elif way == "metadata":
        table = table.replace_schema_metadata({**(table.schema.metadata or {}), b"sceneweaver": b"[" * DEEP})
    elif way == "order":
        table = table.take(pa.array(random.sample(range(table.num_rows), table.num_rows)))
    else:
        odd = {"odd": (None, -1, 2**62, 0), "words": ODD_NAMES}[way]
        kind, values = table.schema.field(at).type, table.column(at).to_pylist()
        values[random.randrange(len(values))] = random.choice(odd)
        with contextlib.suppress(pa.ArrowException, TypeError, OverflowError):
            table = table.set_column(at, name, pa.array(values, type=kind))
            way = f"{way} {name}"
    pq.write_table(table, path)
    return f"parquet: {way}"


def _image(path: Path, random: Random) -> str:
    """A picture of an odd size or mode, or with a header that promises more than there is."""
    from PIL import Image

    way = random.choice(("size", "mode", "promise"))
    if way == "promise":
        data = bytearray(path.read_bytes())
        data[16:24] = random.choice((b"\0\0\xff\xff" * 2, b"\x7f\xff\xff\xff" * 2, bytes(8), b"\0\0\0\1\0\1\0\0"))
        path.write_bytes(data)
    else:
        size = random.choice(((1, 1), (1, 9000), (9000, 1), (3, 7))) if way == "size" else (16, 16)
        mode = random.choice(("1", "L", "LA", "P", "I;16", "RGBA")) if way == "mode" else "RGB"
        Image.new(mode, size).save(path, "PNG")
    return f"image: {way}"


_FORMS: dict[str, Callable[[Path, Random], str]] = {
    **dict.fromkeys((".json", ".gltf"), _json),
    **dict.fromkeys((".yaml", ".yml"), _yaml),
    **dict.fromkeys((".obj", ".mtl", ".stl", ".ply", ".off", ".usda", ".csv", ".sha256", ".jsonl"), _lines),
    **dict.fromkeys((".zip", ".npz", ".usdz"), _zip),
    ".xml": _xml,
    ".glb": _glb,
    ".tar": _tar,
    ".parquet": _parquet,
    ".png": _image,
}


def plant_link(folder: Path, name: str, random: Random, outside: Path) -> str:
    """Put a link to another place where a command is going to write."""
    place = folder / name
    way = random.choice(("file", "dangling", "folder"))
    place.parent.mkdir(parents=True, exist_ok=True)
    if place.is_dir() and not place.is_symlink():
        shutil.rmtree(place)
    place.unlink(missing_ok=True)
    place.symlink_to({"file": outside / "known.txt", "dangling": outside / "new.txt", "folder": outside}[way])
    return f"output {name}: link ({way})"
