# SPDX-License-Identifier: MIT
"""Firefox on a screen that nobody sees, asked by WebDriver BiDi, which it speaks itself.

Without any screen (--headless) Debian's gives no WebGL: Xvfb is one in memory.
"""

import contextlib
import itertools
import json
import os
import re
import shutil
import subprocess
import threading

BINARY = shutil.which("firefox-esr") or shutil.which("firefox")

PREFERENCES = {
    "webgl.force-enabled": True,  # drawn by software, too
    "ui.prefersReducedMotion": 1,  # no start scene
    "app.update.auto": False,
    "browser.shell.checkDefaultBrowser": False,
    "datareporting.policy.dataSubmissionEnabled": False,
    "remote.active-protocols": 1,
}


class Firefox:
    """One browser with one tab; a context manager. `profile` is an empty folder for it."""

    def __init__(self, profile):
        from websockets.sync.client import connect

        rows = [f"user_pref({json.dumps(k)}, {json.dumps(v)});" for k, v in PREFERENCES.items()]
        (profile / "user.js").write_text("\n".join(rows))
        self._open = contextlib.ExitStack()
        self.screen = subprocess.Popen(
            ["Xvfb", "-displayfd", "1", "-screen", "0", "1280x900x24"],
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
        )
        display = f":{self.screen.stdout.readline().strip()}"
        self.process = subprocess.Popen(
            [BINARY, "--no-remote", "--profile", profile, "--remote-debugging-port=0"],
            env={**os.environ, "DISPLAY": display, "LIBGL_ALWAYS_SOFTWARE": "1"},
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
        )
        address = self._address()
        threading.Thread(target=self.process.stderr.read, daemon=True).start()  # or it would fill
        opened = connect(f"{address}/session", max_size=None, compression=None)
        self.socket = self._open.enter_context(opened)
        self._numbers = itertools.count(1)
        self.ask("session.new", capabilities={})
        self.tab = self.ask("browsingContext.getTree")["contexts"][0]["context"]

    def _address(self):
        for line in self.process.stderr:
            if found := re.search(r"WebDriver BiDi listening on (ws://\S+)", line):
                return found[1]
        raise AssertionError("Firefox did not start")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._open.close()
        for process in (self.process, self.screen):
            process.terminate()
            process.wait(900)

    def ask(self, method, **params):
        """The result of a command; events are passed over."""
        number = next(self._numbers)
        self.socket.send(json.dumps({"id": number, "method": method, "params": params}))
        while True:
            reply = json.loads(self.socket.recv(timeout=900))
            if reply.get("id") == number:
                assert reply["type"] == "success", reply
                return reply["result"]

    def open(self, address):
        """Waits until the page has been loaded."""
        self.ask("browsingContext.navigate", context=self.tab, url=address, wait="complete")

    def tell(self, code):
        """What an expression, or the promise that it is, comes to; by JSON."""
        made = f"(async () => JSON.stringify(await ({code})))()"
        result = self.ask(
            "script.evaluate", expression=made, awaitPromise=True, target={"context": self.tab}
        )
        assert result["type"] == "success", result
        value = result["result"].get("value")
        return None if value is None else json.loads(value)

    def mouse(self, *actions):
        """Actions as BiDi has them: pointerDown, pointerMove and so on."""
        source = {"type": "pointer", "id": "mouse", "actions": list(actions)}
        self.ask("input.performActions", context=self.tab, actions=[source])
