"""A report as one HTML file that needs no other: text, tables, and pictures inside it."""

from __future__ import annotations

import base64
import html
import io

import numpy as np

STYLE = """body{font:15px/1.5 system-ui,sans-serif;color:#222;max-width:1120px;margin:2em auto;padding:0 1em}
h1{font-size:1.7em}h2{margin-top:2em;border-bottom:1px solid #ddd}table{border-collapse:collapse;margin:1em 0}
th,td{padding:.2em .7em;text-align:right;border-bottom:1px solid #eee}th:first-child,td:first-child{text-align:left}
figure{display:inline-block;margin:.6em .6em .6em 0;vertical-align:top}figcaption{color:#555;max-width:60em}
img{max-width:100%}.bad{color:#b3261e;font-weight:bold}"""


class Page:
    """Parts are added from top to bottom; all text is plain and escaped here."""

    def __init__(self, title):
        self.title = title
        self.parts = [f"<h1>{html.escape(title)}</h1>"]

    def heading(self, text):
        """Begin a section."""
        self.parts.append(f"<h2>{html.escape(text)}</h2>")

    def text(self, text):
        """A paragraph."""
        self.parts.append(f"<p>{html.escape(text)}</p>")

    def table(self, header, rows, bad=()):
        """Strings or numbers; rows whose index is in `bad` stand out."""
        def line(cells, tag, style=""):
            return f"<tr{style}>" + "".join(f"<{tag}>{html.escape(shown(cell))}</{tag}>" for cell in cells) + "</tr>"

        body = [line(row, "td", ' class="bad"' if index in bad else "") for index, row in enumerate(rows)]
        self.parts.append(f"<table>{line(header, 'th')}{''.join(body)}</table>")

    def picture(self, image, caption=""):
        """A matplotlib Figure, or an array of shape (height, width, 3) that a display shows: uint8, or float in [0, 1]."""
        data = base64.b64encode(png(image)).decode("ascii")
        self.parts.append(f'<figure><img alt="{html.escape(caption, quote=True)}" src="data:image/png;base64,{data}">'
                          f"<figcaption>{html.escape(caption)}</figcaption></figure>")

    def text_of(self):
        """The whole document."""
        return ("<!doctype html><html lang=en><meta charset=utf-8>"
                f"<title>{html.escape(self.title)}</title><style>{STYLE}</style>{''.join(self.parts)}</html>\n")


def shown(cell):
    """Floats with four digits, the rest as it is."""
    return f"{cell:.4g}" if isinstance(cell, float) else str(cell)


def png(image):
    """A picture as bytes of a PNG."""
    from PIL import Image

    memory = io.BytesIO()
    if hasattr(image, "savefig"):
        from matplotlib.backends.backend_agg import FigureCanvasAgg

        FigureCanvasAgg(image).print_png(memory)
        return memory.getvalue()
    pixels = np.asarray(image)
    if pixels.dtype != np.uint8:
        pixels = np.round(255 * np.clip(np.nan_to_num(pixels), 0, 1)).astype(np.uint8)
    Image.fromarray(pixels).save(memory, format="PNG", optimize=True)
    return memory.getvalue()
