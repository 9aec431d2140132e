"""A browser without a window, for tests and pictures of reports: Chromium, driven over the WebDriver protocol by
chromedriver (Debian: chromium, chromium-driver). Needs nothing but Python's standard library.
"""
import base64
import json
import shutil
import socket
import subprocess
import time
import urllib.error
import urllib.request


class Browser:
    """with Browser(width, height) as browser: browser.open(path); browser.run("return document.title")"""

    CHROMIUM = ("chromium", "chromium-browser", "google-chrome")
    DRIVER = ("chromedriver", "chromium.chromedriver")

    @classmethod
    def missing(cls):
        """The name of the program that is missing, or None."""
        for names in (cls.CHROMIUM, cls.DRIVER):
            if not any(map(shutil.which, names)):
                return names[0]
        return None

    def __init__(self, width=1440, height=900, scale=1, dark=False, mobile=False):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        driver = next(filter(None, map(shutil.which, self.DRIVER)))
        self.process = subprocess.Popen([driver, f"--port={port}", "--log-level=OFF"], stdout=subprocess.DEVNULL,
                                        stderr=subprocess.DEVNULL)
        self.session = f"http://127.0.0.1:{port}"
        try:
            self._wait_for_driver()
            arguments = ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--use-angle=swiftshader",
                         "--enable-unsafe-swiftshader", "--hide-scrollbars", "--force-color-profile=srgb"]
            options = {"args": arguments, "binary": next(filter(None, map(shutil.which, self.CHROMIUM)))}
            answer = self._post("/session", {"capabilities": {"alwaysMatch": {
                "browserName": "chrome", "goog:chromeOptions": options, "goog:loggingPrefs": {"browser": "ALL"}}}})
            self.session += "/session/" + answer["sessionId"]
            self.resize(width, height, scale, mobile)
            self.set_dark(dark)
        except BaseException:
            self.__exit__()
            raise

    def __enter__(self):
        return self

    def __exit__(self, *_):
        try:
            if "/session/" in self.session:
                self._request("DELETE", "")
        finally:
            self.process.terminate()
            self.process.wait()

    def open(self, path):
        """Opens a file, and waits until the report that it holds is drawn."""
        self._post("/url", {"url": "file://" + str(path)})
        self._post("/timeouts", {"script": 60000})
        error = self._post("/execute/async", {
            "script": "report.then(() => arguments[0](), e => arguments[0](String(e)))", "args": []})
        if error:
            raise RuntimeError(f"{path}: {error}")
        self.settle()

    def run(self, script, *arguments):
        """The value that a piece of JavaScript returns."""
        return self._post("/execute/sync", {"script": script, "args": list(arguments)})

    def settle(self):
        """Waits until what was asked for is on the screen."""
        self._post("/execute/async", {"script": "requestAnimationFrame(() => requestAnimationFrame(() => "
                                                "arguments[0]()))", "args": []})

    def log(self):
        """What the console got since the last call: a list of {level, message, ...}."""
        return self._post("/se/log", {"type": "browser"})

    def devtools(self, command, **parameters):
        return self._post("/goog/cdp/execute", {"cmd": command, "params": parameters})

    def resize(self, width, height, scale=1, mobile=False):
        self.devtools("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=scale,
                      mobile=mobile)
        self.devtools("Emulation.setTouchEmulationEnabled", enabled=mobile)

    def set_dark(self, dark):
        self.devtools("Emulation.setEmulatedMedia",
                      features=[{"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])

    def screenshot(self, element=None, scale=1):
        """The whole page, or the first element that matches a selector, as the bytes of a PNG file."""
        box = self.run("""
            const e = arguments[0] ? document.querySelector(arguments[0]) : document.documentElement;
            const r = e.getBoundingClientRect();
            return {x: r.left + scrollX, y: r.top + scrollY, width: r.width,
                    height: arguments[0] ? r.height : document.documentElement.scrollHeight};""", element)
        answer = self.devtools("Page.captureScreenshot", format="png", captureBeyondViewport=True,
                               clip={**box, "scale": scale})
        return base64.b64decode(answer["data"])

    def move_to(self, x, y):
        """Moves the mouse to a place of the window."""
        self._act("pointer", [{"type": "pointerMove", "duration": 0, "x": round(x), "y": round(y)}])

    def drag(self, x, y, dx, dy):
        self._act("pointer", [{"type": "pointerMove", "duration": 0, "x": round(x), "y": round(y)},
                              {"type": "pointerDown", "button": 0},
                              {"type": "pointerMove", "duration": 50, "x": round(x + dx), "y": round(y + dy)},
                              {"type": "pointerUp", "button": 0}])

    def press(self, *keys):
        """Keys as WebDriver names them: characters, or private code points such as LEFT."""
        self._act("key", [{"type": kind, "value": key} for key in keys for kind in ("keyDown", "keyUp")])

    TAB, ENTER, ESCAPE, LEFT, RIGHT = "\ue004", "\ue007", "\ue00c", "\ue012", "\ue014"

    def _act(self, kind, actions):
        self._post("/actions", {"actions": [{"type": kind, "id": kind, "actions": actions}]})
        self.settle()

    def _wait_for_driver(self):
        for _ in range(200):
            try:
                if self._request("GET", "/status")["ready"]:
                    return
            except OSError:
                pass
            time.sleep(0.05)
        raise RuntimeError("chromedriver does not answer")

    def _post(self, path, body):
        return self._request("POST", path, body)

    def _request(self, method, path, body=None):
        request = urllib.request.Request(self.session + path, method=method,
                                         data=None if body is None else json.dumps(body).encode(),
                                         headers={"Content-Type": "application/json"})
        try:
            with urllib.request.urlopen(request, timeout=120) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise RuntimeError(json.load(error)["value"]["message"].splitlines()[0]) from None
