"""Debian's Firefox on a display (tests/support/bin/with_display), driven by WebDriver BiDi: a few of its commands over a
WebSocket. With its own --headless it makes no WebGL of software."""
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "serve"))
from web_socket import WebSocket  # noqa: E402

# No address of its maker's is asked for, and WebGL is drawn by software where there is nothing else.
PREFERENCES = {
    "webgl.force-enabled": True,
    "webgl.disabled": False,
    "layers.acceleration.force-enabled": False,
    "app.normandy.enabled": False,
    "app.update.auto": False,
    "browser.newtabpage.enabled": False,
    "browser.shell.checkDefaultBrowser": False,
    "browser.startup.homepage": "about:blank",
    "datareporting.policy.dataSubmissionEnabled": False,
    "extensions.getAddons.cache.enabled": False,
    "network.captive-portal-service.enabled": False,
    "network.connectivity-service.enabled": False,
    "services.settings.server": "data:,",
    "toolkit.telemetry.reportingpolicy.firstRun": False,
}


class Failed(Exception):
    """What the browser answered to a command, or what a page's script threw."""


class Firefox:
    def __init__(self, program="firefox-esr", width=960, height=640):
        self.profile = tempfile.mkdtemp(prefix="firefox.")
        with open(os.path.join(self.profile, "user.js"), "w") as file:
            for key, value in PREFERENCES.items():
                file.write(f"user_pref({json.dumps(key)}, {json.dumps(value)});\n")
        home = dict(os.environ, HOME=self.profile, MOZ_ENABLE_WAYLAND="0")
        self.process = subprocess.Popen([program, "--no-remote", "--profile", self.profile, "--remote-debugging-port=0"],
                                        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, env=home)
        self.number = 0
        self.events = []
        for line in self.process.stderr:
            found = re.search(r"WebDriver BiDi listening on ws://[^:]+:(\d+)", line)
            if found:
                break
        else:
            raise Failed("firefox ended before it listened")
        # Its further words are not read, so they must have room.
        self.drain = subprocess.Popen(["cat"], stdin=self.process.stderr, stdout=subprocess.DEVNULL)
        self.socket = WebSocket(int(found[1]), None, path="/session")
        self.socket.mask = os.urandom(3) + b"m"
        self.socket.socket.settimeout(300)
        self.about = self.command("session.new", capabilities={})["capabilities"]
        self.command("session.subscribe", events=["log.entryAdded", "network.beforeRequestSent"])
        self.tab = self.command("browsingContext.getTree")["contexts"][0]["context"]
        self.command("browsingContext.setViewport", context=self.tab, viewport={"width": width, "height": height},
                     devicePixelRatio=1)

    def command(self, method, **parameters):
        self.number += 1
        self.socket.send(json.dumps({"id": self.number, "method": method, "params": parameters}))
        while True:
            answer = json.loads(self.socket.message())
            if answer.get("type") == "event":
                self.events.append(answer)
            elif answer.get("id") == self.number:
                if answer["type"] == "error":
                    raise Failed(f"{method}: {answer['error']}: {answer['message']}")
                return answer["result"]

    def open(self, address):
        self.command("browsingContext.navigate", context=self.tab, url=address, wait="interactive")

    def ask(self, expression):
        """The value of an expression, of which a promise is awaited, by way of JSON."""
        result = self.command("script.evaluate", expression=f"(async () => JSON.stringify((await ({expression})) ?? null))()",
                              target={"context": self.tab}, awaitPromise=True, userActivation=True)
        if result["type"] != "success":
            raise Failed(result["exceptionDetails"]["text"])
        return json.loads(result["result"]["value"])

    def wait(self, condition):
        """Until an expression holds: the page itself looks after each frame of its own."""
        return self.ask("new Promise((done) => { const look = () => { const now = (" + condition + ");"
                        " if (now) done(now); else setTimeout(look, 5); }; look(); })")

    def drag(self, places, button=0):
        """With the mouse from place to place, in pixels of the page."""
        moves = [{"type": "pointerMove", "x": int(x), "y": int(y), "duration": 0} for x, y in places]
        self.command("input.performActions", context=self.tab, actions=[
            {"type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"},
             "actions": [moves[0], {"type": "pointerDown", "button": button}, *moves[1:],
                         {"type": "pointerUp", "button": button}]}])

    def press(self, key):
        self.command("input.performActions", context=self.tab, actions=[
            {"type": "key", "id": "keyboard", "actions": [{"type": "keyDown", "value": key}, {"type": "keyUp", "value": key}]}])

    def complaints(self):
        """What pages said as errors or warnings, and what they asked of a network."""
        found = []
        for event in self.events:
            about = event["params"]
            if event["method"] == "log.entryAdded" and about["level"] in ("error", "warn"):
                found.append(about["text"])
            elif event["method"] == "network.beforeRequestSent" and about.get("context") == self.tab:
                url = about["request"]["url"]
                if not re.match(r"(file|data|blob|about):", url):
                    found.append("asks the network for " + url[:200])
        return found

    def close(self):
        try:
            self.command("browser.close")
        except (ConnectionError, OSError, Failed):
            pass
        try:
            self.process.wait(20)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        self.drain.wait()
        shutil.rmtree(self.profile, ignore_errors=True)
