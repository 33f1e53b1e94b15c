"""What sceneweaver reaches and how long it takes: ``python -m benchmarks --help``.

A benchmark states quality next to time and ends with exit code 1 when an answer is wrong, never because it is slow.
"""
