"""What all tests of the page share: a browser, pictures, and comparing files with the command's."""

import hashlib
import pathlib
import shlex
import struct
import subprocess
import tempfile
import unittest
import zlib

from selenium.webdriver.common.action_chains import ActionChains

from browser import LACUNA, ROOT, Browser

# A script's pixels that the view shows, and the sides of it.
SHOWN = """const copy = document.createElement('canvas'), view = document.getElementById('view');
    const [width, height] = [copy.width, copy.height] = [view.width, view.height];
    const context = copy.getContext('2d', { willReadFrequently: true });
    context.drawImage(view, 0, 0);
    const data = context.getImageData(0, 0, width, height).data;"""
RACCOON = (ROOT / "examples" / "raccoon.png").read_bytes()


def png(columns, rows, channels, pixel, depth=8):
    """The bytes of a PNG whose sample is pixel(column, row, channel); a 16-bit one has these bytes twice."""
    def chunk(kind, data):
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))
    lines = b"".join(b"\0" + bytes(pixel(x, y, c) for x in range(columns) for c in range(channels) for _ in range(depth // 8))
                     for y in range(rows))
    colour = {1: 0, 3: 2, 4: 6}[channels]
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", columns, rows, depth, colour, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(lines)) + chunk(b"IEND", b""))


class PageCase(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.browser = Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()

    def setUp(self):
        self.browser.open()
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def tearDown(self):
        page = self.browser
        self.assertEqual(page.complaints(), [])
        outside = [url for url in page.requests() if not url.startswith((page.address, "blob:", "data:"))]
        self.assertEqual(outside, [])

    def given(self, name, content=RACCOON):
        """Drops a picture onto the page, and writes it to the folder where the command runs."""
        (self.folder / name).write_bytes(content)
        self.browser.after(lambda: self.browser.drop(name, content))

    def assert_the_commands_bytes(self, kind, command=None):
        """Checks that the file saved is the file that the command shown on the page makes, or this one."""
        name, saved = self.browser.download(kind)
        command = shlex.split(command or self.browser.text("command"))
        self.assertEqual(command[0], "lacuna")
        self.assertEqual(command[-2:], ["-o", name])
        subprocess.run([LACUNA, *command[1:], "--quiet"], cwd=self.folder, check=True)
        made = (self.folder / name).read_bytes()
        self.assertEqual(hashlib.sha256(saved).hexdigest(), hashlib.sha256(made).hexdigest(),
                         f"{shlex.join(command)}: {len(saved)} bytes from the page, {len(made)} from the command")

    def pressed(self, *keys):
        """Presses keys together, wherever the focus is."""
        actions = ActionChains(self.browser.driver)
        for press in (actions.key_down, actions.key_up):
            for key in keys:
                press(key)
        actions.perform()

    def command(self):
        return self.browser.text("command")

    def can(self, button):
        return self.browser.element(button).get_attribute("aria-disabled") == "false"

    def refused(self, change):
        self.browser.after(change, "failed")
        error = self.browser.element("error")
        self.assertTrue(error.is_displayed())
        return error.text

    def brightness(self):
        """The mean number of what the view shows, 0 to 1."""
        return self.browser.run(SHOWN + """
            let all = 0, sum = 0;
            for (let i = 0; i < data.length; i += 4) {
                if (data[i + 3] !== 255) continue;
                sum += data[i] / 255;
                ++all;
            }
            return sum / all;""")
