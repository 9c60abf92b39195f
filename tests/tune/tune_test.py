#!/usr/bin/env python3
"""The live page: who may ask for it, what it draws, what is taken away from it, and when it ends.

usage: tune_test.py SOURCE COMMAND [FOLDER]; exit status 77: there is no Chromium, and the rest has passed
FOLDER: pictures of the page are left there
"""
import http.client
import json
import os
import pty
import re
import shlex
import signal
import subprocess
import sys
import tempfile
import time

import web_driver

LEFT = "\ue012"
SHIFT = "\ue008"


class Tune:
    """inkedge tune of the bracket, small enough to be drawn at once. Ends with its scope."""

    def __init__(self, command, model, *flags, **options):
        self.child = subprocess.Popen([command, "tune", model, *flags], stdout=subprocess.PIPE,
                                      stderr=subprocess.PIPE, text=True, **options)
        self.address = self.child.stdout.readline().strip()
        found = re.fullmatch(r"http://127\.0\.0\.1:(\d+)/\?token=([0-9a-f]{32})", self.address)
        assert found, self.address + self.child.stderr.read()
        self.port, self.token = int(found[1]), found[2]

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.child.kill()
        self.child.communicate()

    def ask(self, method, path, body=None, **headers):
        """Status, headers and body of an answer; headers that are None are left out."""
        all_headers = {"X-Inkedge-Token": self.token, "Host": f"127.0.0.1:{self.port}", **headers}
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=30)
        connection.putrequest(method, path, skip_host=True, skip_accept_encoding=True)
        data = b"" if body is None else json.dumps(body).encode()
        for name, value in {**all_headers, "Content-Length": str(len(data))}.items():
            if value is not None:
                connection.putheader(name.replace("_", "-"), value)
        connection.endheaders(data)
        answer = connection.getresponse()
        return answer.status, answer.headers, answer.read()

    def picture(self, settings=None, **more):
        status, headers, body = self.ask("POST", "/picture", {"settings": settings or {}, **more})
        assert status == 200, body
        about = json.loads(headers["X-Inkedge-Picture"])
        return body[:about["bytes"]], about


