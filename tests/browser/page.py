#!/usr/bin/env python3
"""Opens a report in a real browser: it is looked at as a person would, by what is visible, with the keyboard and with the mouse.

    python3 tests/browser/page.py REPORT.html [FOLDER FOR SCREENSHOTS]

The standard library is enough: Chromium is driven over its DevTools protocol through a pipe. Exit status 0 if all is well, 1 if not, 4 if no browser is here.
"""

import base64
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")


class Browser:
    """Chromium without a window, one page, and no network."""

    def __init__(self, program, profile):
        to_browser, self.to = os.pipe()
        self.of, from_browser = os.pipe()
        options = [
            "--headless=new",
            "--no-sandbox",
            "--disable-gpu",
            "--disable-dev-shm-usage",
            "--no-first-run",
            "--disable-background-networking",
            "--disable-component-update",
            "--disable-sync",
            "--disable-quic",
            "--hide-scrollbars",
            f"--user-data-dir={profile}",
            "--remote-debugging-pipe",
            "about:blank",
        ]
        # The browser reads commands from 3 and answers on 4.
        plumbed = f'exec "$0" "$@" 3<&{to_browser} 4>&{from_browser}'
        self.process = subprocess.Popen(
            ["/bin/sh", "-c", plumbed, program, *options],
            pass_fds=(to_browser, from_browser),
            stderr=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
        )
        os.close(to_browser)
        os.close(from_browser)
        self.buffer = b""
        self.number = 0
        self.events = []
        self.session = None
        page = self.ask("Target.getTargets")["targetInfos"]
        target = next(info["targetId"] for info in page if info["type"] == "page")
        self.session = self.ask("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.ask(f"{domain}.enable")

    def receive(self):
        while b"\0" not in self.buffer:
            piece = os.read(self.of, 1 << 20)
            if not piece:
                raise SystemExit("FAILED: the browser has ended")
            self.buffer += piece
        message, _, self.buffer = self.buffer.partition(b"\0")
        return json.loads(message)

    def ask(self, method, **parameters):
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.to, json.dumps(message).encode() + b"\0")
        while True:
            answer = self.receive()
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise SystemExit(f"FAILED: {method}: {answer['error']}")
                return answer["result"]
            self.events.append(answer)

    def wait(self, event):
        while not any(seen.get("method") == event for seen in self.events):
            self.events.append(self.receive())

    def open(self, url):
        self.events.clear()
        self.ask("Page.navigate", url=url)
        self.wait("Page.loadEventFired")

    def run(self, script):
        answer = self.ask("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            raise SystemExit(f"FAILED: {script}: {answer['exceptionDetails']}")
        return answer["result"].get("value")

    def size(self, width, height, is_phone=False):
        self.ask("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=is_phone)

    def scheme(self, name):
        self.ask("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": name}])

    def click(self, selector):
        place = self.run(
            f"""(() => {{ const e = document.querySelector({json.dumps(selector)}); e.scrollIntoView({{block: "center"}});
            const r = e.getBoundingClientRect(); return [r.x + Math.min(r.width, 40) / 2, r.y + r.height / 2]; }})()"""
        )
        for kind in ("mousePressed", "mouseReleased"):
            self.ask("Input.dispatchMouseEvent", type=kind, x=place[0], y=place[1], button="left", clickCount=1)

    def press(self, key, code, text=""):
        for kind in ("keyDown", "keyUp"):
            self.ask(
                "Input.dispatchKeyEvent", type=kind, key=key, code=key, windowsVirtualKeyCode=code,
                text=text if kind == "keyDown" else "",
            )

    def type(self, text):
        self.ask("Input.insertText", text=text)

    def shoot(self, path, whole=False):
        options = {"captureBeyondViewport": True} if whole else {}
        if whole:
            size = self.ask("Page.getLayoutMetrics")["cssContentSize"]
            options["clip"] = {"x": 0, "y": 0, "width": size["width"], "height": min(size["height"], 6000), "scale": 1}
        picture = self.ask("Page.captureScreenshot", format="png", **options)["data"]
        pathlib.Path(path).write_bytes(base64.b64decode(picture))

    def end(self):
        self.process.terminate()
        try:
            self.process.wait(10)
        except subprocess.TimeoutExpired:
            self.process.kill()


