"""Tests in a browser of the artist's controls: steps, links, inks, crop, turn, paper, strokes, lines."""

import re
import struct
import unittest
import zlib

from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.keys import Keys

from page_case import PageCase, png


class SettingsTest(PageCase):
    def clicked(self, name):
        self.browser.after(lambda: self.browser.element(name).click())

    def colour(self, row, colour):
        """Picks a colour of the ink in this row of the list."""
        self.browser.after(lambda: self.browser.run(
            """const picker = document.querySelectorAll('#ink-list [type=color]')[arguments[0]];
            picker.value = arguments[1];
            for (const event of ['input', 'change']) picker.dispatchEvent(new Event(event, { bubbles: true }));""",
            row, colour))

    def inks(self):
        return self.browser.run("return [...document.querySelectorAll('#ink-list span')].map((one) => one.textContent)")

    def eye(self, row):
        self.browser.run("document.querySelectorAll('#ink-list .eye')[arguments[0]].click()", row)

    # ------------------------------------------------------------------------------ steps and links

    def test_steps_are_undone_and_redone_by_buttons_and_keys(self):
        page = self.browser
        self.assertFalse(self.can("undo") or self.can("redo"))
        first = self.command()
        page.after(lambda: page.set("count", "700"))
        second = self.command()
        page.after(lambda: page.set("keep-inside", True))
        third = self.command()
        self.clicked("undo")
        self.assertEqual(self.command(), second)
        page.after(lambda: self.pressed(Keys.CONTROL, "z"))
        self.assertEqual(self.command(), first)
        self.assertFalse(self.can("undo"))
        page.after(lambda: self.pressed(Keys.CONTROL, Keys.SHIFT, "z"))
        self.assertEqual(self.command(), second)
        self.clicked("redo")
        self.assertEqual(self.command(), third)
        self.assertFalse(self.can("redo"))
        self.clicked("undo")
        page.after(lambda: page.set("seed", "3"))
        self.assertFalse(self.can("redo"))

    def test_reset_and_the_other_tab_are_steps_too(self):
        page = self.browser
        page.after(lambda: page.set("count", "700"))
        changed = self.command()
        self.clicked("reset")
        self.assertIn("--count 20000", self.command())
        self.clicked("undo")
        self.assertEqual(self.command(), changed)
        self.clicked("tab-sample")
        self.assertIn("lacuna sample", self.command())
        self.clicked("undo")
        self.assertEqual(self.command(), changed)

    def test_keys_on_a_slider_are_one_step(self):
        page = self.browser
        page.after(lambda: page.set("count", "700"))
        changed = self.command()
        for _ in range(3):
            page.after(lambda: page.element("gamma").send_keys(Keys.ARROW_RIGHT))
        self.assertIn("--gamma 1.15", self.command())
        self.clicked("undo")
        self.assertEqual(self.command(), changed)

    def test_an_old_link_makes_the_same_and_a_link_may_be_pasted_into_an_open_page(self):
        page = self.browser
        link = ("count=700&relax=4&ink-kind=own&inks=black%3A0.3mm%2Cred%3A0.5mm&gamma=1.35&auto-levels=true"
                "&paper=A5&margin=12&pen-path=true")
        page.after(lambda: page.run("location.hash = arguments[0]", link))
        command = self.command()
        for part in ("--count 700", "--relax 4", "--inks black:0.3mm,red:0.5mm", "--gamma 1.35", "--auto-levels",
                     "--paper-size A5", "--margin 12mm", "--pen-path"):
            self.assertIn(part, command)
        page.after(lambda: page.run("location.reload()"))
        self.assertEqual(self.command(), command)

    # ------------------------------------------------------------------------------------------ inks

    def test_an_eye_hides_an_ink_on_the_screen_and_no_file_lacks_it(self):
        page = self.browser
        self.given("raccoon.png")
        page.after(lambda: (page.set("count", "2000"), page.set("ink-kind", "cmyk")))
        self.assertEqual([text.split(",")[0] for text in self.inks()], ["cyan", "magenta", "yellow", "black"])
        all_inks, brightness = page.looks(), self.brightness()
        self.assertFalse(page.element("hidden-note").is_displayed())
        self.eye(3)
        self.assertNotEqual(page.looks(), all_inks)
        self.assertGreater(self.brightness(), brightness)
        self.assertIn("every download has all", page.text("hidden-note"))
        self.assert_the_commands_bytes("svg")
        _, document = page.download("pdf")
        self.assertEqual(self.dots_of(document), 2000)
        self.eye(3)
        self.assertEqual(page.looks(), all_inks)
        self.assertFalse(page.element("hidden-note").is_displayed())

    def dots_of(self, document, mark=b" l S"):
        contents = [zlib.decompress(one) for one in re.findall(rb"stream\n(.*?)\nendstream", document, re.DOTALL)]
        return sum(content.count(mark) for content in contents)

    def test_a_picker_changes_the_colour_of_an_ink(self):
        page = self.browser
        self.given("colours.png", png(61, 43, 3, lambda x, y, c: (x * (3 + c) + y * 5 * c) % 256))
        page.after(lambda: (page.set("count", "900"), page.set("ink-kind", "cmyk")))
        self.colour(0, "#2060c0")
        self.assertIn("--inks 'cyan=#2060c0,magenta=#e6007e,yellow=#ffed00,black=#1d1d1b'", self.command())
        self.assert_the_commands_bytes("svg")
        self.clicked("undo")
        self.assertIn("--inks cmyk", self.command())
        page.after(lambda: (page.set("ink-kind", "own"), page.set("inks", "black:0.3mm,sea=#2060c0:0.5mm")))
        self.colour(0, "#401010")
        self.colour(1, "#20c0c0")
        self.assertIn("--inks '#401010:0.3mm,sea=#20c0c0:0.5mm'", self.command())
        self.assert_the_commands_bytes("svg")
        page.after(lambda: page.set("ink-kind", ""))
        self.colour(0, "#102080")
        self.assertIn("--inks '#102080'", self.command())

    def test_pens_have_rows_of_their_own_and_share_the_colour_of_their_ink(self):
        page = self.browser
        page.after(lambda: (page.set("count", "900"), page.set("ink-kind", "black,red"),
                            page.set("pen-kind", "pens"), page.set("pens", "0.3mm,0.5mm")))
        self.assertEqual([text.split(",")[0] for text in self.inks()],
                         ["black 0.3mm", "black 0.5mm", "red 0.3mm", "red 0.5mm"])
        self.colour(3, "#2060c0")
        self.assertIn("--inks 'black,#2060c0'", self.command())

    def test_the_share_of_black_ink_is_there_where_black_is(self):
        page = self.browser
        self.given("colours.png", png(61, 43, 3, lambda x, y, c: (x * (3 + c) + y * 5 * c) % 256))
        slider = page.element("black-ink")
        for inks, is_there in (("", False), ("cmyk", True), ("black,red", True), ("white,gold=#d4af37", False)):
            page.after(lambda: page.set("ink-kind", inks))
            self.assertEqual(slider.is_displayed(), is_there, inks)
        page.after(lambda: (page.set("count", "900"), page.set("ink-kind", "own"), page.set("inks", "#101010,#00a0c0")))
        self.assertTrue(slider.is_displayed())
        usual = page.looks()
        page.after(lambda: page.set("black-ink", 0.2))
        self.assertIn("--black-ink 0.2", self.command())
        self.assertNotEqual(page.looks(), usual)
        self.assert_the_commands_bytes("npy")
        page.after(lambda: page.set("paper-colour", "#fff0d0"))
        self.assertNotIn("--black-ink", self.command())

    # ------------------------------------------------------------------------------ crop, turn, paper

    def shade(self, x, y):
        return (5 * x + 3 * y) % 200

    def assert_same_dots(self, columns, rows, pixel):
        """Checks that the page's dots are its command's, those of a picture of these pixels, and the saved picture's."""
        self.browser.after(lambda: self.browser.set("count", "900"))
        self.assert_the_commands_bytes("npy")
        name, content = self.browser.saved_by("save-picture")
        command = re.sub(r" --(turn|crop) [\d,]+", "", self.command()).replace("art.png", name)
        expected = png(columns, rows, 1, lambda x, y, c: pixel(x, y))
        for picture in (content, expected):
            (self.folder / name).write_bytes(picture)
            self.assert_the_commands_bytes("npy", command)

    def test_a_picture_is_turned_and_four_turns_leave_it(self):
        self.given("art.png", png(60, 40, 1, lambda x, y, c: self.shade(x, y)))
        self.browser.set("format", "npy")
        first = self.command()
        self.clicked("turn-right")
        self.assertIn("40 × 60 pixels, turned", self.browser.text("picture-note"))
        self.assertRegex(self.command(), "stipple art.png .*--turn 90 ")
        self.assert_same_dots(40, 60, lambda x, y: self.shade(y, 39 - x))
        self.clicked("turn-right")
        self.assert_same_dots(60, 40, lambda x, y: self.shade(59 - x, 39 - y))
        self.clicked("turn-right")
        self.assert_same_dots(40, 60, lambda x, y: self.shade(59 - y, x))
        self.clicked("turn-right")
        self.assertEqual(self.command(), first.replace("20000", "900"))
        self.assertFalse(self.browser.element("whole").is_displayed())

    def test_a_part_is_cut_out_by_numbers_and_turns_with_the_picture(self):
        page = self.browser
        self.given("art.png", png(60, 40, 1, lambda x, y, c: self.shade(x, y)))
        page.after(lambda: [page.set(f"crop-{side}", cut) for side, cut in
                            (("left", 10), ("right", 20), ("top", 25), ("bottom", 5))])
        self.assertIn("42 × 28 pixels, cropped", page.text("picture-note"))
        self.assert_same_dots(42, 28, lambda x, y: self.shade(x + 6, y + 10))
        self.clicked("turn-right")
        self.assert_same_dots(28, 42, lambda x, y: self.shade(y + 6, 37 - x))
        self.assertRegex(self.command(), "stipple art.png .*--turn 90 --crop 2,6,28,42 ")
        link = page.run("return location.hash")
        self.clicked("whole")
        self.assertIn("stipple art.png", self.command())
        self.clicked("undo")
        self.assertEqual(page.run("return location.hash"), link)

    def test_what_cuts_everything_off_is_refused_in_a_line(self):
        page = self.browser
        page.after(lambda: page.set("crop-left", 60))
        self.assertIn("left and right", self.refused(lambda: page.set("crop-right", 40)))
        self.assertIn("top and bottom", self.refused(lambda: (page.set("crop-right", 0), page.set("crop-top", -1))))
        self.clicked("undo")
        self.assertFalse(page.element("error").is_displayed())

    def test_a_part_is_dragged_on_the_picture(self):
        page = self.browser
        self.given("art.png", png(60, 60, 1, lambda x, y, c: self.shade(x, y)))
        first, dots, status = self.command(), page.looks(), page.text("status")
        for leave in (lambda: self.pressed(Keys.ESCAPE), page.element("crop").click):
            page.element("crop").click()
            self.assertTrue(page.element("cropper").is_displayed())
            self.assertIn("Drag over the part", page.text("status"))
            leave()
            self.assertFalse(page.element("cropper").is_displayed())
            self.assertEqual((self.command(), page.looks(), page.text("status")), (first, dots, status))
        page.element("crop").click()
        cropper = page.element("cropper")
        side = min(cropper.size["width"], cropper.size["height"])
        drag = ActionChains(page.driver).move_to_element(cropper).click_and_hold()
        page.after(lambda: drag.move_by_offset(-side // 4, side // 2 + 10).release().perform())
        self.assertFalse(cropper.is_displayed())
        cut = {one: float(page.element(f"crop-{one}").get_property("value")) for one in ("left", "right", "top", "bottom")}
        for one, expected in (("left", 25), ("right", 50), ("top", 50), ("bottom", 0)):
            self.assertAlmostEqual(cut[one], expected, delta=0.6, msg=one)
        self.assertIn("15 × 30 pixels, cropped", page.text("picture-note"))
        self.clicked("undo")
        self.assertEqual(self.command(), first)

    def test_a_link_crops_the_picture_that_is_given_next_and_no_other(self):
        page = self.browser
        page.after(lambda: (page.set("crop-left", 50), page.set("turn", "90")))
        page.after(lambda: page.run("location.reload()"))
        self.assertIn("384 × 1,024 pixels, turned and cropped", page.text("picture-note"))
        self.given("art.png", png(60, 40, 1, lambda x, y, c: self.shade(x, y)))
        self.assertIn("20 × 60 pixels, turned and cropped", page.text("picture-note"))
        self.given("other.png", png(60, 40, 1, lambda x, y, c: self.shade(x, y)))
        self.assertIn("60 × 40 pixels.", page.text("picture-note"))

    def test_paper_lies_as_the_user_says(self):
        page = self.browser
        self.given("art.png", png(60, 40, 1, lambda x, y, c: self.shade(x, y)))
        self.assertFalse(page.element("paper-lies").is_enabled())
        page.after(lambda: (page.set("count", "900"), page.set("paper", "A5")))
        self.assertIn("--paper-size A5", self.command())
        page.after(lambda: page.set("paper-lies", "portrait"))
        self.assertIn("--paper-size 148x210mm", self.command())
        self.assert_the_commands_bytes("svg")
        page.after(lambda: (page.set("paper-lies", "landscape"), page.set("paper", "letter")))
        self.assertIn("--paper-size 279.4x215.9mm", self.command())
        self.assert_the_commands_bytes("svg")

    # ------------------------------------------------------------------------------- strokes and lines

    def test_long_dots_strokes_and_a_line_have_the_bytes_of_the_command(self):
        page = self.browser
        self.given("raccoon.png")
        settings = [({"count": "2000", "drawn": "along"}, "--along 6"),
                    ({"along": 3, "paper": "A6"}, "--along 3"),
                    ({"pen-kind": "pen", "pen": 0.4}, "--dot-size 0.4mm"),
                    ({"drawn": "line"}, "--path-line"),
                    ({"pen-kind": "radius", "ink-kind": "black,red"}, "--path-line")]
        for setting, option in settings:
            page.after(lambda: [page.set(name, value) for name, value in setting.items()])
            self.assertIn(option, self.command())
            for kind in ("svg", "csv", "npy"):
                with self.subTest(setting, kind=kind):
                    self.assert_the_commands_bytes(kind)

    def test_long_dots_strokes_and_a_line_are_as_bright_as_the_picture(self):
        page = self.browser
        self.given("grey.png", png(60, 60, 1, lambda x, y, c: 128))
        page.after(lambda: (page.set("count", "3000"), page.set("drawn", "along")))
        self.assertAlmostEqual(self.brightness(), 0.5, delta=0.06)
        page.after(lambda: page.set("drawn", "line"))
        self.assertAlmostEqual(self.brightness(), 0.5, delta=0.06)
        page.after(lambda: (page.set("drawn", "along"), page.set("pen-kind", "pen")))
        self.assertAlmostEqual(self.brightness(), 0.5, delta=0.12)

    def test_png_and_pdf_show_long_dots_strokes_and_a_line(self):
        page = self.browser
        page.after(lambda: (page.set("count", "1000"), page.set("drawn", "along")))
        _, document = page.download("pdf")
        self.assertEqual(self.dots_of(document, b" c f"), 1000)
        page.after(lambda: page.set("pen-kind", "pen"))
        _, document = page.download("pdf")
        self.assertEqual(self.dots_of(document), 1000)
        page.after(lambda: page.set("drawn", "line"))
        _, document = page.download("pdf")
        self.assertEqual((self.dots_of(document, b" l\n"), self.dots_of(document, b"\nS")), (999, 1))
        _, picture = page.download("png")
        self.assertEqual(struct.unpack(">II", picture[16:24]), (2048, 1536))

    # ------------------------------------------------------------------------------------------- mask

    def test_a_sample_lies_where_the_picture_is_not_black(self):
        page = self.browser
        is_in = lambda x, y: (x - 29.5) ** 2 + (y - 19.5) ** 2 < 300
        self.given("disk.png", png(60, 40, 1, lambda x, y, c: 200 if is_in(x, y) else 0))
        self.clicked("tab-sample")
        page.after(lambda: (page.set("sample-relax", 4), page.set("mask", True)))
        self.assertIn("--mask disk.png", self.command())
        self.assertNotIn("--relax", self.command())
        self.assertIn("✓ No two points are closer", page.text("verdict"))
        self.assertIn("✓ No room is left", page.text("verdict"))
        self.assertFalse(page.element("powers").is_displayed())
        self.assertIn("without a mask", page.text("spectrum"))
        for change in ({}, {"torus": False, "sample-seed": 5}, {"by": "count", "amount": "300"}):
            page.after(lambda: [page.set(name, value) for name, value in {"mask": True, **change}.items()])
            for kind in ("npy", "csv", "svg"):
                with self.subTest(change, kind=kind):
                    self.assert_the_commands_bytes(kind)
        _, rows = page.download("csv")
        points = [tuple(map(float, row.split(",")[:2])) for row in rows.decode().splitlines() if row[:1].isdigit()]
        self.assertEqual(len(points), 300)
        self.assertTrue(all(is_in(int(60 * x), 39 - int(60 * y)) for x, y in points))
        page.after(lambda: page.run("location.reload()"))
        self.assertIn("--mask raccoon.png", self.command())

    # ------------------------------------------------------------------------------------------ names

    def test_no_two_controls_that_are_seen_have_the_same_name(self):
        page = self.browser
        for change in (lambda: page.set("ink-kind", "cmyk"), lambda: page.element("tab-sample").click()):
            page.after(change)
            page.run("document.querySelector('details').open = true")
            names = page.run("""return [...document.querySelectorAll('input, select, button, canvas, summary')]
                .filter((one) => one.offsetParent && !one.classList.contains('hidden'))
                .map((one) => one.getAttribute('aria-label') || one.labels?.[0]?.textContent.trim() || one.textContent.trim());""")
            self.assertGreater(len(names), 15)
            self.assertEqual([name for name in set(names) if names.count(name) > 1], [])


if __name__ == "__main__":
    unittest.main()
