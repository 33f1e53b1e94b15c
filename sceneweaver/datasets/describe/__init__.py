"""Words for scenes: captions, questions and instructions, with their ground truth."""

from .describe import describe

__all__ = ["describe"]