# What a person sees: an element that takes room and is inside of nothing that is folded.
VISIBLE = """
const seen = (e) => e.checkVisibility() && e.getClientRects().length > 0;
const rows = () => [...document.querySelectorAll("table.cases > tbody")].filter(seen);
const names = () => rows().map((row) => row.querySelector("th").textContent.trim());
"""


class Checks:
    def __init__(self, browser):
        self.browser = browser
        self.count = 0
        self.failed = []

    def see(self, script):
        return self.browser.run("(() => {" + VISIBLE + "return " + script + "})()")

    def that(self, what, holds, said=""):
        self.count += 1
        print(f"  {'ok' if holds else 'FAILED'}  {what}{'' if holds else f': {said}'}")
        if not holds:
            self.failed.append(what)


def check(browser, url, shots):
    checks = Checks(browser)
    browser.size(1280, 900)
    browser.scheme("light")
    browser.open(url)
    that, see = checks.that, checks.see

    verdict = see('document.querySelector("h1").innerText')
    that("the verdict is said first", verdict.split()[0] in ("PASS", "FAIL", "UNDECIDED"), verdict)
    all_cases = see("names()")
    that("the table shows cases", len(all_cases) > 3, all_cases)
    that("no case twice", len(set(all_cases)) == len(all_cases))
    shots and browser.shoot(shots / "light.png", whole=True)

    # The script runs under the policy of the page; nothing was loaded from anywhere.
    that("the filters are there", see('seen(document.querySelector("#filters"))'))
    asked = [seen["params"]["request"]["url"] for seen in browser.events if seen.get("method") == "Network.requestWillBeSent"]
    that("nothing else is loaded", asked == [url], asked)
    complaints = [seen["params"]["entry"]["text"] for seen in browser.events if seen.get("method") == "Log.entryAdded"]
    that("the browser does not complain", complaints == [], complaints)
    that("no script of a name has run", see("window.hostile === undefined") and see("document.scripts.length") == 1)

    # A filter, by the keyboard alone.
    browser.run('document.querySelector("#filters input").focus()')
    wanted = all_cases[len(all_cases) // 2]
    browser.type(wanted)
    shown = see("names()")
    that("a filter leaves what was asked for", wanted in shown and len(shown) < len(all_cases), shown)
    status = see('document.querySelector("#count").innerText')
    that("how many are shown is said", status == f"{len(shown)} of {len(all_cases)} cases", status)
    browser.click("#filters button[type=reset]")
    browser.run("new Promise((done) => setTimeout(done, 50))")
    that("a reset shows all again", see("names().length") == len(all_cases))

    verdicts = see('[...document.querySelector("#filters select").options].map((o) => o.value).filter(Boolean)')
    for value in verdicts:
        browser.run(
            f"""(() => {{ const s = document.querySelector("#filters [name=verdict]"); s.value = {json.dumps(value)};
            s.dispatchEvent(new Event("input", {{bubbles: true}})); }})()"""
        )
        said = see('rows().map((row) => row.dataset.verdict)')
        that(f"the filter \"{value}\" leaves those alone", said and set(said) == {value}, said)
    browser.click("#filters button[type=reset]")
    browser.run("new Promise((done) => setTimeout(done, 50))")

    # Sorting: the state is told to a screen reader too.
    def column(place):
        return see(
            f"rows().map((row) => row.rows[0].cells[{place}]).map((c) => c.dataset.value ?? c.innerText.trim()).filter((v) => v !== '').map(Number)"
        )

    omega = 5
    head = f"table.cases thead th:nth-child({omega + 1})"
    before = see("names()")
    for state, order in (("ascending", sorted), ("descending", lambda values: sorted(values, reverse=True))):
        browser.click(f"{head} button")
        values = column(omega)
        that(f"sorted, {state}", values == order(values) and len(set(values)) > 1, values[:10])
        that(f"aria-sort is {state}", see(f'document.querySelector("{head}").getAttribute("aria-sort")') == state)
    browser.click(f"{head} button")
    that("a third click is the order of the run", see("names()") == before)

    # A case that failed unfolds to its findings, its impacts and the command that shows it again.
    if "wrong" in verdicts:
        case = 'table.cases > tbody[data-verdict="wrong"]'
        inside = f'[...document.querySelectorAll(\'{case} .findings, {case} .impacts, {case} .command\')].slice(0, 3)'
        that("a case is folded", see(f"{inside}.every((e) => !seen(e))"))
        browser.run(f"document.querySelector('{case} summary').focus()")
        browser.press("Enter", 13, "\r")
        that("a case unfolds by the keyboard", see(f"document.querySelector('{case} details').open"))
        for part in (".findings", ".impacts", ".command"):
            that(f"what it unfolds to is seen: {part[1:]}", see(f"seen(document.querySelector('{case} {part}'))"))
        that("the digits that differ are marked", see(f"[...document.querySelectorAll('{case} mark')].some(seen)"))
        that("the command is whole", see(f"document.querySelector('{case} .command').innerText").startswith("chattercheck "))
        shots and browser.shoot(shots / "unfolded.png")
        # A link from above leads to its case, and unfolds it.
        link = see('document.querySelector("#wrong .links a").getAttribute("href")')
        browser.run("document.querySelectorAll('details').forEach((d) => { d.open = false; })")
        browser.click("#wrong .links a")
        browser.run("new Promise((done) => setTimeout(done, 100))")
        that("a link unfolds its case", see(f"document.querySelector('{link} details').open"))
        that("and shows it", see(f"(() => {{ const r = document.querySelector('{link}').getBoundingClientRect(); return r.top >= 0 && r.top < innerHeight; }})()"))

    # Dark, and on a phone.
    bright = "(() => { const [r, g, b] = getComputedStyle(document.body).backgroundColor.match(/\\d+/g).map(Number); return r + g + b; })()"
    that("the page is light", see(bright) > 600)
    browser.scheme("dark")
    that("and dark", see(bright) < 150)
    shots and browser.shoot(shots / "dark.png", whole=True)
    browser.size(360, 740, is_phone=True)
    browser.open(url)
    wide = see("document.documentElement.scrollWidth")
    that("nothing is wider than a phone", wide <= 360, wide)
    browser.run("document.querySelectorAll('details').forEach((d) => { d.open = true; })")
    wide = see("document.documentElement.scrollWidth")
    that("nor is what is unfolded", wide <= 360, wide)
    shots and browser.shoot(shots / "phone-dark-unfolded.png", whole=True)
    browser.scheme("light")
    browser.open(url)
    shots and browser.shoot(shots / "phone.png", whole=True)

    # Without a script everything is there to be read.
    browser.ask("Emulation.setScriptExecutionDisabled", value=True)
    browser.size(1280, 900)
    browser.open(url)
    browser.ask("Emulation.setScriptExecutionDisabled", value=False)
    that("without a script every case is there", see("names().length") == len(all_cases))
    that("and no filter that would do nothing", not see('seen(document.querySelector("#filters"))'))
    return checks


def main():
    page = pathlib.Path(sys.argv[1]).resolve()
    shots = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else None
    shots and shots.mkdir(parents=True, exist_ok=True)
    program = next(filter(None, map(shutil.which, NAMES)), None)
    if program is None:
        print(f"NOT TRIED: no browser is here (one of {', '.join(NAMES)}): the HTML report was not opened", file=sys.stderr)
        return 4
    print(f"{page.name} in {program}")
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        browser = Browser(program, profile)
        try:
            checks = check(browser, page.as_uri(), shots)
        finally:
            browser.end()
    print(f"{checks.count - len(checks.failed)} of {checks.count} checks hold")
    return 1 if checks.failed else 0


if __name__ == "__main__":
    sys.exit(main())
