"""Tests in a browser of the page's rules: wheel, fingers, keys, pictures read, no server, the policy."""

import math

from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.actions.wheel_input import ScrollOrigin
from selenium.webdriver.common.keys import Keys

from page_case import SHOWN, PageCase, png


class RulesTest(PageCase):
    def seen(self):
        """The zoom that is written, and where the picture's black part lies, in pixels from the view's middle."""
        self.browser.looks()
        return self.browser.text("zoom-all"), self.browser.run(SHOWN + """
            const black = Array.from({ length: width * height }, (_, i) => i).filter((i) => data[4 * i] < 64 && data[4 * i + 3]);
            const mean = (of) => black.reduce((sum, i) => sum + of(i), 0.5) / black.length;
            return [mean((i) => i % width) - width / 2, mean((i) => Math.floor(i / width)) - height / 2];""")

    def pinched(self, x, y, *apart):
        for kind, reach in (("Start", apart[0] / 2), *(("Move", one / 2) for one in apart), ("End", None)):
            places = [] if reach is None else [x - reach, x + reach]
            self.browser.driver.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": f"touch{kind}", "touchPoints": [
                {"x": place, "y": y, "id": i} for i, place in enumerate(places)]})

    def test_wheel_mouse_keys_and_fingers_zoom_and_move_the_view(self):
        page, view, near = self.browser, self.browser.element("view"), 8
        page.after(lambda: (page.set("count", "900"), page.set("share", 100)))
        self.given("mark.png", png(60, 60, 1, lambda x, y, c: 0 if 40 <= x < 44 and 16 <= y < 20 else 200))
        side, step = min(view.size["width"], view.size["height"]), 0.1 * view.size["width"]
        x, y = 0.2 * side, -0.2 * side
        at = view.rect["x"] + view.rect["width"] / 2 + x, view.rect["y"] + view.rect["height"] / 2 + y
        actions = lambda: ActionChains(page.driver)
        drag = actions().move_to_element(view).click_and_hold().move_by_offset(60, -40).release().perform
        wheel = lambda by: actions().scroll_from_origin(ScrollOrigin.from_element(view, round(x), round(y)), 0, by).perform
        keys = lambda *all: lambda: view.send_keys(*all)
        for gesture, zoom, place in (
                (lambda: None, "100 %", (x, y)), (wheel(-200), "165 %", (x, y)), (drag, "165 %", (x + 60, y - 40)),
                (keys(Keys.ARROW_LEFT), "165 %", (x + 60 + step, y - 40)),
                (keys(Keys.ARROW_UP), "165 %", (x + 60 + step, y - 40 + step)),
                (keys(Keys.ARROW_RIGHT, Keys.ARROW_DOWN), "165 %", (x + 60, y - 40)),
                (keys("="), "247 %", (1.5 * (x + 60), 1.5 * (y - 40))), (keys("-"), "165 %", (x + 60, y - 40)),
                (keys("0"), "100 %", (x, y)), (keys(Keys.ARROW_LEFT), "100 %", (x, y)),
                (keys("+"), "150 %", (1.5 * x, 1.5 * y)), (keys("0"), "100 %", (x, y)),
                (wheel(-9999), "6400 %", (0, 0)), (wheel(9999), "100 %", (x, y)),
                (lambda: self.pinched(*at, *range(40, 81, 4)), "200 %", (x, y)),
                (lambda: self.pinched(*at, *range(80, 39, -4)), "100 %", (x, y))):
            gesture()
            is_so = lambda seen: seen[0] == zoom and None not in seen[1] and math.dist(seen[1], place) < near
            page.until(lambda: is_so(self.seen()), f"{zoom}, the mark at {place}")

    def test_what_the_view_has_no_use_for_is_left_to_the_browser(self):
        for event, is_taken in (({"deltaY": 9}, False), ({"deltaY": 9, "ctrlKey": True}, True),
                                ({"deltaY": -9}, True), ({"deltaY": 9}, True), ({"key": "+"}, True),
                                ({"key": "+", "ctrlKey": True}, False), ({"key": "0", "metaKey": True}, False),
                                ({"key": "ArrowLeft", "altKey": True}, False), ({"key": "Tab"}, False)):
            self.assertEqual(is_taken, self.browser.run("""const details = { cancelable: true, ...arguments[0] };
                return !document.getElementById('view').dispatchEvent(
                    details.key ? new KeyboardEvent('keydown', details) : new WheelEvent('wheel', details));""", event), event)

    def test_all_keys_of_undo_work_and_in_a_text_field_they_undo_typing(self):
        page, first = self.browser, self.command()
        page.after(lambda: page.set("count", "700"))
        second = self.command()
        for *keys, command in ((Keys.META, "z", first), (Keys.META, Keys.SHIFT, "z", second),
                               (Keys.CONTROL, "z", first), (Keys.CONTROL, "y", second)):
            page.after(lambda: self.pressed(*keys))
            self.assertEqual(self.command(), command, keys)
        page.after(lambda: page.element("count").send_keys("7"))
        self.assertIn("--count 7007", self.command())
        page.after(lambda: self.pressed(Keys.CONTROL, "z"))
        self.assertEqual((self.command(), self.can("redo")), (second, False))

    def test_escape_leaves_the_crop_first_and_then_ends_the_work(self):
        page = self.browser
        page.begin_long_work()
        page.element("crop").click()
        self.pressed(Keys.ESCAPE)
        self.assertEqual((page.element("cropper").is_displayed(), page.state()), (False, "working"))
        page.after(lambda: self.pressed(Keys.ESCAPE), "cancelled")

    def test_pictures_that_the_page_changes_are_offered_as_they_were_read(self):
        page, ramp = self.browser, lambda x, y, c: (4 * x + y * c) % 256
        page.after(lambda: page.set("count", "900"))
        for name, content, note in (
                ("veil.png", png(64, 48, 4, ramp), "64 × 48 pixels."),
                ("deep.png", png(64, 48, 1, ramp, depth=16), "64 × 48 pixels."),
                ("large.png", png(5000, 1250, 1, ramp), "4,000 × 1,000 pixels, made smaller.")):
            self.given(name, content)
            self.assertEqual(page.text("picture-note"), note)
            saved, content = page.saved_by("save-picture")
            self.assertEqual(saved, f"{name.split('.')[0]}-as-read.png")
            (self.folder / saved).write_bytes(content)
            self.assert_the_commands_bytes("npy")
        self.given("largest.png", png(4000, 1000, 1, ramp))
        self.assertFalse(page.element("picture-as-read").is_displayed())

    def test_a_page_that_was_loaded_needs_no_server(self):
        page = self.browser
        page.until(lambda: page.run("return performance.getEntriesByName(`${location.origin}/hopper.jpg`).length"), "hopper.jpg")
        page.server.unanswered = []
        for example in ("raccoon", "hopper"):
            page.after(page.element(f"example-{example}").click)
        page.run("document.querySelector('.eye').click()")
        page.looks()
        for _ in range(3):
            page.begin_long_work()
            page.after(page.element("cancel").click, "cancelled")
            page.after(lambda: page.set("count", "700"))
        page.after(page.element("tab-sample").click)
        self.assertEqual((page.download("npy")[0], page.server.unanswered), ("points.npy", []))

    def test_the_policy_refuses_what_lies_elsewhere_and_what_could_read_it(self):
        page = self.browser
        page.run("""window.refused = [];
            document.addEventListener('securitypolicyviolation', (event) => refused.push(event.effectiveDirective));""")
        for directive, attempt in (
                ("by the worker", """new Worker(URL.createObjectURL(new Blob([`fetch('${there}', { mode: 'no-cors' })
                    .catch(() => postMessage('by the worker'))`]))).onmessage = ({ data }) => refused.push(data)"""),
                ("connect-src", "fetch(there)"), ("connect-src", "navigator.sendBeacon(there, 'x')"),
                ("connect-src", "new WebSocket(there.replace('http', 'ws'))"), ("script-src", "eval('1')"),
                ("font-src", "new FontFace('a', `url(${there})`).load()"), ("media-src", "new Audio(there).load()"),
                ("frame-src", "add('iframe', { src: there })"), ("object-src", "add('object', { data: there })"),
                ("style-src-elem", "add('link', { rel: 'stylesheet', href: there })"),
                ("script-src-elem", "add('script', { src: there })"), ("worker-src", "new Worker('worker.js')"),
                ("script-src-elem", "add('script', { textContent: '1' })"), ("img-src", "new Image().src = there")):
            page.run("const there = arguments[0], add = (tag, all) => document.body.append(Object.assign("
                     f"document.createElement(tag), all)); setTimeout(() => {{ {attempt} }});",
                     page.address.replace("127.0.0.1", "localhost"))
            page.until(lambda: page.run("return refused.splice(0)") == [directive], attempt)
        page.complaints(), page.requests()  # of what was refused
