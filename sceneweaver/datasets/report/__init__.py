"""One page about a data set: what is in it, how varied it is, and how it was made."""

from .page import write_report
from .run import memory_svg, throughput_svg

__all__ = ["memory_svg", "throughput_svg", "write_report"]
