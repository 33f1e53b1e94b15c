"""Optimisers of others as `StepOptimizer`s, one module each: JAX's, PyTorch's, solvers of programs, placers.

``sceneweaver bench run --optimizers search,benchmarks.external:RIVALS`` compares them all. Most are dataclasses; what
may be tuned stands in ``SETTINGS``, a mapping of fields to values to try. docs/layout_bench_methods.md says where each
is from, what it sees, and what is fair about it.
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
    "cp-sat (or-tools)": "benchmarks.external.cp_sat:CpSat",
    "milp (highs)": "benchmarks.external.milp:Milp",
    "sequence pair": "benchmarks.external.sequence_pair_plan:SequencePair",
    "b*-tree": "benchmarks.external.bstar_tree:BStarTree",
    "minimize (scipy)": "benchmarks.external.scipy_minimise:ScipyMinimise",
    "dual annealing (scipy)": "benchmarks.external.scipy_minimise:DualAnnealing",
    "nlopt": "benchmarks.external.nlopt_minimise:Nlopt",
    "openai-es (evosax)": "benchmarks.external.evosax_open_es:OpenEs",
    "holodeck dfs": "benchmarks.external.holodeck_dfs:HolodeckDfs",
    "rejection": "benchmarks.external.rejection:Rejection",
    "layoutvlm (torch)": "benchmarks.external.layoutvlm:LayoutVlm",
    "arena relations (torch)": "benchmarks.external.arena_relations:ArenaRelations",
    "sequence pair + projection": "benchmarks.external.polished:SequencePair",
    "b*-tree + projection": "benchmarks.external.polished:BStarTree",
    "holodeck dfs + projection": "benchmarks.external.polished:HolodeckDfs",
    "rejection + projection": "benchmarks.external.polished:Rejection",
    "layoutvlm (torch) + projection": "benchmarks.external.polished:LayoutVlm",
    "arena relations (torch) + projection": "benchmarks.external.polished:ArenaRelations",
}
