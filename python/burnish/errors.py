"""The exceptions of burnish. All are `Error`; most are also the built-in exception a Python caller expects."""


class Error(Exception):
    """Anything burnish refuses or fails to do; the message names what failed and the remedy.

    Attributes
    ----------
    code : str
        Stable name, as in the command line's last line, e.g. "E_MISSING_CHANNEL".
    """

    code = "E_UNKNOWN"


class BadArgument(Error, ValueError):
    """A setting, JSON field or array out of its range."""

    code = "E_BAD_ARGUMENT"


class MissingChannel(Error, LookupError):
    """A role that no layer of the frame can fill."""

    code = "E_MISSING_CHANNEL"


class SizeMismatch(Error, ValueError):
    """Arrays or images that should agree in size do not."""

    code = "E_SIZE_MISMATCH"


class ReadFailed(Error, OSError):
    """A file that is absent, unreadable, corrupt or unsupported."""

    code = "E_READ_FAILED"


class WriteFailed(Error, OSError):
    """A target that cannot be written, or a full disk."""

    code = "E_WRITE_FAILED"


class ColorSpaceError(Error, ValueError):
    """An OpenColorIO config or colour space that is unknown."""

    code = "E_COLOR_SPACE"


class Cancelled(Error):
    """The progress callback returned False."""

    code = "E_CANCELLED"


class FramesFailed(Error):
    """Frames of a sequence failed, or have no input.

    Attributes
    ----------
    report : burnish.sequence.SequenceReport
        What became of every frame.
    """

    code = "E_FRAMES_FAILED"

    def __init__(self, message, report):
        super().__init__(message)
        self.report = report


class LostConnection(Error, OSError):
    """The scheduler of a farm is gone; the same call goes on where it stopped."""

    code = "E_LOST_CONNECTION"


BY_CODE = {
    error.code: error
    for error in (BadArgument, MissingChannel, SizeMismatch, ReadFailed, WriteFailed, ColorSpaceError, Cancelled)
}
