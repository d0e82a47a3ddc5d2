"""Makes PDFs of notes and measures them, for `cargo xtask papers`.

The request is JSON on standard input, one line: notes with their files, formats and titles, all formats, the browser. What
was found is printed as JSON, one line: pages and faults of each note and format. Needs the packages `typst` and `pymupdf`,
Chromium and pdflatex.
"""

import base64
import json
import os
import re
import subprocess
import sys
import tempfile
import unicodedata
from pathlib import Path

import pymupdf

# Margins of the pages of each format, in points.
MARGINS = {"html": 20 / 25.4 * 72, "typ": 25 / 25.4 * 72, "tex": 25 / 25.4 * 72, "docx": 25 / 25.4 * 72}
# What the foot of a page consists of: program, page of pages; a first run of LaTeX does not know how many there are.
FOOT = re.compile(r"(dalembert[\d.]+)?(\d+(/(\d+|\?\?))?)?")
# How far a letter may reach over the edge of the text, in points: side bearings of slanted letters.
REACH = 1.5
SWITCHES = [
    "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--disable-sync",
]  # fmt: skip


class Browser:
    """A Chromium that is spoken to through a pipe."""

    def __init__(self, program):
        self.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        requests, self.requests = os.pipe()
        self.replies, replies = os.pipe()
        command = [program, *SWITCHES, f"--user-data-dir={self.profile.name}", "--remote-debugging-pipe"]
        # The browser reads from descriptor 3 and writes to descriptor 4.
        redirected = f'exec "$0" "$@" 3<&{requests} 4>&{replies}'
        self.process = subprocess.Popen(
            ["sh", "-c", redirected, *command],
            pass_fds=(requests, replies),
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        os.close(requests)
        os.close(replies)
        self.count, self.text, self.messages = 0, b"", []
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = None
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        self.call("Page.enable")

    def next(self):
        while b"\0" not in self.text:
            more = os.read(self.replies, 1 << 20)
            if not more:
                raise RuntimeError("the browser has ended")
            self.text += more
        message, self.text = self.text.split(b"\0", 1)
        return json.loads(message)

    def call(self, method, **parameters):
        self.count += 1
        request = {"id": self.count, "method": method, "params": parameters}
        if getattr(self, "session", None):
            request["sessionId"] = self.session
        self.send(json.dumps(request).encode() + b"\0")
        while (message := self.next()).get("id") != self.count:
            self.messages.append(message.get("method"))
        if "error" in message:
            raise RuntimeError(f"{method}: {message['error']['message']}")
        return message["result"]

    def send(self, data):
        while data:
            data = data[os.write(self.requests, data) :]

    def open(self, page):
        self.messages.clear()
        self.call("Page.navigate", url=page.resolve().as_uri())
        while "Page.loadEventFired" not in self.messages:
            self.messages.append(self.next().get("method"))

    def width(self, width):
        """Width of the page in a window of this width."""
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=800, deviceScaleFactor=1, mobile=False)
        asked = "document.documentElement.scrollWidth"
        return self.call("Runtime.evaluate", expression=asked)["result"]["value"]

    def cut(self):
        """Texts of the elements that are wider than their place."""
        asked = """[...document.querySelectorAll('.formula, .formula *')]
            .filter(one => one instanceof HTMLElement && one.scrollWidth > one.clientWidth + 1 && one.clientWidth > 0)
            .map(one => one.textContent.trim().slice(0, 60))"""
        return self.call("Runtime.evaluate", expression=asked, returnByValue=True)["result"]["value"]

    def print(self):
        self.call("Emulation.clearDeviceMetricsOverride")
        options = {"preferCSSPageSize": True, "displayHeaderFooter": False, "printBackground": True}
        options |= {"paperWidth": 210 / 25.4, "paperHeight": 297 / 25.4}
        return base64.b64decode(self.call("Page.printToPDF", **options)["data"])

    def close(self):
        self.session = None
        self.call("Browser.close")
        self.process.wait(20)
        self.profile.cleanup()


def letters(text):
    """Letters and digits of a text in ASCII, small: what every way of setting it has in common."""
    return re.sub(r"[^a-z0-9]", "", unicodedata.normalize("NFKD", text).lower())


def lines_of(page):
    """Lines of a page from top to bottom, each with its letters: place and character."""
    found = []
    flags = pymupdf.TEXT_PRESERVE_LIGATURES | pymupdf.TEXT_PRESERVE_WHITESPACE
    for block in page.get_text("rawdict", flags=flags)["blocks"]:
        for line in block.get("lines", []):
            glyphs = [glyph for span in line["spans"] for glyph in span["chars"] if not glyph["c"].isspace()]
            if glyphs:
                found.append(glyphs)
    return sorted(found, key=lambda glyphs: glyphs[0]["origin"][1])


