# SPDX-License-Identifier: MIT
"""A flame graph as one SVG: each function a bar over the one that called it, as wide as what it took
with all that it called (after Brendan Gregg's, who thought of them)."""

import html
import zlib

WIDTH, ROW, MARGIN, HEAD = 1280, 18, 10, 44
LETTER = 6.7            # pixels a letter of the font takes
NARROWEST = 0.4         # pixels; a narrower bar is left out, but not its width
HUES = ((28, 82, 66), (205, 62, 68), (152, 42, 62), (345, 60, 72), (262, 45, 73), (48, 78, 62), (186, 45, 60))
STYLE = ("text{font:11px 'DejaVu Sans Mono',Menlo,Consolas,monospace;fill:#1c2430}"
         ".t{font:bold 14px 'DejaVu Sans',Arial,sans-serif}.s{fill:#5b6675}"
         "rect{stroke:#fff;stroke-width:.5}.i{stroke:#5b6675;stroke-dasharray:2 2}"
         "g:hover rect{stroke:#1c2430;stroke-width:1;stroke-dasharray:none}")


def tree(stacks):
    """{(names...): number} as nodes [number with children, {name: node}]."""
    root = [0, {}]
    for names, number in stacks.items():
        node = root
        node[0] += number
        for name in names:
            node = node[1].setdefault(name, [0, {}])
            node[0] += number
    return root


def _depth(node):
    return 1 + max(map(_depth, node[1].values()), default=0)


def _colour(name):
    """A function's colour: always the same one."""
    hue, saturation, light = HUES[zlib.crc32(name.split(" ")[0].encode()) % len(HUES)]
    return f"hsl({hue},{saturation}%,{light}%)"


def _bar(name, number, total, x, y, width, marked):
    share = f"{name}: {number:,} ({100 * number / total:.2f} %)"
    room = int((width - 6) / LETTER)
    label = name if len(name) <= room else name[:room - 1] + "…" if room > 3 else ""
    text = f'<text x="{x + 3:.1f}" y="{y + 13}">{html.escape(label)}</text>' if label else ""
    kind = ' class="i"' if marked in name else ""
    return (f'<g><title>{html.escape(share)}</title><rect x="{x:.2f}" y="{y}" width="{width:.2f}" '
            f'height="{ROW - 1}" rx="2" fill="{_colour(name)}"{kind}/>{text}</g>')


def _bars(node, total, x, level, height, scale, marked):
    for name, child in sorted(node[1].items()):
        width = child[0] * scale
        if width >= NARROWEST:
            yield _bar(name, child[0], total, x, height - MARGIN - (level + 1) * ROW, width, marked)
            yield from _bars(child, total, x, level + 1, height, scale, marked)
        x += width


def svg(stacks, title, subtitle, marked):
    """The graph of {(names, outermost first): number}; bars whose name holds `marked` are dashed."""
    root = tree(stacks)
    height = HEAD + _depth(root) * ROW + MARGIN
    scale = (WIDTH - 2 * MARGIN) / max(1, root[0])
    bars = "\n".join(_bars(root, max(1, root[0]), MARGIN, 0, height, scale, marked))
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" width="{WIDTH}" '
            f'height="{height}"><title>{html.escape(title)}</title><style>{STYLE}</style>'
            f'<rect width="100%" height="100%" fill="#fff"/>'
            f'<text class="t" x="{MARGIN}" y="20">{html.escape(title)}</text>'
            f'<text class="s" x="{MARGIN}" y="36">{html.escape(subtitle)}</text>\n{bars}\n</svg>\n')
