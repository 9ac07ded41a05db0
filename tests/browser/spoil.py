#!/usr/bin/env python3
"""Spoils the starter of an engine in Python: it rounds eta, declines and fails over some cases, and has a hostile name."""

import pathlib
import sys

HOSTILE = "</script><script>window.hostile = 1</script><img src=x onerror='window.hostile = 2'>"

SPOILED = f'''    if case["eta"] < 0.5:
        return {{"decline": {{"reason": "too lossy", "why": "{HOSTILE}"}}}}
    if case["omega"] > 6:
        return {{"error": {{"message": "{HOSTILE}"}}}}
    if case["omega"] > 3:
        case = {{**case, "eta": round(case["eta"], 3)}}
    try:
'''

path = pathlib.Path(sys.argv[1])
text = path.read_text()
for before, after in (("    try:\n", SPOILED), ("my python engine", HOSTILE)):
    assert text.count(before) == 1, before
    text = text.replace(before, after)
path.write_text(text)
