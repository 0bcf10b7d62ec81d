"""What the module raises."""

from __future__ import annotations

from typing import Optional


class Error(Exception):
    """Of everything that is amble's own."""


class InputError(Error, ValueError):
    """Input that is wrong: one line, `FILE:LINE: what is wrong; what was expected`.

    file:     that it stands in; `<name>` for a scenario that was given as a dict
    line:     of that file, from 1; None where a line makes no sense
    problem:  what is wrong
    expected: what was expected; "" where nothing is said of it
    """

    def __init__(self, message: str, file: str = "", line: Optional[int] = None, problem: str = "",
                 expected: str = "") -> None:
        super().__init__(message)
        self.file = file
        self.line = line
        self.problem = problem
        self.expected = expected

    def __reduce__(self):  # to another process
        return type(self), (str(self), self.file, self.line, self.problem, self.expected)


class NoWalkError(Error):
    """Something of a walk was asked for where none was found; the text says why there is none."""
