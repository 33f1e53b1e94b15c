"""XML that somebody else wrote: no document types (so no entities), bounded in depth and size."""

from __future__ import annotations

import os
from pathlib import Path
from xml.etree import ElementTree
from xml.parsers import expat

from .errors import InputError
from .messages import clean
from .reading import Place, read_bytes, reason

MAX_BYTES = 64 * 2**20
"""Largest file [bytes]."""

MAX_DEPTH = 200
"""Elements within each other."""

MAX_ELEMENTS = 1_000_000


def load_xml(path: Place, *, max_bytes: int = MAX_BYTES) -> ElementTree.Element:
    """The root element of an XML file.

    Raises:
        InputError: as `read_bytes` and `parse_xml`, naming the file.
    """
    return parse_xml(read_bytes(path, max_bytes=max_bytes), clean(Path(os.fspath(path)).name))


def parse_xml(text: str | bytes, name: str) -> ElementTree.Element:
    """The root element of an XML text.

    Args:
        text: the text; bytes are in the encoding that they state.
        name: stands in errors.

    Raises:
        InputError: damaged XML, a document type, nested too deep, too many elements.
    """
    checked = expat.ParserCreate()
    depth = count = 0

    def begin(*_: object) -> None:
        nonlocal depth, count
        depth, count = depth + 1, count + 1
        if depth > MAX_DEPTH:
            raise InputError(f"{name}: XML nested more than {MAX_DEPTH} deep")
        if count > MAX_ELEMENTS:
            raise InputError(f"{name}: XML of more than {MAX_ELEMENTS} elements")

    def end(*_: object) -> None:
        nonlocal depth
        depth -= 1

    def refuse(*_: object) -> None:
        raise InputError(f"{name}: XML entities and document types are not read; remove <!DOCTYPE>")

    checked.StartElementHandler, checked.EndElementHandler = begin, end
    checked.StartDoctypeDeclHandler = checked.EntityDeclHandler = refuse
    try:
        checked.Parse(text, True)
        return ElementTree.fromstring(text)
    except (expat.ExpatError, ElementTree.ParseError, ValueError, LookupError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(f"{name}: damaged XML ({reason(error)})") from None
