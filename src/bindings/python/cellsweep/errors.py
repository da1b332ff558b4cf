"""What a call raises that did not do what was asked. When one is raised, nothing has changed."""

from __future__ import annotations


class Error(Exception):
    """The base of all.

    Attributes: bodies, the ids at fault, at most 16 of them; rows, where these stand in the arrays of the call; number,
    what was asked for (of bodies at fault, how many there are in all); limit, what is allowed where there is a limit;
    setting, the option to change, or "".
    """

    bodies: list[int]
    rows: list[int]
    number: int
    limit: int
    setting: str


class InvalidBoxError(Error, ValueError):
    """A box with NaN, infinity or a minimum above its maximum."""


class UnknownBodyError(Error, KeyError):
    """An id that is not there."""

    __str__ = Exception.__str__  # KeyError's shows quotes


class DuplicateBodyError(Error, ValueError):
    """An id that is there already, or twice in a call that allows it once."""


class CapacityError(Error, OverflowError):
    """More than a stated limit allows."""


class OptionError(Error, ValueError):
    """An unknown engine, or a setting out of its range."""


class InputError(Error, ValueError):
    """Arguments or a file that contradict themselves."""


class SpeError(Error, RuntimeError):
    """An SPE of a Cell engine broke a rule or could not be started."""


class WriteError(Error, OSError):
    """A file could not be written."""


# By the numbers of cellsweep::StatusCode.
_CLASSES = [
    Error,
    InvalidBoxError,
    UnknownBodyError,
    DuplicateBodyError,
    CapacityError,
    OptionError,
    InputError,
    SpeError,
    WriteError,
]


def from_status(
    code: int, message: str, bodies: list[int], rows: list[int], number: int, limit: int, setting: str
) -> Error:
    """The exception of a status."""
    if rows:
        message += f" (row {rows[0]})" if len(rows) == 1 else f" (rows {', '.join(map(str, rows))})"
    error = _CLASSES[code](message)
    error.bodies, error.rows = bodies, rows
    error.number, error.limit, error.setting = number, limit, setting
    return error
