"""Patterns that strict eyes counted over many rooms, measured."""
