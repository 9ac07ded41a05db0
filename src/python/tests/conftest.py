"""What the tests share."""

import json
import os
import subprocess
from pathlib import Path
from typing import Any, Protocol

import pytest

pytest_plugins = ["pytester"]

ROOT = Path(__file__).parents[3]


class Program(Protocol):
    """The command line: its answer as JSON, or the line of its error."""

    def __call__(self, *words: str) -> Any: ...


@pytest.fixture(scope="session")
def program() -> Program:
    """The program of this checkout."""
    named = os.environ.get("CHATTERCHECK_PROGRAM")
    built = [Path(named)] if named else [ROOT / "target" / profile / "chattercheck" for profile in ("debug", "release")]
    path = next((path for path in built if path.exists()), None)
    if path is None:
        assert named is None, f"CHATTERCHECK_PROGRAM = {named} is not there"
        pytest.skip("the program is not built: cargo build")

    def run(*words: str) -> Any:
        done = subprocess.run([str(path), *words], capture_output=True, text=True, cwd=ROOT)
        if done.returncode == 2:
            return done.stderr.strip()
        return json.loads(done.stdout)

    return run
