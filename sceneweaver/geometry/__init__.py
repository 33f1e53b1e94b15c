"""Frames, rotations, walls of a room, its shell, polygons and convex hulls: the arithmetic that every floor shares.

Metres and radians; z is up, yaw is counter-clockwise about +z, the front of an object is +x of its frame. Quaternions
are (x, y, z, w). The modules take and return floats, tuples and arrays; they know nothing of scenes. None of them loads
numpy, scipy or shapely when it is imported but `hulls` and `prisms`, which need numpy.
"""
