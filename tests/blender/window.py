"""Runs inside Blender with a window: the three clicks as from their buttons, and a slider that moves.

    xvfb-run -s "-screen 0 1600x900x24" blender --factory-startup -W -p 0 0 1600 900 --python window.py -- ZIP FOLDER [PICTURE]

Prints "WINDOW ok", or what went wrong. With PICTURE the scene is a still life and the window is photographed (xdotool, ImageMagick):
so docs/images/blender.png was made.
"""

import os
import pathlib
import subprocess
import sys
import time
import traceback

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import bpy  # noqa: E402
import small_scene  # noqa: E402
import still_life  # noqa: E402

ZIP, FOLDER, *PICTURE = sys.argv[sys.argv.index("--") + 1:]
PICTURE, SIZE = PICTURE[:1], PICTURE[1:]
SCENE = (still_life, *map(int, SIZE or (960, 540, 128))) if PICTURE else (small_scene, 96, 54, 8)
PATIENCE = 1200 if PICTURE else 120  # seconds
TAB = (1309, 291)  # of the sidebar, in a window of 1600 x 900


def with_window():
    """What a button would be pressed in."""
    window = bpy.context.window_manager.windows[0]
    area = next(area for area in window.screen.areas if area.type == "IMAGE_EDITOR")
    return bpy.context.temp_override(window=window, area=area, region=next(r for r in area.regions if r.type == "WINDOW"))


def arrange():
    """An Image Editor with its sidebar, and burnish's panel in the Render properties."""
    screen = bpy.context.window_manager.windows[0].screen
    largest = max(screen.areas, key=lambda area: area.width * area.height)
    largest.type = "IMAGE_EDITOR"
    largest.spaces.active.show_region_ui = True
    properties = next(area for area in screen.areas if area.type == "PROPERTIES").spaces.active
    properties.context, properties.search_filter = "RENDER", "burnish"
    bpy.context.preferences.view.render_display_type = "NONE"
    for kind in ("OUTLINER", "DOPESHEET_EDITOR"):
        with bpy.context.temp_override(area=next(area for area in screen.areas if area.type == kind)):
            bpy.ops.screen.area_close()


def story():
    """Yields what Blender has to go on for by itself, until it holds."""
    bpy.ops.preferences.addon_install(filepath=os.path.abspath(ZIP))
    bpy.ops.preferences.addon_enable(module="burnish_addon")
    from burnish_addon import background, live

    make, *size = SCENE
    make.build(FOLDER, *size)
    yield lambda: True
    arrange()
    scene = bpy.context.scene
    scene.burnish.folder = FOLDER
    with with_window():
        bpy.ops.burnish.prepare("INVOKE_DEFAULT")
        kept = scene.render.image_settings.file_format
        bpy.ops.burnish.render("INVOKE_DEFAULT")
    yield lambda: bool(scene.burnish.frame_file)
    assert scene.render.image_settings.file_format == kept, "the output settings are back"
    with with_window():
        bpy.ops.burnish.composite("INVOKE_DEFAULT")
    assert background.is_running()
    yield lambda: live.session(scene) is not None
    with with_window():
        bpy.ops.burnish.compare("INVOKE_DEFAULT")
    yield lambda: bool(scene.burnish.compared)
    scene.burnish.material = scene.burnish.materials.find("steel")
    for moves in range(1, 6):
        scene.burnish.materials["steel"].roughness *= 0.9
        yield lambda: len(live.latencies(scene)) == moves
    if PICTURE:
        yield from photograph()
    with with_window():
        bpy.ops.burnish.composite("INVOKE_DEFAULT")
    bpy.ops.preferences.addon_disable(module="burnish_addon")
    assert not background.is_running(), "work ends with the add-on"


def photograph():
    """Show the composite beside its sliders."""
    for words in (("mousemove", *map(str, TAB)), ("click", "1"), ("mousemove", "600", "880")):
        subprocess.run(["xdotool", *words], check=True)
        yield after(1)
    with with_window():
        bpy.ops.image.view_all(fit_view=True)
    yield after(2)
    subprocess.run(["import", "-window", "root", *PICTURE], check=True)


def after(seconds):
    """Whether so much time has gone."""
    end = time.monotonic() + seconds
    return lambda: time.monotonic() > end


class Teller:
    """Goes on with the story in Blender's own time."""

    def __init__(self):
        self.story, self.is_ready, self.since = story(), lambda: True, time.monotonic()

    def __call__(self):
        try:
            if time.monotonic() - self.since > PATIENCE:
                raise TimeoutError("Blender did not go on")
            if not self.is_ready():
                return 0.1
            self.is_ready, self.since = next(self.story), time.monotonic()
            return 0.3
        except StopIteration:
            print("WINDOW ok", flush=True)
        except Exception:
            traceback.print_exc()
        bpy.ops.wm.quit_blender()
        return None


bpy.app.timers.register(Teller(), first_interval=0.5, persistent=True)
