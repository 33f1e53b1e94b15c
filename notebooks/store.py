"""Run the notebooks and store what they print and draw: ``python -m notebooks.store [--times] [NAME ...]``.

The notebooks themselves are the source: edit a cell, then store. Each runs in a fresh kernel and an empty folder.
Pictures that are large as PNG are kept as JPEG. The list in ``README.md`` says what each took, in seconds of processor
time; with ``--times`` that alone is measured and written.
"""

from __future__ import annotations

import base64
import io
import os
import re
import resource
import sys
import tempfile
from pathlib import Path

import nbformat
from jupyter_client.manager import AsyncKernelManager
from jupyter_core.utils import run_sync
from nbclient import NotebookClient
from nbformat import NotebookNode
from PIL import Image

ROOT = Path(__file__).resolve().parents[1]
SWITCH = "SCENEWEAVER_NOTEBOOKS"  # set to "small", notebooks take small sizes
PHOTO, QUALITY = 90_000, 84  # bytes of a PNG that becomes a JPEG, and how well that is kept
CHATTER = re.compile(r"^Warp (?:CUDA warning|\d).*\n?|^Module .* load on device .*\n?|^ *\n", re.MULTILINE)
COMPILING = re.compile(r"compil(?:ing|ed \d+ modules of) kernels")  # what a first run shows
README = Path(__file__).with_name("README.md")
NOTEBOOKS = sorted(Path(__file__).parent.glob("*.ipynb"))


def executed(path: Path, *, small: bool) -> NotebookNode:
    """The notebook with the outputs of a run now.

    Raises:
        nbclient.exceptions.CellExecutionError: a cell raised.
    """
    book = nbformat.read(path, as_version=4)
    with tempfile.TemporaryDirectory() as folder:
        environment = {
            **os.environ,
            "PYTHONPATH": str(ROOT),
            "IPYTHONDIR": f"{folder}/.ipython",
            "JUPYTER_RUNTIME_DIR": f"{folder}/.runtime",
            "JAX_PLATFORMS": os.environ.get("JAX_PLATFORMS", "cpu"),
            SWITCH: "small" if small else "",
        }
        # By sockets in the folder: with ports, others on this machine could talk to the kernel.
        kernel = AsyncKernelManager(kernel_name="python3", transport="ipc", connection_file=f"{folder}/.kernel.json")
        client = NotebookClient(book, km=kernel, timeout=600, resources={"metadata": {"path": folder}})
        try:
            client.execute(env=environment)
        finally:
            run_sync(kernel.shutdown_kernel)(now=True)
    return book


def tidied(book: NotebookNode) -> NotebookNode:
    """The notebook as it is stored: no times, no ids by chance, no chatter, small pictures."""
    book.metadata = {
        "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
        "language_info": {"name": "python"},
    }
    for number, cell in enumerate(book.cells):
        cell.id, cell.metadata = f"cell-{number}", {}
        if cell.cell_type == "code":
            cell.outputs = [tidy for output in cell.outputs if (tidy := _tidied(output)) is not None]
    return book


def _tidied(output: NotebookNode) -> NotebookNode | None:
    """An output without what changes by itself; None where nothing is left."""
    output.pop("transient", None)
    if output.output_type == "stream":
        output.text = CHATTER.sub("", output.text) if output.name == "stderr" else output.text
        return output if output.text else None
    output.metadata, data = {}, output.get("data", {})
    if COMPILING.match(data.get("text/plain", "")):
        return None
    if "text/plain" in data:
        data["text/plain"] = re.sub(r" at 0x[0-9a-fA-F]+", "", data["text/plain"])
    raw = base64.b64decode(data.get("image/png", ""))
    if len(raw) > PHOTO:
        file = io.BytesIO()
        Image.open(io.BytesIO(raw)).convert("RGB").save(file, "JPEG", quality=QUALITY, optimize=True)
        del data["image/png"]
        data["image/jpeg"] = base64.b64encode(file.getvalue()).decode() + "\n"
    return output


def with_time(text: str, name: str, seconds: float) -> str:
    """The list of notebooks with the time of one of them after its link."""
    return re.sub(rf"(\]\({re.escape(name)}\))(?: \(\d+ s\))?:", rf"\1 ({seconds:.0f} s):", text)


def _processor_seconds() -> float:
    """What the processes took that have been started here and have ended, kernels and their own among them [s]."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def main(names: list[str]) -> int:
    """Run and store the notebooks of these names, or all; write how long each took."""
    times_only = "--times" in names
    names = [name for name in names if name != "--times"]
    for path in NOTEBOOKS:
        if not names or path.stem in names or path.stem.split("_")[0] in names:
            began = _processor_seconds()
            book = tidied(executed(path, small=False))
            seconds = _processor_seconds() - began
            nbformat.validate(book)
            if not times_only:
                nbformat.write(book, path)
            README.write_text(with_time(README.read_text(), path.name, seconds))
            sys.stdout.write(f"{path.name}: {path.stat().st_size // 1000} kB, {seconds:.0f} s\n")
            sys.stdout.flush()
    return 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
