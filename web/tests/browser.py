"""The page in headless Chromium. A server in this process serves it."""

import base64
import contextlib
import functools
import http.server
import json
import pathlib
import shutil
import tempfile
import threading
import time

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "build-web" / "page"
LACUNA = ROOT / "build" / "lacuna"
PATIENCE = 180  # seconds, enough for a busy machine


class Handler(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass

    def end_headers(self):
        self.send_header("Cache-Control", "no-store")
        super().end_headers()

    def do_GET(self):
        if self.server.unanswered is None:
            return super().do_GET()
        self.server.unanswered.append(self.path)


class Server(http.server.ThreadingHTTPServer):
    request_queue_size = 128  # the default of 5 may be too few on a busy machine
    unanswered = None  # in place of None a list, when it answers nothing more


class Browser:
    def __init__(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        handler = functools.partial(Handler, directory=PAGE)
        self.server = Server(("127.0.0.1", 0), handler)
        threading.Thread(target=self.server.serve_forever, daemon=True).start()
        self.address = f"http://127.0.0.1:{self.server.server_port}/"
        options = Options()
        for argument in ("--headless=new", "--no-sandbox", "--disable-gpu",
                         "--disable-dev-shm-usage", "--hide-scrollbars"):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        self.driver = webdriver.Chrome(
            service=Service(shutil.which("chromedriver")), options=options)
        self.driver.set_window_size(1280, 800)
        self.driver.execute_cdp_cmd("Page.setDownloadBehavior",
                                    {"behavior": "allow", "downloadPath": str(self.folder)})

    def close(self):
        self.driver.quit()
        self.server.shutdown()
        shutil.rmtree(self.folder)

    def open(self):
        self.server.unanswered = None
        self.driver.get(self.address)
        self.wait_for("done")

    def run(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def element(self, name):
        return self.driver.find_element("id", name)

    def text(self, name):
        return self.element(name).text

    def state(self):
        return self.run("return document.documentElement.dataset.state")

    def until(self, condition, what):
        end = time.monotonic() + PATIENCE
        while not (found := condition()):
            if time.monotonic() >= end:
                told = f"{self.text('status')} {self.text('error')}"
                raise AssertionError(f"{what}: not within {PATIENCE} s; {told}")
            time.sleep(0.02)
        return found

    def wait_for(self, state):
        self.until(lambda: self.state() == state, f"state {state}")

    # Calls `change`, and waits until the page has made the new set, or has reached another state.
    def after(self, change, state="done"):
        self.run("delete document.documentElement.dataset.state")
        change()
        self.wait_for(state)

    def set(self, name, value):
        self.run("""const field = document.getElementById(arguments[0]);
            if (field.type === 'checkbox') field.checked = arguments[1];
            else field.value = arguments[1];
            for (const event of ['input', 'change'])
                field.dispatchEvent(new Event(event, { bubbles: true }));""", name, value)

    # Drops a file on the page, as a user does.
    def drop(self, name, content):
        self.run("""const bytes = Uint8Array.from(atob(arguments[1]), (c) => c.charCodeAt(0));
            const data = new DataTransfer();
            data.items.add(new File([bytes], arguments[0]));
            document.getElementById('view').dispatchEvent(
                new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true }));""",
                 name, base64.b64encode(content).decode())

    def paste(self, name, content):
        self.run("""const bytes = Uint8Array.from(atob(arguments[1]), (c) => c.charCodeAt(0));
            const data = new DataTransfer();
            data.items.add(new File([bytes], arguments[0]));
            document.dispatchEvent(new ClipboardEvent('paste', { clipboardData: data }));""",
                 name, base64.b64encode(content).decode())

    # What the view shows once what was asked for is painted, in the next frame but one.
    def looks(self):
        return self.run("""return new Promise((resolve) => requestAnimationFrame(() =>
            requestAnimationFrame(() => resolve(document.getElementById('view').toDataURL()))));""")

    # Returns the name and the bytes of the file.
    def download(self, kind):
        self.set("format", kind)
        return self.saved_by("download")

    def saved_by(self, button):
        for old in self.folder.iterdir():
            old.unlink()
        self.run("document.getElementById(arguments[0]).click()", button)
        # The browser first makes an empty file of that name, and later replaces it.
        finished = lambda: [file for file in self.folder.iterdir()
                            if file.suffix not in (".crdownload", ".tmp")
                            and not file.name.startswith(".") and file.stat().st_size > 0]
        file = self.until(finished, f"a file saved by {button}")[0]
        return file.name, file.read_bytes()

    # Errors and warnings in the console since the last call.
    def complaints(self):
        return [entry["message"] for entry in self.driver.get_log("browser")
                if entry["level"] in ("SEVERE", "WARNING")]

    # The addresses of all requests since the last call.
    def requests(self):
        messages = (json.loads(entry["message"])["message"]
                    for entry in self.driver.get_log("performance"))
        return [message["params"]["request"]["url"] for message in messages
                if message["method"] == "Network.requestWillBeSent"]

    # Begins work that lasts far longer than the test that ends it.
    def begin_long_work(self):
        self.run("delete document.documentElement.dataset.state")
        self.set("count", "1000000")
        self.until(lambda: self.element("progress").get_property("value") > 0, "some progress")

    @contextlib.contextmanager
    def screen(self, width, height, scheme):
        command = self.driver.execute_cdp_cmd
        command("Emulation.setDeviceMetricsOverride",
                {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 500})
        command("Emulation.setEmulatedMedia",
                {"features": [{"name": "prefers-color-scheme", "value": scheme}]})
        yield
        command("Emulation.clearDeviceMetricsOverride", {})
        command("Emulation.setEmulatedMedia", {"features": []})