class Requests:
    """What needs no browser."""

    def __init__(self, command, model):
        self.command, self.model = command, model

    def check(self):
        with Tune(self.command, self.model, "--size", "160x120") as tune:
            self.check_refusals(tune)
            self.check_pictures(tune)
            self.check_latest_wins(tune)
        self.check_taken_port()
        self.check_ends()

    def check_refusals(self, tune):
        other = "0" * 32
        requests = [("GET", "/", None), ("GET", "/beginning", None), ("POST", "/picture", {"settings": {}}),
                    ("POST", "/texts", {"settings": {}}), ("POST", "/hover", {"settings": {}}),
                    ("POST", "/file", {"settings": {}}), ("GET", "/nothing", None), ("PUT", "/", {}),
                    ("DELETE", "/", {})]
        for method, path, body in requests:
            refused = {"X_Inkedge_Token": other}, {"X_Inkedge_Token": None}, {"X_Inkedge_Token": tune.token[:-1]}, \
                {"Host": f"attacker.example:{tune.port}"}, {"Host": "127.0.0.1"}, {"Host": None}, \
                {"Origin": "http://attacker.example"}, {"Origin": "null"}, {"Origin": "https://127.0.0.1"}
            for headers in refused:
                headers = {key.replace("_", "-"): value for key, value in headers.items()}
                status, _, text = tune.ask(method, path, body, **headers)
                assert status == 403 or (headers == {"Host": None} and status == 400), (method, path, headers, status)
                assert tune.token.encode() not in text
        status, headers, text = tune.ask("GET", f"/?token={tune.token}", **{"X-Inkedge-Token": None})
        assert status == 200 and "default-src 'none'" in headers["Content-Security-Policy"]
        assert not re.search(rb'(src|href)="(?!data:,)', text), "it names no other file"
        assert tune.ask("GET", f"/?token={other}", **{"X-Inkedge-Token": None})[0] == 403
        for path in ("/page.js", "/../CMakeLists.txt", "/etc/passwd", "//etc/passwd", "/bracket.glb", "/%2e%2e/x"):
            assert tune.ask("GET", path)[0] == 404, path
        own = {"Origin": f"http://127.0.0.1:{tune.port}"}
        assert tune.ask("GET", "/beginning", **own)[0] == 200
        assert tune.ask("GET", "/beginning", Host=f"localhost:{tune.port}")[0] == 200
        for address in other_addresses():
            try:
                http.client.HTTPConnection(address, tune.port, timeout=2).request("GET", "/")
                raise AssertionError(f"expected no server at {address}, found one")
            except OSError:
                pass

    def check_pictures(self, tune):
        full, about = tune.picture({"size": "161x120", "line-width": "3"})
        assert full == self.drawn("--size", "161x120", "--line-width=3") and about["size"] == [161, 120]
        half, about = tune.picture({"size": "161x120", "line-width": "3"}, half=True)
        assert about["size"] == [81, 60], about
        assert half == self.drawn("--size", "81x60", "--line-width", "1.5", "--dpi", "48")
        _, about = tune.picture({"size": "64x64", "maps": "depth,ids,types"})
        assert [layer["map"] for layer in about["layers"]] == ["depth", "ids", "types"], about
        status, _, text = tune.ask("POST", "/picture", {"settings": {"line-width": "99"}})
        assert status == 400 and json.loads(text)["error"].startswith("--line-width: expected"), text
        for body in ({}, {"settings": {"size": 3}}, {"settings": {"none": "1"}},
                     {"settings": {}, "output": "../a.png"}):
            assert tune.ask("POST", "/file", body)[0] == 400, body
        status, _, text = tune.ask("POST", "/texts", {"settings": {"page-size": "A4", "line-style": "outline:width=3"}})
        texts = json.loads(text)
        assert "'--line-style=" not in texts["command"] and texts["config"].count("\n") == 3, texts
        assert list(texts["idle"]) == ["page-size"], texts

    def drawn(self, *flags):
        subprocess.run([self.command, "render", self.model, "-o", "own.png", *flags], check=True)
        with open("own.png", "rb") as file:
            return file.read()

    @staticmethod
    def check_latest_wins(tune):
        assert tune.ask("POST", "/picture", {"settings": {"size": "32x32"}, "tab": "a", "number": 5})[0] == 200
        assert tune.ask("POST", "/picture", {"settings": {"size": "32x32"}, "tab": "a", "number": 4})[0] == 204
        assert tune.ask("POST", "/picture", {"settings": {"size": "32x32"}, "tab": "b", "number": 1})[0] == 200

    def check_taken_port(self):
        with Tune(self.command, self.model) as tune:
            second = subprocess.run([self.command, "tune", self.model, "--port", str(tune.port)], capture_output=True,
                                    text=True, check=False, timeout=20)
            assert second.returncode == 1 and "is taken" in second.stderr and second.stderr.count("\n") == 1, second

    def check_ends(self):
        for number, status in ((signal.SIGINT, 130), (signal.SIGTERM, 143), (signal.SIGHUP, 129)):
            with Tune(self.command, self.model) as tune:
                tune.child.send_signal(number)
                assert tune.child.wait(timeout=5) == status, number
        master, slave = pty.openpty()
        with Tune(self.command, self.model, stdin=slave, start_new_session=True, preexec_fn=take_terminal) as tune:
            tune.picture({"size": "64x64"})
            os.close(slave)
            os.close(master)  # the terminal is closed
            assert tune.child.wait(timeout=5) == 129


def take_terminal():
    """Makes stdin the terminal that this process is controlled by."""
    import fcntl
    import termios
    fcntl.ioctl(0, termios.TIOCSCTTY, 0)


def other_addresses():
    """Those of this machine that others may reach."""
    done = subprocess.run(["hostname", "-I"], capture_output=True, text=True, check=False)
    return [address for address in done.stdout.split() if ":" not in address]


