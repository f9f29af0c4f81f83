# SPDX-License-Identifier: MIT
"""What the file system says, in Python's own exceptions."""
from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def told_if_missing(path: Path) -> Iterator[None]:
    """Of a file that is not there FileNotFoundError rather than OSError alone."""
    try:
        yield
    except OSError as error:
        if path.exists():
            raise
        raise FileNotFoundError(str(error)) from None
