# SPDX-License-Identifier: MIT
"""Results as notebooks show them."""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape
from typing import Any

import numpy as np


def html_table(heads: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Cells are text, not markup: file names come into them."""

    def line(cells: Sequence[str], tag: str) -> str:
        return "<tr>" + "".join(f"<{tag}>{escape(cell)}</{tag}>" for cell in cells) + "</tr>"

    return f"<table>{line(heads, 'th')}{''.join(line(row, 'td') for row in rows)}</table>"


def mean_of(values: Any, which: Any) -> str:
    """The mean of the values that are meant, to four digits; a dash for none."""
    chosen = np.asarray(values)[which]
    return f"{chosen.mean():.4g}" if chosen.size else "-"