def clipped(page):
    """Number of letters that lie outside of what is painted."""
    count = [len(re.sub(r"\s", "", page.get_text("text", flags=flags))) for flags in (0, pymupdf.TEXT_CLIP)]
    return count[0] - count[1]


def text_of(glyphs):
    return "".join(glyph["c"] for glyph in glyphs)


def measured(path, margin, titles):
    """Number of pages, and what is wrong with them."""
    faults, pages = [], []
    titles = {letters(title): title for title in titles}
    with pymupdf.open(path) as document:
        for number, page in enumerate(document, 1):
            left, right = margin, page.rect.width - margin
            top, bottom = margin, page.rect.height - margin
            body = []
            for glyphs in lines_of(page):
                text = text_of(glyphs)
                if glyphs[0]["origin"][1] > bottom + REACH and FOOT.fullmatch(text):
                    continue
                body.append(text)
                outside = [
                    glyph
                    for glyph in glyphs
                    if glyph["bbox"][0] < left - REACH
                    or glyph["bbox"][2] > right + REACH
                    or not top - REACH < glyph["origin"][1] < bottom + REACH
                ]
                if outside:
                    count = len(outside)
                    faults.append(("outside", f"page {number}: {count} letters outside of the text: {text[:60]}"))
            if hidden := clipped(page):
                faults.append(("outside", f"page {number}: {hidden} letters are cut"))
            pages.append(body)
        for number, (body, following) in enumerate(zip(pages, pages[1:]), 1):
            begin = letters("".join(following[:6]))
            end = ""
            for text in reversed(body[-6:]):
                end = letters(text) + end
                # A figure may have the title of what follows it.
                if end in titles and not begin.startswith(end):
                    faults.append(("lone", f"page {number} ends with a title: {titles[end][:60]}"))
                    break
        return document.page_count, faults


def latex(note):
    """PDF of a note by pdflatex, and the lines of its log on boxes that are too wide."""
    command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", note.name]
    for _ in range(3):
        done = subprocess.run(command, cwd=note.parent, stdin=subprocess.DEVNULL, capture_output=True)
        log = note.with_suffix(".log").read_text(errors="replace") if note.with_suffix(".log").exists() else ""
        # A run takes the columns of long tables from the run before it.
        if done.returncode or "Column widths have changed" not in log:
            break
    if done.returncode:
        errors = [line for line in log.splitlines() if line.startswith("!")]
        raise RuntimeError(errors[0] if errors else f"pdflatex ended with {done.returncode}")
    # Without the last digits of lengths, and without lines and pages.
    wide = re.findall(r"^Overfull \\[hv]box \(([\d.]+)pt too [a-z]+\).*", log, re.MULTILINE)
    places = re.findall(r"^Overfull .*", log, re.MULTILINE)
    return [("overfull", place) for width, place in zip(wide, places) if float(width) > 0]


def office(folder, notes):
    """PDFs of documents of Word by LibreOffice."""
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        command = ["soffice", f"-env:UserInstallation=file://{profile}", "--headless", "--convert-to", "pdf"]
        subprocess.run(
            [*command, "--outdir", str(folder), *map(str, notes)],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            check=True,
        )


def run(request):
    formats = request["formats"]
    browser = Browser(request["browser"]) if "html" in formats else None
    compiled = None
    if "typ" in formats:
        import typst

        compiled = typst.compile
    results = []
    for note in request["notes"]:
        folder = Path(note["folder"])
        for format in note["formats"]:
            path = folder / f"{note['stem']}.{format}"
            pdf = folder / f"{note['stem']}-{format}.pdf"
            faults, pages = [], 0
            try:
                if format == "html":
                    browser.open(path)
                    for width in request["widths"]:
                        if (wide := browser.width(width)) > width:
                            faults.append(("outside", f"{wide} pixels wide in a window of {width}"))
                        faults += [("outside", f"cut in a window of {width}: {text}") for text in browser.cut()]
                    pdf.write_bytes(browser.print())
                elif format == "typ":
                    compiled(str(path), output=str(pdf))
                elif format == "tex":
                    faults += latex(path)
                    path.with_suffix(".pdf").replace(pdf)
                elif format == "docx":
                    office(folder, [path])
                    path.with_suffix(".pdf").replace(pdf)
                pages, found = measured(pdf, MARGINS[format], note["titles"])
                faults += found
            except Exception as error:  # what any of the programs says is a fault of the note
                faults.append(("failed", str(error).strip().splitlines()[0][:200]))
            results.append({"name": note["name"], "format": format, "pages": pages, "faults": faults})
    if browser:
        browser.close()
    return results


if __name__ == "__main__":
    json.dump(run(json.loads(sys.stdin.read())), sys.stdout)
