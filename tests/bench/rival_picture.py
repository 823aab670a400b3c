"""The rows of the rivals as a picture: seconds on a log axis against dB, a panel for each scene and choice of objects."""

from burnish.charting.picture import COLOURS, FAINT, INK, SOFT, save as save_picture

from rival_scene import WHOLE, WITHOUT_LONG
from rival_table import TARGET_DB, select

RIVALS = {"Cycles": "#222222", "OpenImageIO": "#b8860b", "default": "#00a5b5", **COLOURS}
SECONDS = {0.001: "1 ms", 0.01: "10 ms", 0.1: "0.1 s", 1: "1 s", 10: "10 s", 100: "100 s"}
TITLE = "What a user may do instead: time and error of the same picture on the same two cores"
SUBTITLE = ("Filled: a frame's own time (burnish: surfaces and shading; Cycles: rendering without synchronisation; OpenImageIO: lookups). "
            "Hollow: the whole program.\nAll against burnish's reference, whose noise is taken out; display PSNR.")


def draw_panel(panel, rows):
    """Lines of all families: filled marks for a frame, hollow ones for the whole program."""
    panel.set_xscale("log")
    panel.axhline(TARGET_DB, color=SOFT, linewidth=1, linestyle="--")
    for family in dict.fromkeys(row["family"] for row in rows):
        points, colour = select(rows, family=family), RIVALS[family]
        panel.plot([row["frame_s"] for row in points], [row["db"] for row in points], "-o", color=colour, linewidth=2,
                   markersize=7, markeredgecolor="white", label=family.replace("_", " "), zorder=3)
        panel.plot([row["process_s"] for row in points], [row["db"] for row in points], "o", color=colour, markersize=6,
                   markerfacecolor="none", alpha=0.8)
    panel.set_xticks(list(SECONDS), SECONDS.values())
    panel.minorticks_off()
    panel.tick_params(length=0, labelsize=12, colors=SOFT, labelbottom=True)
    panel.grid(color=FAINT, linewidth=1)
    panel.set_axisbelow(True)
    panel.spines[:].set_visible(False)
    panel.margins(x=0.06, y=0.08)


def draw(rows):
    """The picture as a matplotlib Figure."""
    from matplotlib.figure import Figure

    scenes, parts = list(dict.fromkeys(row["scene"] for row in rows)), (WHOLE, WITHOUT_LONG)
    figure = Figure(figsize=(15, 3 + 4.2 * len(scenes)), dpi=100, facecolor="white")
    panels = figure.subplots(len(scenes), len(parts), sharex=True, sharey="row", squeeze=False)
    head = 1 - 1.15 / figure.get_figheight()
    figure.subplots_adjust(left=0.05, right=0.985, top=head, bottom=1.1 / figure.get_figheight(), wspace=0.05, hspace=0.2)
    for line, scene in zip(panels, scenes):
        line[0].set_ylabel("dB", fontsize=13, color=INK)
        for panel, part in zip(line, parts):
            draw_panel(panel, select(rows, scene=scene, part=part))
            panel.set_title(f"{scene}: {part}", loc="left", fontsize=14, fontweight="bold", color=INK)
    figure.text(0.05, 1 - 0.35 / figure.get_figheight(), TITLE, fontsize=18, fontweight="bold", color=INK)
    figure.text(0.05, 1 - 0.48 / figure.get_figheight(), SUBTITLE, fontsize=12, color=SOFT, va="top", linespacing=1.4)
    figure.legend(*panels[0][0].get_legend_handles_labels(), loc="lower center", ncols=7, frameon=False, fontsize=13)
    return figure


def save(rows, path):
    """Write the PNG."""
    save_picture(draw(rows), path)
