#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Nothing on the site is loaded from the network: check_offline.py FOLDER. Links that a reader may click are no loading."""
import re
import sys
from pathlib import Path

LOADS = re.compile(
    r"""<(?:script|img|iframe|source|audio|video|embed)\b[^>]*\ssrc=["']?(?:https?:)?//[^"'>\s]*"""
    r"""|<link\b(?=[^>]*rel=["']?(?:stylesheet|preload|preconnect|icon|modulepreload))[^>]*href=["']?(?:https?:)?//[^"'>\s]*"""
    r"""|url\(["']?(?:https?:)?//[^)"']*|@import\s+["'](?:https?:)?//[^"']*"""
)

bad = 0
for path in sorted(Path(sys.argv[1]).rglob("*")):
    if path.suffix not in (".html", ".css"):
        continue
    for load in LOADS.findall(path.read_text(encoding="utf-8")):
        print(f"{path}: loads from the network: {load}")
        bad += 1
sys.exit(1 if bad else 0)
