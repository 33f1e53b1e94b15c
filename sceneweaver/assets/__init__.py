"""Furniture with bodies: meshes, collision parts, support surfaces and the libraries that they come from."""
