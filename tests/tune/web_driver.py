"""A headless Chromium, by chromedriver's W3C WebDriver protocol: JSON over HTTP."""
import base64
import json
import shutil
import socket
import subprocess
import time
import urllib.error
import urllib.request


def missing():
    """What is not on this machine; empty: all is."""
    browsers = ("chromium", "chromium-browser", "google-chrome")
    if not shutil.which("chromedriver"):
        return "chromedriver"
    return "" if any(map(shutil.which, browsers)) else "chromium"


class WebDriverError(Exception):
    pass


class Browser:
    """One browser with tabs. Ends with its scope."""

    def __init__(self, folder):
        """Downloads go to the folder."""
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self.port = free.getsockname()[1]
        self.driver = subprocess.Popen(["chromedriver", f"--port={self.port}"], stdout=subprocess.DEVNULL,
                                       stderr=subprocess.DEVNULL)
        self.session = ""
        self._wait_for_driver()
        options = {"args": ["--headless=new", "--no-sandbox", "--disable-gpu", "--window-size=1400,900",
                            "--force-device-scale-factor=1", f"--user-data-dir={folder}/profile"],
                   "prefs": {"download.default_directory": folder, "download.prompt_for_download": False}}
        capabilities = {"alwaysMatch": {"goog:chromeOptions": options}}
        self.session = "/" + self._ask("POST", "session", {"capabilities": capabilities})["sessionId"]
        self.call("POST", "timeouts", {"script": 30000, "pageLoad": 30000})

    def __enter__(self):
        return self

    def __exit__(self, *_):
        try:
            self.call("DELETE", "")
        finally:
            self.driver.terminate()
            self.driver.wait()

    def _wait_for_driver(self):
        for _ in range(200):
            try:
                self._ask("GET", "status")
                return
            except urllib.error.URLError:
                time.sleep(0.05)
        raise WebDriverError("expected chromedriver to answer within 10 s, found silence")

    def _ask(self, method, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(f"http://127.0.0.1:{self.port}/{path}", data, method=method,
                                         headers={"Content-Type": "application/json"})
        try:
            with urllib.request.urlopen(request, timeout=60) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise WebDriverError(json.load(error)["value"]["message"]) from None

    def call(self, method, path, body=None):
        tail = f"/{path}" if path else ""
        return self._ask(method, f"session{self.session}{tail}", {} if body is None and method == "POST" else body)

    def command(self, name, **parameters):
        """A command of Chromium's own protocol."""
        return self.call("POST", "goog/cdp/execute", {"cmd": name, "params": parameters})

    def open(self, address):
        self.call("POST", "url", {"url": address})

    def new_tab(self, address):
        """Returns the tab's handle; it is the current one then."""
        tab = self.call("POST", "window/new", {"type": "tab"})["handle"]
        self.switch_to(tab)
        self.open(address)
        return tab

    def tab(self):
        return self.call("GET", "window")

    def switch_to(self, tab):
        self.call("POST", "window", {"handle": tab})

    def run(self, script, *arguments):
        return self.call("POST", "execute/sync", {"script": script, "args": list(arguments)})

    def run_async(self, script, *arguments):
        """The script's last argument takes its result."""
        return self.call("POST", "execute/async", {"script": script, "args": list(arguments)})

    def wait(self, what, condition, *arguments, seconds=20):
        """Until a JavaScript expression is true; returns it."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if value := self.run(f"return {condition}", *arguments):
                return value
            time.sleep(0.03)
        said = self.run("return document.getElementById('status').innerText")
        raise AssertionError(f"expected {what} within {seconds} s, found none; the page says: {said}")

    def point(self, *actions):
        """Moves and presses a mouse: texts "down", "up" and positions (x, y) in the window."""
        steps = []
        for action in actions:
            if isinstance(action, str):
                steps.append({"type": "pointer" + action.capitalize(), "button": 0})
            else:
                steps.append({"type": "pointerMove", "duration": 40, "x": int(action[0]), "y": int(action[1])})
        mouse = {"type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"}, "actions": steps}
        self.call("POST", "actions", {"actions": [mouse]})

    def wheel(self, x, y, delta):
        step = {"type": "scroll", "x": int(x), "y": int(y), "deltaX": 0, "deltaY": delta, "duration": 0}
        self.call("POST", "actions", {"actions": [{"type": "wheel", "id": "wheel", "actions": [step]}]})

    def pinch(self, x, y, begin, end):
        """Two fingers to the left and the right of a position, at first so far from it, then so far."""
        fingers = []
        for side in (-1, 1):
            at = [{"type": "pointerMove", "duration": 40, "x": int(x + side * away), "y": int(y)}
                  for away in (begin, end)]
            fingers.append({"type": "pointer", "id": f"finger{side}", "parameters": {"pointerType": "touch"},
                            "actions": [at[0], {"type": "pointerDown", "button": 0}, at[1],
                                        {"type": "pointerUp", "button": 0}]})
        self.call("POST", "actions", {"actions": fingers})

    def click(self, selector):
        self.point(self.run("""const element = document.querySelector(arguments[0]);
            element.scrollIntoView({block: "nearest"});
            const box = element.getBoundingClientRect();
            return [box.left + box.width / 2, box.top + box.height / 2]""", selector), "down", "up")

    def keys(self, *keys):
        """Types keys, those of a tuple held together."""
        steps = []
        for key in keys:
            held = key if isinstance(key, tuple) else (key,)
            steps += [{"type": "keyDown", "value": each} for each in held]
            steps += [{"type": "keyUp", "value": each} for each in reversed(held)]
        self.call("POST", "actions", {"actions": [{"type": "key", "id": "keys", "actions": steps}]})

    def picture(self, name):
        """Writes the window to a PNG."""
        with open(name, "wb") as file:
            file.write(base64.b64decode(self.call("GET", "screenshot")))
