"""The gate's side of the protocol, for the benches: starts the engines of a manifest and asks them."""

import json
import os
import selectors
import signal
import subprocess
import tomllib

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
MANIFEST = os.path.join(ROOT, "data", "engines", "peers.toml")
ECHO = [0.1, 5e-324, 1.7976931348623157e308, -0.0]


class Broke(Exception):
    """An engine that gave no answer: how it broke."""


def manifest(path=MANIFEST):
    """The engines of a manifest, each with the folder that it is run in."""
    with open(path, "rb") as file:
        engines = tomllib.load(file)["engine"]
    for engine in engines:
        engine["folder"] = os.path.join(os.path.dirname(path), engine.get("directory", "."))
    return engines


class Engine:
    """A running engine. `patience`: how many seconds of the processor it may use altogether."""

    def __init__(self, entry, patience=None):
        self.entry, self.seq, self.rest = entry, 0, b""

        self.process = subprocess.Popen(
            entry["run"],
            cwd=entry["folder"],
            env={**os.environ, **entry.get("environment", {})},
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
        )
        self.patience = patience
        self.reading = selectors.DefaultSelector()
        self.reading.register(self.process.stdout, selectors.EVENT_READ)
        welcome = self.say({"cmd": "start", "versions": [1], "echo": ECHO}, entry.get("start-timeout", 10))
        if json.dumps(welcome.get("echo")) != json.dumps(ECHO):
            raise Broke("the echo is not what was sent")
        self.name, self.version = welcome["engine"]["name"], welcome["engine"]["version"]

    def say(self, message, timeout):
        """The answer to a message."""
        try:
            self.process.stdin.write(json.dumps(message).encode() + b"\n")
            self.process.stdin.flush()
        except BrokenPipeError:
            raise Broke(self.how_it_ended()) from None
        while b"\n" not in self.rest:
            if not self.reading.select(timeout):
                self.stop()
                raise Broke(f"no answer for {timeout} s")
            some = os.read(self.process.stdout.fileno(), 1 << 16)
            if not some:
                raise Broke(self.how_it_ended())
            self.rest += some
        line, self.rest = self.rest.split(b"\n", 1)
        return json.loads(line)

    def how_it_ended(self):
        return f"it ended, status {self.process.wait()}"

    def spent(self):
        """Seconds of the processor so far. (With a limit of the system's the clock that engines time themselves with would tick in milliseconds.)"""
        with open(f"/proc/{self.process.pid}/stat") as file:
            user, system = file.read().rsplit(")", 1)[1].split()[11:13]
        return (int(user) + int(system)) / os.sysconf("SC_CLK_TCK")

    def ask(self, **case):
        """The answer to a case: its parameters, and what else differs from the usual."""
        if self.patience and self.spent() > self.patience:
            raise Broke(f"timed out after {self.patience} s")
        self.seq += 1
        usual = {"model": self.entry["model"], "alpha": None, "normalisation": "threshold", "until": "half-period"}
        question = {"cmd": "case", "seq": self.seq, **usual, "ground": {"sine": {"start": "threshold"}}, **case}
        answer = self.say(question, self.entry.get("case-timeout", 10))
        if "error" in answer:
            raise Broke(f"error: {answer['error']['message']}")
        return answer

    def stop(self):
        try:
            os.killpg(self.process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        self.process.wait()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stop()
