"""Exceptions of the public API. Each message is one line that names the field and the fix."""

from .messages import clean


class SceneWeaverError(Exception):
    """Base of every error that the library raises on purpose.

    ``exit_code`` is the status with which the command line ends.

    Examples:
        >>> import sceneweaver as sw
        >>> try:
        ...     sw.Scene.example("palace")
        ... except sw.SceneWeaverError as error:
        ...     print(error.exit_code, str(error).split(";")[0])
        2 no example 'palace'
    """

    exit_code = 1

    def __init__(self, message: object = "") -> None:
        """``message`` may quote what a file holds: it becomes one line of what a terminal can print."""
        super().__init__(clean(str(message)))


class InputError(SceneWeaverError, ValueError):
    """The input is wrong: a file, a field of a scene, an argument or an edit.

    It is a ``ValueError`` as well.

    Examples:
        >>> import sceneweaver as sw
        >>> sw.Pose.from_yaw(0.0, 0.0, 0.0, float("nan"))
        Traceback (most recent call last):
            ...
        sceneweaver.io.errors.InputError: pose: yaw is NaN; numbers must be finite
    """

    exit_code = 2


class MissingDependencyError(SceneWeaverError):
    """A needed service, extra or device is not there.

    Examples:
        >>> import sceneweaver as sw
        >>> sw.MissingDependencyError("PyTorch is not installed").exit_code
        4
    """

    exit_code = 4
