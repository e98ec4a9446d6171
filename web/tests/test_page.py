"""Tests in a browser that the page keeps its promises."""

import re
import struct
import time
import unittest
import zlib

from selenium.webdriver.common.keys import Keys

from page_case import RACCOON, SHOWN, PageCase, png


class PageTest(PageCase):
    # ------------------------------------------------------------------------------------ stipple

    def test_a_first_picture_is_there_before_anything_is_chosen(self):
        self.assertIn("20,000 dots", self.browser.text("status"))
        inked = self.browser.run(SHOWN + """
            let dark = 0;
            for (let i = 0; i < data.length; i += 4) dark += data[i] < 128 && data[i + 3] === 255;
            return dark / (data.length / 4);""")
        self.assertGreater(inked, 0.2)
        self.assertLess(inked, 0.9)

    def test_the_screen_is_as_bright_as_a_grey_picture_however_many_dots_there_are(self):
        page = self.browser
        self.given("grey.png", png(60, 60, 1, lambda x, y, c: 128))
        for count in ("3000", "20000", "100000"):
            page.after(lambda: page.set("count", count))
            self.assertAlmostEqual(self.brightness(), 128 / 255, delta=0.03, msg=count)
        page.after(lambda: page.set("light", True))
        self.assertIn("--light", page.text("command"))
        self.assertAlmostEqual(self.brightness(), 0.216, delta=0.03)

    def test_a_dropped_photograph_gives_the_bytes_of_the_command(self):
        page = self.browser
        self.given("raccoon.png")
        page.after(lambda: page.set("count", "5000"))
        self.assertIn("5,000 dots", page.text("status"))
        page.after(lambda: page.set("relax", 20))
        self.assertIn("relaxed 20 times", page.text("status"))
        for kind in ("npy", "svg", "csv"):
            with self.subTest(kind):
                self.assert_the_commands_bytes(kind)

    def test_every_control_says_the_same_as_its_option(self):
        page = self.browser
        self.given("it's a raccoon.png")
        settings = [
            {"count": "2000", "size-by-tone": 0.6, "sharpen": 7, "keep-inside": True},
            {"ink-kind": "cmyk", "relax": 3, "seed": 2},
            {"ink-kind": "own", "inks": "#0083b8,sea=#d6006d", "pen-path": True, "keep-inside": False},
            {"ink-kind": "black,red", "count": "", "paper": "A6", "pen-kind": "pen"},
            {"ink-kind": "", "size-by-tone": 0, "sharpen": 0, "pen-kind": "radius", "pen-path": False,
             "paper": "none"},
            {"count": "", "relax": 0, "metric": "max", "seed": 9007199254740991},
            {"count": "3,000", "relax": 3, "metric": "mean", "invert": True, "gamma": 1.35},
            {"black": 0.1, "white": 0.85, "invert": False, "seed": 7},
            {"auto-levels": True, "pen-kind": "pen", "pen": 0.35, "paper": "A5", "margin": 12.5},
            {"count": "", "paper": "tabloid", "pen-path": True, "pen": 1.5},
            {"pen-kind": "pens", "pens": "0.3mm,0.5mm", "paper": "A6", "plot-time": 2},
            {"pen-kind": "radius", "paper": "none", "metric": "auto", "plot-time": "", "count": "1000"},
            {"ink-kind": "white,gold=#d4af37", "pen-path": True},
            {"ink-kind": "own", "inks": "#ffffff:0.4mm", "paper-colour": "#204060", "pen-path": False},
        ]
        for setting in settings:
            def change():
                for name, value in setting.items():
                    page.set(name, value)
            page.after(change)
            for kind in ("npy", "svg"):
                with self.subTest(setting, kind=kind):
                    self.assert_the_commands_bytes(kind)

    def test_a_reload_has_the_settings_and_reset_has_none(self):
        page = self.browser
        page.after(lambda: page.set("count", "700"))
        page.after(lambda: page.set("keep-inside", True))
        page.after(lambda: page.set("ink-kind", "white,gold=#d4af37"))
        command = page.text("command")
        self.assertIn("--paper-colour", command)
        page.after(lambda: page.run("location.reload()"))
        self.assertEqual(page.text("command"), command)
        page.after(lambda: page.element("reset").click())
        self.assertNotIn("--", page.text("command").replace("--count 20000", ""))
        self.assertEqual(page.run("return location.hash"), "")
        page.after(lambda: page.element("tab-sample").click())
        page.after(lambda: page.set("by", "count"))
        page.after(lambda: page.run("location.reload()"))
        self.assertIn("lacuna sample --count 2000", page.text("command"))

    def test_white_art_on_transparency_shows_on_black(self):
        page = self.browser
        page.after(lambda: page.set("background", "black"))
        self.given("art.png", png(60, 40, 4, lambda x, y, c: 255 if (x // 20 + y // 20) % 2 else 0))
        self.assertIn("--background black", page.text("command"))
        name, content = page.saved_by("save-picture")
        (self.folder / name).write_bytes(content)
        self.assert_the_commands_bytes("npy")

    def test_colours_are_read_as_the_command_reads_them(self):
        self.given("colours.png", png(61, 43, 3, lambda x, y, c: (x * (3 + c) + y * 5 * c) % 256))
        self.browser.after(lambda: self.browser.set("count", "900"))
        self.assertFalse(self.browser.element("picture-as-read").is_displayed())
        self.assert_the_commands_bytes("npy")

    def test_a_picture_may_be_chosen_or_pasted_too(self):
        page = self.browser
        small = png(40, 30, 1, lambda x, y, c: 6 * x)
        (self.folder / "chosen.png").write_bytes(small)
        page.after(lambda: page.element("file").send_keys(str(self.folder / "chosen.png")))
        self.assertEqual(page.text("picture-name"), "chosen.png")
        self.assertIn("40 × 30 pixels", page.text("picture-note"))
        page.after(lambda: page.paste("pasted.png", png(50, 30, 1, lambda x, y, c: 5 * x)))
        self.assertEqual(page.text("picture-name"), "pasted.png")
        self.assertIn("50 × 30 pixels", page.text("picture-note"))

    def test_a_colour_photograph_is_an_example_in_four_inks(self):
        page = self.browser
        page.after(lambda: page.element("example-hopper").click())
        self.assertEqual(page.text("command").split()[:5], ["lacuna", "stipple", "hopper-as-read.png", "--count", "20000"])
        self.assertIn("--inks cmyk", page.text("command"))
        shares = page.run(SHOWN + """
            let all = 0, coloured = 0;
            for (let i = 0; i < data.length; i += 4) {
                all += data[i + 3] === 255;
                const [r, g, b] = data.subarray(i, i + 3);
                coloured += data[i + 3] === 255 && Math.max(r, g, b) - Math.min(r, g, b) > 60;
            }
            return coloured / all;""")
        self.assertGreater(shares, 0.2)
        name, content = page.saved_by("save-picture")
        (self.folder / name).write_bytes(content)
        self.assert_the_commands_bytes("svg")
        _, document = page.download("pdf")
        self.assertEqual(document.count(b"/S /Transparency"), 4)
        page.after(lambda: page.element("example-raccoon").click())
        self.assertNotIn("--inks", page.text("command"))

    def test_dots_follow_a_slider_while_it_is_moved(self):
        page = self.browser
        page.run("delete document.documentElement.dataset.state")
        for place in range(500, 560, 5):
            page.set("count-slider", place)
            time.sleep(0.03)
        page.wait_for("done")
        count = int(page.element("count").get_property("value"))
        self.assertIn(f"{count:,} dots", page.text("status"))

    def test_the_slider_shows_the_photo(self):
        page = self.browser
        dots = page.looks()
        page.set("share", 60)
        page.until(lambda: page.looks() != dots, "the photo")
        page.set("share", 0)
        page.until(lambda: page.looks() == dots, "the dots")

    def test_tabs_are_changed_by_arrow_keys(self):
        page = self.browser
        for key, tab in ((Keys.ARROW_RIGHT, "sample"), (Keys.ARROW_LEFT, "stipple"), (Keys.ARROW_LEFT, "sample")):
            page.after(lambda: page.driver.find_element("css selector", "[aria-selected=true]").send_keys(key))
            self.assertTrue(page.element(f"controls-{tab}").is_displayed())
            self.assertEqual(page.driver.switch_to.active_element.get_attribute("id"), f"tab-{tab}")

    def test_png_and_pdf_show_as_many_dots(self):
        page = self.browser
        page.after(lambda: page.set("count", "1000"))
        _, picture = page.download("png")
        self.assertEqual(picture[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(struct.unpack(">II", picture[16:24]), (2048, 1536))
        name, document = page.download("pdf")
        self.assertEqual(name, "raccoon.pdf")
        contents = [zlib.decompress(one) for one in re.findall(rb"stream\n(.*?)\nendstream", document, re.DOTALL)]
        self.assertEqual([content.count(b" l S") for content in contents], [0, 1000])
        start = int(re.search(rb"startxref\n(\d+)", document)[1])
        self.assertEqual(document[start:start + 4], b"xref")

    # ------------------------------------------------------------------------- what can go wrong

    def test_a_broken_picture_is_refused_in_a_line(self):
        page = self.browser
        message = self.refused(lambda: page.drop("broken.png", RACCOON[:2000][::-1]))
        self.assertEqual(message, "broken.png: not a picture that this browser can read")
        page.after(lambda: page.drop("raccoon.png", RACCOON))
        self.assertFalse(page.element("error").is_displayed())

    def test_a_white_picture_is_refused_in_a_line(self):
        white = png(20, 20, 1, lambda x, y, c: 255)
        message = self.refused(lambda: self.browser.drop("white.png", white))
        self.assertIn("white all over", message)

    def test_absurd_counts_are_refused_in_a_line(self):
        page = self.browser
        for absurd in ("99999999999", "0", "-4", "many", "9" * 30):
            with self.subTest(absurd):
                self.assertIn("count", self.refused(lambda: page.set("count", absurd)))
                self.assertEqual(page.element("count").get_attribute("aria-invalid"), "true")
        page.after(lambda: page.set("count", "500"))
        self.assertIn("500 dots", page.text("status"))
        self.assertIsNone(page.element("count").get_attribute("aria-invalid"))

    def test_a_request_that_comes_before_its_worker_is_ready_is_answered(self):
        answer = self.browser.driver.execute_async_script("""
            const done = arguments[arguments.length - 1];
            import("/engine.js").then(({ Engine }) => Engine.load())
                .then((engine) => engine.ask("no such verb", {})).catch((error) => done(error.message));""")
        self.assertIn("not a function", answer)

    def test_cancel_ends_the_work_and_leaves_the_page_ready(self):
        page = self.browser
        page.begin_long_work()
        taken = page.run("""const begin = performance.now();
            document.getElementById('cancel').click();
            return new Promise((resolve) => requestAnimationFrame(function look() {
                if (document.documentElement.dataset.state === 'cancelled') resolve(performance.now() - begin);
                else requestAnimationFrame(look);
            }));""")
        print(f"cancelled after {taken:.0f} ms ", end="", flush=True)
        self.assertEqual(page.text("status"), "Cancelled.")
        self.assertFalse(page.element("progress").is_displayed())
        page.after(lambda: page.set("count", "700"))
        self.assertIn("700 dots", page.text("status"))

    # ------------------------------------------------------------------------------------- sample

    def test_a_sample_is_verified_and_has_the_bytes_of_the_command(self):
        page = self.browser
        page.after(lambda: page.element("tab-sample").click())
        self.assertIn("✓ No two points are closer", page.text("verdict"))
        self.assertIn("✓ No room is left", page.text("verdict"))
        self.assertTrue(page.element("powers").is_displayed())
        for setting in ({}, {"amount": "0.03", "torus": False, "sample-seed": 5}, {"mode": "lines"},
                        {"by": "count", "amount": "1,500", "mode": "exact"}, {"sample-relax": 4}):
            def change():
                for name, value in setting.items():
                    page.set(name, value)
            if setting:
                page.after(change)
            for kind in ("npy", "svg"):
                with self.subTest(setting, kind=kind):
                    self.assert_the_commands_bytes(kind)

    def test_an_absurd_radius_is_refused_in_a_line(self):
        page = self.browser
        page.after(lambda: page.element("tab-sample").click())
        for absurd in ("0", "-1", "1e-9", "big"):
            with self.subTest(absurd):
                self.assertIn("radius", self.refused(lambda: page.set("amount", absurd)))
                self.assertEqual(page.element("amount").get_attribute("aria-invalid"), "true")

    # ----------------------------------------------------------------------------------- the rest

    def test_every_control_has_a_name(self):
        nameless = self.browser.run("""return [...document.querySelectorAll('input, select, button, canvas')]
            .filter((field) => !(field.labels?.length || field.getAttribute('aria-label')
                || field.getAttribute('aria-labelledby') || field.textContent.trim()))
            .map((field) => field.outerHTML);""")
        self.assertEqual(nameless, [])

    def test_the_page_fits_every_width_in_both_schemes(self):
        page = self.browser
        for scheme in ("light", "dark"):
            for width, height in ((390, 844), (1280, 800), (1920, 1080)):
                with page.screen(width, height, scheme), self.subTest(width=width, scheme=scheme):
                    time.sleep(0.2)
                    self.assertLessEqual(page.run("return document.documentElement.scrollWidth"), width)
                    self.assertEqual(self.weak_contrasts(), [])

    def weak_contrasts(self):
        """Texts whose contrast is under 4.5 (WCAG 2.1, AA)."""
        return self.browser.run("""
            const parts = (colour) => colour.match(/[\\d.]+/g).map(Number);
            const light = (colour) => {
                const [r, g, b] = parts(colour).map((v) => v / 255)
                    .map((v) => (v <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4));
                return 0.2126 * r + 0.7152 * g + 0.0722 * b;
            };
            const behind = (element) => {
                for (; element; element = element.parentElement) {
                    const colour = getComputedStyle(element).backgroundColor;
                    if ((parts(colour)[3] ?? 1) !== 0) return colour;
                }
                return 'rgb(255, 255, 255)';
            };
            return [...document.querySelectorAll('h1, p, label, legend, button, output, code, select, input:not([type=range], [type=checkbox])')]
                .filter((one) => one.offsetParent && !one.disabled)
                .map((one) => {
                    const [a, b] = [light(getComputedStyle(one).color), light(behind(one))].sort((p, q) => q - p);
                    return [one.id || one.textContent.trim().slice(0, 30), (a + 0.05) / (b + 0.05)];
                })
                .filter(([, contrast]) => contrast < 4.5);""")


if __name__ == "__main__":
    unittest.main()
