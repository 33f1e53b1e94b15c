"""Exceptions of the public API. Each message is one line that names the field and the fix."""


class SceneWeaverError(Exception):
    """Base of every error that the library raises on purpose.

    ``exit_code`` is the status with which the command line ends.
    """

    exit_code = 1


class InputError(SceneWeaverError, ValueError):
    """The input is wrong: a file, a field of a scene, an argument or an edit."""

    exit_code = 2


class MissingDependencyError(SceneWeaverError):
    """A needed service, extra or device is not there."""

    exit_code = 4
