"""Requests read by a model: into the same values, and through the same builder, as by rules."""
