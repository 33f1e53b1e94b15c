"""Inverse optimisation: the weights of soft relations and terms for which arranged rooms are at rest."""

from .forces import Forces as Forces
from .forces import forces_of as forces_of
from .weights import LearnedWeights as LearnedWeights
from .weights import learn_weights as learn_weights

__all__ = ["Forces", "LearnedWeights", "forces_of", "learn_weights"]
