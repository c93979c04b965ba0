# SPDX-License-Identifier: MIT
"""A headless Chromium that the tests talk to through its debugging pipe, without any driver."""

import base64
import fcntl
import json
import os
import select
import shutil
import subprocess
import time

FLAGS = (
    "--headless",
    "--no-sandbox",
    "--disable-dev-shm-usage",
    "--disable-gpu",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--remote-debugging-pipe",
    "--no-first-run",
    "--hide-scrollbars",
    "--disable-background-networking",
    "--disable-component-update",
    "--force-color-profile=srgb",
)


def chromium():
    """Path of the browser; None if there is none."""
    names = ("chromium", "chromium-browser", "google-chrome")
    return next((path for path in map(shutil.which, names) if path), None)


class Page:
    """One page of a Chromium of its own. Messages, errors and requests are kept as they come."""

    def __init__(self, profile, width=1320, height=1000):
        command_in, self._out = os.pipe()  # Chromium reads commands from 3, writes to 4
        self._in, command_out = os.pipe()
        self._process = subprocess.Popen(
            [chromium(), *FLAGS, f"--user-data-dir={profile}", f"--window-size={width},{height}"],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            close_fds=False,
            preexec_fn=lambda: _become_3_and_4(command_in, command_out),
        )
        os.close(command_in)
        os.close(command_out)
        self._rest = b""
        self._number = 0
        self.console, self.errors, self.requests = [], [], []
        target = self._call("Target.createTarget", {"url": "about:blank"}, session=None)
        attach = {"targetId": target["targetId"], "flatten": True}
        self._session = self._call("Target.attachToTarget", attach, session=None)["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.call(f"{domain}.enable")
        size = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False}
        self.call("Emulation.setDeviceMetricsOverride", size)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._process.terminate()
        try:
            self._process.wait(10)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        os.close(self._out)
        os.close(self._in)

    def open(self, url):
        self.call("Page.navigate", {"url": url})

    def evaluate(self, expression):
        """The value of a JavaScript expression."""
        options = {"expression": expression, "returnByValue": True, "awaitPromise": True}
        answer = self.call("Runtime.evaluate", options)
        if "exceptionDetails" in answer:
            raise AssertionError(f"{expression}: {answer['exceptionDetails']}")
        return answer["result"].get("value")

    def wait_for(self, expression, seconds=900):
        """Waits until a JavaScript expression is true."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if self.evaluate(expression):
                return
            time.sleep(0.02)
        raise AssertionError(f"never became true: {expression}; errors: {self.errors}")

    def screenshot(self, path, whole=False):
        options = {"format": "png", "captureBeyondViewport": whole}
        if whole:
            size = self.call("Page.getLayoutMetrics")["cssContentSize"]
            options["clip"] = {
                "x": 0,
                "y": 0,
                "scale": 1,
                "width": size["width"],
                "height": size["height"],
            }
        data = self.call("Page.captureScreenshot", options)["data"]
        with open(path, "wb") as file:
            file.write(base64.b64decode(data))

    def call(self, method, parameters=None):
        """Sends a command of the DevTools protocol to the page and returns its result."""
        return self._call(method, parameters, self._session)

    def _call(self, method, parameters, session):
        self._number += 1
        message = {"id": self._number, "method": method, "params": parameters or {}}
        if session:
            message["sessionId"] = session
        os.write(self._out, json.dumps(message).encode() + b"\0")
        while True:
            answer = self._receive()
            if answer.get("id") == self._number:
                if "error" in answer:
                    raise AssertionError(f"{method}: {answer['error']}")
                return answer["result"]
            self._keep(answer)

    def _receive(self, seconds=900):
        while b"\0" not in self._rest:
            if not select.select([self._in], [], [], seconds)[0]:
                raise AssertionError("the browser does not answer")
            received = os.read(self._in, 1 << 20)
            if not received:
                raise AssertionError("the browser has ended")
            self._rest += received
        message, self._rest = self._rest.split(b"\0", 1)
        return json.loads(message)

    def _keep(self, event):
        what, parameters = event.get("method"), event.get("params", {})
        if what == "Runtime.exceptionThrown":
            self.errors.append(json.dumps(parameters["exceptionDetails"])[:2000])
        elif what == "Runtime.consoleAPICalled":
            text = " ".join(str(a.get("value", a.get("description"))) for a in parameters["args"])
            (self.errors if parameters["type"] in ("error", "assert") else self.console).append(
                text
            )
        elif what == "Log.entryAdded":
            entry = parameters["entry"]
            (self.errors if entry["level"] == "error" else self.console).append(entry["text"])
        elif what == "Network.requestWillBeSent":
            self.requests.append(parameters["request"]["url"])


def _become_3_and_4(commands, answers):
    """In the child: puts both ends of the pipes where Chromium looks for them."""
    # First to numbers above those that are about to be taken.
    commands, answers = (fcntl.fcntl(one, fcntl.F_DUPFD, 50) for one in (commands, answers))
    os.dup2(commands, 3)
    os.dup2(answers, 4)
