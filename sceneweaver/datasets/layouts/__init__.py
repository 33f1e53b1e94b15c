"""Layouts by the million: rooms as programs, their valid layouts as rows of Parquet."""

from .block import make_block
from .pack import pack
from .read import load_layout, load_program

__all__ = ["load_layout", "load_program", "make_block", "pack"]