class Page:
    """What people do, in a browser."""

    def __init__(self, command, model, tune, browser):
        self.command, self.model, self.tune, self.browser = command, model, tune, browser
        browser.command("Browser.grantPermissions", permissions=["clipboardReadWrite", "clipboardSanitizedWrite"])
        browser.open(tune.address)
        self.settled()

    def settled(self):
        """Waits for the full picture of the settings as they are."""
        self.browser.wait("a full picture", "document.body.dataset.drawn === 'full' && !underway && !wanted")

    def shown(self):
        """The bytes of the PNG that is shown."""
        return bytes(self.browser.run_async("""const done = arguments[0];
            shown.png.arrayBuffer().then(bytes => done([...new Uint8Array(bytes)]))"""))

    def value(self, name):
        return self.browser.run("return values[arguments[0]] || ''", name)

    def middle(self):
        return self.browser.run("""const b = $('sheet').getBoundingClientRect();
            return [b.left + b.width / 2, b.top + b.height / 2]""")

    def copied(self, kind):
        self.browser.click(f"[data-kind={kind}]")
        self.browser.click("#copy")
        self.browser.wait("a copy", "$('copy').textContent === 'Copied'")
        text = self.browser.run_async("navigator.clipboard.readText().then(arguments[0])")
        self.browser.wait("the button as it was", "$('copy').textContent === 'Copy'")
        return text

    def check_drag(self):
        before = self.shown()
        self.browser.run("""window.drawn = [];
            new MutationObserver(records => drawn.push(...records.map(record => record.oldValue)))
                .observe(document.body, {attributes: true, attributeOldValue: true})""")
        x, y = self.middle()
        self.browser.point((x, y), "down", (x + 40, y - 10), (x + 80, y - 25))
        self.browser.wait("a picture of half the size", "shown.half || drawn.includes('half')")
        self.browser.point("up")
        self.settled()
        assert self.value("camera-azimuth-angle") == "-2" and self.value("camera-elevation-angle") == "10", \
            self.browser.run("return values")
        after = self.shown()
        assert after != before
        flags = ["--size", "320x240", "--azimuth", "-2", "--elevation", "10"]
        assert after == Requests(self.command, self.model).drawn(*flags), "what is shown is what the command draws"

    def check_keys(self):
        self.browser.run("$('stage').focus()")
        self.browser.keys(LEFT, (SHIFT, LEFT), "+")
        self.settled()
        assert self.value("camera-azimuth-angle") == "3" and self.value("camera-zoom-factor") == "1.1"
        assert self.value("camera-focal-point").count(",") == 2
        self.browser.keys("0")
        self.settled()
        assert not self.value("camera-azimuth-angle") and not self.value("camera-zoom-factor")

    def check_wheel_and_touch(self):
        self.browser.wheel(*self.middle(), -100)
        self.browser.wait("a larger picture", "values['camera-zoom-factor'] > 1")
        self.settled()
        self.browser.run("frameAll()")
        self.browser.pinch(*self.middle(), 40, 80)
        self.browser.wait("a larger picture", "values['camera-zoom-factor'] > 1.5")
        self.browser.run("frameAll()")
        self.settled()

    def check_pan_keeps_camera(self):
        """Moved there and back, the picture is as it was."""
        before = self.browser.run("return shown.camera.eye")
        self.browser.run("pan(30, 20); pan(-30, -20); draw(false)")
        self.settled()
        after = self.browser.run("return shown.camera.eye")
        assert all(abs(a - b) < 1e-4 * max(map(abs, before)) for a, b in zip(before, after)), (before, after)
        self.browser.run("frameAll()")
        self.settled()

    def check_slider(self):
        """Someone looks for heavier outlines and takes them away."""
        before = self.shown()
        self.browser.run("$('search').focus()")
        self.browser.keys(*"heavier outlines")
        found = self.browser.run("""return [...document.querySelectorAll('.row')].filter(row => row.offsetParent)
            .map(row => row.dataset.name)""")
        assert "line-style" in found and len(found) < 8, found
        slider = "document.querySelector('[data-pen=outline]')"
        x, y = self.browser.run(f"""{slider}.scrollIntoView({{block: 'center'}});
            const b = {slider}.getBoundingClientRect(); return [b.left + b.width * 0.4, b.top + b.height / 2]""")
        self.browser.point((x, y), "down", "up")
        self.settled()
        after = self.shown()
        assert after != before and self.value("line-style").startswith("outline:width=")
        self.browser.run("$('search').value = ''; find()")
        self.check_copies(after)

    def check_copies(self, shown):
        command = self.copied("command")
        words = shlex.split(command)
        assert words[:2] == ["inkedge", "render"] and "-o drawing.png" in command, command
        subprocess.run([self.command, *words[1:]], check=True)
        assert read("drawing.png") == shown, command
        with open("tune.conf", "w", encoding="utf-8") as file:
            file.write(self.copied("config"))
        subprocess.run([self.command, "render", self.model, "-o", "config.png", "--config", "tune.conf"], check=True)
        assert read("config.png") == shown, read("tune.conf")
        text = self.copied("python")
        compile(text, "python", "exec")
        if subprocess.run([sys.executable, "-c", "import inkedge"], capture_output=True, check=False).returncode == 0:
            os.remove("drawing.png")
            subprocess.run([sys.executable, "-c", text], check=True)
            assert pixels(self.command, "drawing.png", "config.png"), text

    def check_downloads(self):
        for output in ("drawing.png", "drawing.svg", "drawing.pdf"):
            if os.path.exists(output):
                os.remove(output)
            self.browser.click(f"[data-file='{output}']")
            wait_for(lambda name=output: os.path.exists(name) and os.path.getsize(name) > 0, f"{output} to be there")
            flags = shlex.split(self.copied("command"))[3:]
            os.makedirs("own", exist_ok=True)
            flags[flags.index("-o") + 1] = "own/" + output
            subprocess.run([self.command, "render", self.model, *flags], check=True)
            assert read(output) == read("own/" + output), output

    def check_layers(self):
        self.browser.run("""const chip = text => [...document.querySelectorAll('.strip button')]
            .find(button => button.textContent === text); chip('depth').click(); chip('crease').click()""")
        self.settled()
        assert self.value("maps") == "depth" and self.browser.run("return shown.layers.length") == 1
        assert "crease" not in self.value("lines").split(",") and self.value("lines")
        self.browser.run("put({maps: '', lines: ''})")
        self.settled()
        assert not self.value("lines")

    def check_hover(self):
        x, y = self.middle()
        self.browser.point((x, y), (x + 1, y))
        text = self.browser.wait("what is there", "!$('hover').hidden && $('hover').textContent")
        assert re.search(r"bracket.*patch \d+", text), text
        edge = self.browser.run("""const c = $('picture').getContext('2d').getImageData(0, 0, 320, 240).data;
            for (let i = 0; i < c.length; i += 4) if (c[i] < 60) return [i / 4 % 320, Math.floor(i / 4 / 320)]""")
        left, top, scale = self.browser.run("""const b = $('sheet').getBoundingClientRect();
            return [b.left, b.top, b.width / 320]""")
        self.browser.point((left + (edge[0] + 0.5) * scale, top + (edge[1] + 0.5) * scale))
        self.browser.wait("an outline", "!$('hover').hidden && $('hover').textContent.includes('outline')")

    def check_before_after(self):
        before = self.shown()
        self.browser.run("$('compare').click(); put({'line-width': '6'})")
        self.settled()
        sides = self.browser.run("""const sum = id => $(id).getContext('2d').getImageData(0, 0, 320, 240).data
            .reduce((a, b) => a + b); return [sum('before'), sum('picture'), $('before').style.clipPath]""")
        assert sides[0] > sides[1] and "50%" in sides[2], sides
        self.browser.run("$('compare').click(); put({'line-width': ''})")
        self.settled()
        assert self.shown() == before

    def check_every_setting(self):
        """Each has a row in the group of the help, and can be reset."""
        shown = self.browser.run("""return model.settings.map(s => [s.name, s.group,
            rows[s.name].row.closest('details').querySelector('summary').firstChild.textContent])""")
        text = subprocess.run([self.command, "render", "--help"], capture_output=True, text=True, check=True).stdout
        assert len(shown) > 60 and all(group == heading and f"--{name}" in text for name, group, heading in shown)
        layout = self.layout()
        self.browser.run("put({dpi: '50', shade: 'gooch'})")
        self.settled()
        assert self.browser.run("return document.querySelectorAll('.row.changed').length") == 4  # size, line-style
        self.browser.run("document.querySelector('.row[data-name=dpi] .head button').click()")
        assert not self.value("dpi") and self.value("shade")
        self.browser.run("$('reset').click()")
        assert self.browser.run("return document.querySelectorAll('.row.changed').length") == 0
        self.browser.run("put({size: '320x240', 'line-width': '99'})")
        self.browser.wait("an error", "document.querySelector('.row.wrong[data-name=line-width]')")
        assert self.layout() == layout
        self.browser.run("""put({'line-width': '', style: 'pencil', hidden: 'dashed', 'page-size': 'A4', only: 'bracket',
            light: '10,20', shade: 'light', 'camera-view-up': '0,1,0.1', 'line-color': '#123456', background: '#fedcba',
            'stroke-taper': '3', 'pencil-seed': '7', 'pencil-strokes': '3', tolerance: '0.2', contour: 'smooth'})""")
        self.settled()
        self.browser.wait("word of what is idle", "document.querySelector('.row.idle[data-name=page-size]')")
        assert self.layout() == layout
        self.browser.run("put(defaultsOf(Object.keys(values).filter(name => name !== 'size')))")
        self.settled()
        assert not self.browser.run("return document.querySelector('.row.wrong')")

    def check_two_tabs(self):
        first, before = self.browser.tab(), self.shown()
        second = self.browser.new_tab(self.tune.address)
        self.settled()
        self.browser.run("put({'line-width': '5', 'crease-angle': '10'})")
        self.settled()
        changed = self.shown()
        self.browser.switch_to(first)
        self.browser.run("put({'line-width': '2'}); put({'line-width': ''})")
        self.settled()
        assert self.shown() == before and not self.value("line-width")
        self.browser.switch_to(second)
        assert self.shown() == changed != before and self.value("line-width") == "5"
        self.browser.call("DELETE", "window")
        self.browser.switch_to(first)

    def check_end(self):
        self.tune.child.terminate()
        assert self.tune.child.wait(timeout=5) == 143
        self.browser.run("draw(false)")
        self.browser.wait("word that it has ended", "!$('gone').hidden")

    def check(self):
        before = self.layout()
        for check in (self.check_drag, self.check_keys, self.check_wheel_and_touch, self.check_pan_keeps_camera,
                      self.check_slider, self.check_downloads, self.check_layers, self.check_hover,
                      self.check_before_after, self.check_every_setting, self.check_two_tabs):
            check()
            assert self.layout() == before, check.__name__

    def layout(self):
        """Where what stays there is."""
        return self.browser.run("""return ['bar', 'layers', 'stage', 'status', 'take', 'text', 'panel']
            .map(id => JSON.stringify($(id).getBoundingClientRect()))""")


def read(name):
    with open(name, "rb") as file:
        return file.read()


def pixels(command, a, b):
    """Whether two pictures have the same."""
    return subprocess.run([command, "compare", a, b], capture_output=True, check=False).returncode == 0


def wait_for(condition, what, seconds=10):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, f"expected {what} within {seconds} s"
        time.sleep(0.03)


def main():
    source, command = map(os.path.abspath, sys.argv[1:3])
    model = os.path.join(source, "assets", "bracket.glb")
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        Requests(command, model).check()
        missing = web_driver.missing()
        if not missing:
            with web_driver.Browser(folder) as browser, Tune(command, model, "--size", "320x240") as tune:
                page = Page(command, model, tune, browser)
                page.check()
                page.check_end()
        os.chdir(source)
    if missing:
        print(f"SKIPPED in part: expected {missing}, found none; install chromium and chromium-driver", flush=True)
        sys.exit(77)
    print("the page draws what the command draws, for nobody else, until its terminal is closed")


if __name__ == "__main__":
    main()
