"""Rooms in the environments of others. Each module needs its library, which is imported when it is used."""
