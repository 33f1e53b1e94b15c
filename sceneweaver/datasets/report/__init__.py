"""One page about a data set: what is in it, how varied it is, and how it was made."""

from .charts import memory_svg, throughput_svg
from .page import write_report

__all__ = ["memory_svg", "throughput_svg", "write_report"]
