"""Names that a client gives for files: each is a place below one folder, or refused."""

from __future__ import annotations

import os
import re
from pathlib import Path

from sceneweaver.io.messages import clean, shorten
from sceneweaver.scene import InputError

LONGEST, LONGEST_PART, DEEPEST = 400, 120, 6
"""Bytes of a name, bytes of each of its parts, and how many parts it may have."""

_FORBIDDEN = re.compile(r'[\\:*?"<>|~$`]')
_DEVICES = re.compile(r"(con|prn|aux|nul|com[0-9]|lpt[0-9])(\..*)?", re.IGNORECASE)


class Folder:
    """The folder below which the server reads and writes.

    Args:
        root: a folder that is there; its real path is meant from then on.

    Raises:
        InputError: when it is no folder, or the whole disk.
    """

    def __init__(self, root: str | os.PathLike[str]) -> None:
        real = Path(os.path.realpath(root))
        if not real.is_dir():
            raise InputError(f"--folder: {clean(os.fspath(root))} is no folder; make it first")
        if real == Path(real.anchor):
            raise InputError("--folder: this is the whole disk; give a folder for the scenes")
        self.root = real

    def place(self, name: str, field: str, suffix: str = "") -> Path:
        """The path of a name below the folder; where ``suffix`` is given, the name must end in it.

        Raises:
            InputError: for a name that is empty, too long, hidden, reserved, absolute, or leads out of the folder.
        """
        shown = f"{field}: '{shorten(clean(name))}'"
        parts = name.split("/")
        if not name or any(part in ("", ".", "..") for part in parts):
            raise InputError(f"{shown} is no name below the folder; give one such as rooms/study, without . and ..")
        if len(os.fsencode(name.encode("utf-8", "replace"))) > LONGEST or len(parts) > DEEPEST:
            raise InputError(f"{shown} is too long; at most {LONGEST} bytes and {DEEPEST} parts")
        for part in parts:
            _check_part(part, shown)
        if suffix and not name.lower().endswith(suffix):
            raise InputError(f"{shown} does not end in {suffix}; give such a name")
        path = self.root.joinpath(*parts)
        if not Path(os.path.realpath(path)).is_relative_to(self.root):
            raise InputError(f"{shown} leads out of the folder by a link; give another name")
        return path

    def to_write(self, name: str, field: str, suffix: str = "") -> Path:
        """The path of a name that may be written: neither itself a link, nor in a file's place."""
        path = self.place(name, field, suffix)
        if path.is_symlink():
            raise InputError(f"{field}: '{shorten(name)}' is a link; give another name")
        for parent in path.relative_to(self.root).parents:
            above = self.root / parent
            if above.exists() and not above.is_dir():
                raise InputError(f"{field}: '{shorten(str(parent))}' is a file; give a name below a folder")
        return path

    def shown(self, path: str | os.PathLike[str]) -> str:
        """The name of a path below the folder."""
        return Path(path).relative_to(self.root).as_posix()

    def without_paths(self, text: str) -> str:
        """A message on one line, with names in the place of paths below the folder, and no other paths."""
        line = " ".join(clean(text).replace(f"{self.root}{os.sep}", "").replace(str(self.root), "the folder").split())
        return re.sub(r"(?<![\w.:/])(?:/[\w.@+~-]+){2,}/?", "<path>", line)


def holds_links(folder: Path) -> bool:
    """Whether anything below a folder is a link."""
    return any(
        os.path.islink(os.path.join(at, name)) for at, folders, files in os.walk(folder) for name in (*folders, *files)
    )


def _check_part(part: str, shown: str) -> None:
    if not part.isprintable() or _FORBIDDEN.search(part):
        raise InputError(f"{shown} has characters that no file name should have; give letters, digits, - and _")
    if part.startswith((".", " ")) or part.endswith((".", " ")):
        raise InputError(f"{shown} begins or ends with a dot or a blank; give a plain name")
    if _DEVICES.fullmatch(part):
        raise InputError(f"{shown} is the name of a device on some systems; give another name")
    if len(part.encode("utf-8", "replace")) > LONGEST_PART:
        raise InputError(f"{shown} is too long; at most {LONGEST_PART} bytes between slashes")
