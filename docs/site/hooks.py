"""What the site has beside the pages of docs/: notebooks, texts of the top folder, and links that fit all of them."""

from __future__ import annotations

import base64
import posixpath
import re
from html import escape
from pathlib import Path

import nbformat
from mkdocs.structure.files import File

ROOT = Path(__file__).resolve().parents[2]
TEXTS = {
    "CONTRIBUTING.md": "contributing.md",
    "CHANGELOG.md": "changelog.md",
    "notebooks/README.md": "notebooks/index.md",
}
LINK = re.compile(r"(?<=\]\()(?!\w+:)([^)#\s]+)")
MERMAID = re.compile(r"^```mermaid\n(.*?)^```$", re.DOTALL | re.MULTILINE)
BOX = r'(\w+)(?:\["([^"]+)"\]|\(\((\w+)\)\))?'
ARROW = re.compile(rf"^ *{BOX} -- (\"[^\"]+\"|.+?) --> {BOX}$", re.MULTILINE)
PICTURES = {"image/png": "png", "image/jpeg": "jpg", "image/svg+xml": "svg"}


def on_config(config):
    """Folders in the navigation stand for their pages; what nobody listed goes to the end."""
    folders = {
        "notebooks/": ["notebooks/index.md"] + [f"notebooks/{path.stem}.md" for path in notebooks()],
        "decisions/": [f"decisions/{path.name}" for path in sorted((ROOT / "docs" / "decisions").glob("*.md"))],
    }
    config.nav = [_unfolded(entry, folders) for entry in config.nav]
    listed = str(config.nav)
    pages = sorted(path.name for path in (ROOT / "docs").glob("*.md") if path.name != "README.md")
    more = [name for name in pages if f"'{name}'" not in listed]
    config.nav += [{"More": more}] if more else []
    return config


def on_files(files, config):
    """Texts of the top folder and notebooks become pages."""
    for name, page in TEXTS.items():
        files.append(File.generated(config, page, content=(ROOT / name).read_text()))
    for path in notebooks():
        text, pictures = page_of(path)
        files.append(File.generated(config, f"notebooks/{path.stem}.md", content=text))
        for name, data in pictures.items():
            files.append(File.generated(config, f"notebooks/{name}", content=data))
    return files


def on_page_markdown(markdown, page, config, files):
    """Links lead to the pages of the site; diagrams are tables, as drawing them takes a script from elsewhere."""
    here = posixpath.dirname(page.file.src_uri)
    generated = {uri: posixpath.dirname(name) for name, uri in TEXTS.items()}
    folder = generated.get(page.file.src_uri, here if here == "notebooks" else posixpath.join("docs", here))

    def moved(match):
        target = posixpath.normpath(posixpath.join(folder, match[1]))
        if target in TEXTS:
            target = TEXTS[target]
        elif target.startswith("docs/"):
            target = target.removeprefix("docs/")
        elif target.endswith(".ipynb"):
            target = target.removesuffix(".ipynb") + ".md"
        else:
            return match[1]
        return posixpath.relpath(target, here or ".")

    return MERMAID.sub(lambda match: diagram(match[1]), LINK.sub(moved, markdown))


def notebooks() -> list[Path]:
    """The notebooks in their order."""
    return sorted((ROOT / "notebooks").glob("*.ipynb"))


def page_of(path: Path) -> tuple[str, dict[str, bytes]]:
    """A notebook as Markdown, and its pictures by name."""
    parts, pictures = [], {}
    for cell in nbformat.read(path, as_version=4).cells:
        if cell.cell_type == "markdown":
            parts.append(cell.source)
        elif cell.cell_type == "code":
            parts.append(f"```python\n{cell.source}\n```")
            for output in cell.outputs:
                parts.append(_shown(output, f"{path.stem}-{len(pictures)}", pictures))
    return "\n\n".join(parts) + "\n", pictures


def diagram(text: str) -> str:
    """A flow chart as a table: from, what goes over, to."""
    names = {key: label or key for found in ARROW.finditer(text) for key, label in _boxes(found)}
    rows = [f"| {_box(names[m[1]])} | {m[4].strip(chr(34))} | {_box(names[m[5]])} |" for m in ARROW.finditer(text)]
    return "\n".join(["| from | hands on | to |", "| --- | --- | --- |", *rows])


def _unfolded(entry, folders: dict[str, list[str]]):
    """A part of the navigation with the names of folders replaced by their pages."""
    if isinstance(entry, dict):
        return {title: _unfolded(inner, folders) for title, inner in entry.items()}
    if isinstance(entry, list):
        return [_unfolded(inner, folders) for inner in entry]
    return folders.get(entry, entry)


def _boxes(match) -> list[tuple[str, str | None]]:
    pairs = [(match[1], match[2] or match[3]), (match[5], match[6] or match[7])]
    return [(key, label) for key, label in pairs if label]


def _box(label: str) -> str:
    path, _, name = label.rpartition(": ")
    return f"**{name}** `{path}`" if path else f"*{name}*"


def _shown(output, name: str, pictures: dict[str, bytes]) -> str:
    """An output of a cell as Markdown; a picture is put into ``pictures``."""
    if output.output_type == "stream":
        return f'<pre class="output">{escape(output.text.rstrip())}</pre>'
    data = output.get("data", {})
    for kind, ending in PICTURES.items():
        if kind in data:
            raw = data[kind]
            content = raw.encode() if ending == "svg" else base64.b64decode(raw)
            pictures[f"{name}.{ending}"] = content
            return f"![]({name}.{ending}){{ .output }}"
    if "text/markdown" in data:
        return f'<div class="output" markdown>\n\n{data["text/markdown"]}\n\n</div>'
    if "text/html" in data:
        return f'<div class="output">{data["text/html"]}</div>'
    return f'<pre class="output">{escape(data.get("text/plain", ""))}</pre>'
