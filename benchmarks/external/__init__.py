"""Optimisers of other libraries as `StepOptimizer`s, one module each: JAX's by `sceneweaver.jax`."""
