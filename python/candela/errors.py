"""The exceptions of candela. Their text is one line: "PATH: TEXT", or the text alone."""

from __future__ import annotations


class Error(RuntimeError):
    """Something that candela can not do, with the reason.

    Attributes:
        path: The file or URI at fault; empty when there is none.
    """

    path: str

    def __init__(self, text: str, path: str = "") -> None:
        super().__init__(text)
        self.path = path

    def __reduce__(self) -> tuple[type, tuple[str, str]]:
        return type(self), (str(self), self.path)


class InputError(Error, ValueError):
    """A file, a scene or an argument is not what it has to be."""


class UnsupportedError(Error):
    """The input is well-formed, but asks for something that candela does not do."""


class MachineError(Error):
    """The machine lacks something: a file, a device, disk space, an OpenGL version."""


class LimitError(Error):
    """A size is beyond what the device or the file format can hold."""


class CancelledError(Error):
    """The caller's own progress callback asked to stop."""


class CandelaWarning(UserWarning):
    """Something of a file or a picture is not as one may expect; the text says what."""
