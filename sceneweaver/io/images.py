"""Images that somebody else made, of a bounded number of pixels."""

from __future__ import annotations

import contextlib
import io
import warnings
from collections.abc import Iterator
from typing import TYPE_CHECKING

from .errors import InputError
from .messages import path_name
from .reading import Place, read_bytes

if TYPE_CHECKING:
    from PIL import Image

MAX_BYTES = 128 * 2**20
"""Largest file [bytes]."""

MAX_PIXELS = 2**27
"""Most pixels of an image: 134 million, 0.4 GB as RGB."""

FORMATS = ("PNG", "JPEG", "WEBP", "TIFF", "BMP")


@contextlib.contextmanager
def open_image(path: Place) -> Iterator[Image.Image]:
    """An image; its pixels are read where they are used in the block, and errors there are told as well.

    Raises:
        InputError: as `read_bytes`; of another format, damaged, or too large.
    """
    from PIL import Image

    data = read_bytes(path, max_bytes=MAX_BYTES)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # PIL warns of large ones, which are refused below
            with Image.open(io.BytesIO(data), formats=FORMATS) as image:
                if image.width * image.height > MAX_PIXELS:
                    raise InputError(f"{path_name(path)}: {image.width} x {image.height} pixels; make it smaller")
                yield image
    except InputError:
        raise
    except Exception as error:  # a broken image fails in many ways inside the reader
        raise InputError(f"{path_name(path)}: cannot be read ({type(error).__name__}); save it anew") from None
