"""What can go wrong with a model. None of it ends a design: whoever asks goes on without the model."""

from __future__ import annotations

from sceneweaver.scene import SceneWeaverError


class ModelError(SceneWeaverError):
    """A model gave no answer that can be used; one line that names the reason and holds no secret."""


class ModelFailed(ModelError):
    """It answered, but not what it was asked for: a refusal, broken data, or what the validator kept refusing."""


class ModelUnreachable(ModelError):
    """No answer at all: no connection, no permission, or time-outs and errors of the server until the tries were used
    up."""


class BudgetSpent(ModelError):
    """The calls, tokens, cost or seconds that a run may spend on models are spent."""


class ReplayError(SceneWeaverError):
    """A recorded run does not fit the run that is to be made from it. No `ModelError`: nothing may go on without."""

    exit_code = 2
