"""Tests in a browser of the page's rules: no server, the policy."""

from page_case import PageCase


class RulesTest(PageCase):
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
