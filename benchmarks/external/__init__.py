"""Optimisers of others as `StepOptimizer`s, one module each: JAX's by `sceneweaver.jax`, PyTorch's, and placers.

``sceneweaver bench run --optimizers search,benchmarks.external:RIVALS`` compares them all.
"""

RIVALS = {
    "cma-es (evosax)": "benchmarks.external.evosax_cma:CmaEs",
    "adam (optax)": "benchmarks.external.optax_adam:OptaxAdam",
    "adam (torch)": "benchmarks.external.torch_adam:TorchAdam",
    "bfgs (optimistix)": "benchmarks.external.optimistix_bfgs:Bfgs",
    "levenberg-marquardt (optimistix)": "benchmarks.external.optimistix_lm:LevenbergMarquardt",
    "mala (blackjax)": "benchmarks.external.blackjax_mala:Mala",
    "momentum": "benchmarks.external.momentum:Momentum",
    "annealing": "benchmarks.external.annealing:Annealing",
    "greedy": "benchmarks.external.greedy:Greedy",
    "numpy descent": "benchmarks.external.placement:NumpyDescent",
    "torch positions": "benchmarks.external.placement:TorchPositions",
}
