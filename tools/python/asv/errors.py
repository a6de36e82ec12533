"""What can go wrong, as exceptions.

Arguments that make no sense are plain ValueError or TypeError.
"""


class ParseError(ValueError):
    """A file or text that cannot be understood, and where.

    Attributes: file (str), line and column (int, from 1, columns in bytes), expected and found
    (str). As text: "FILE:LINE:COLUMN: expected EXPECTED, found FOUND".
    """

    def __init__(self, message, file, line, column, expected, found):
        super().__init__(message)
        self.file = file
        self.line = line
        self.column = column
        self.expected = expected
        self.found = found

    def __reduce__(self):
        return type(self), (
            str(self), self.file, self.line, self.column, self.expected, self.found)


class FileError(OSError):
    """A file that cannot be opened, read or written: "FILE: REASON"."""


class ReadError(FileError):
    """An input that cannot be opened or read."""


class WriteError(FileError):
    """An output that cannot be created or written."""


class InvalidEnds(ValueError):
    """The start or the goal of a problem violates requirements.

    Attribute: ends, a list of ("start" or "goal", reason).
    """

    def __init__(self, message, ends):
        super().__init__(message)
        self.ends = [tuple(end) for end in ends]

    def __reduce__(self):
        return type(self), (str(self), self.ends)


class NoRoom(RuntimeError):
    """A generated problem whose start or goal finds no place."""


class FormatWarning(UserWarning):
    """Something in a file that was understood but is not as the format says."""
