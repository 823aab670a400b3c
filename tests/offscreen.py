"""Shaders run without a window: EGL and OpenGL 3.3 by ctypes alone, as Mesa's software renderer gives them."""

import ctypes
import ctypes.util

import numpy as np

SURFACELESS, OPENGL_API, OPENGL_BIT, RENDERABLE, NO_MORE = 0x31DD, 0x30A2, 8, 0x3040, 0x3038
CONTEXT_3_3_CORE = [0x3098, 3, 0x30FB, 3, 0x30FD, 1, NO_MORE]
TEXTURE_2D, CUBE, FACES, FLOAT, BYTES, RGB, RGBA = 0x0DE1, 0x8513, 0x8515, 0x1406, 0x1401, 0x1907, 0x1908
RGB32F, RGBA32F, RGBA8, LINEAR, NEAREST, CLAMP, SEAMLESS = 0x8815, 0x8814, 0x8058, 0x2601, 0x2600, 0x812F, 0x884F
GL_FACES = (0, 1, 2, 3, 5, 4)  # of burnish's strips: GL has -Z before +Z as burnish counts them

VERTEX = "#version 330 core\nvoid main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }\n"
FRAGMENT = """#version 330 core
{snippet}
uniform sampler2D first, second;
out vec4 color;
void main() {{
    ivec2 place = ivec2(gl_FragCoord.xy);
    color = vec4(burnish_factored(texelFetch(first, place, 0).xyz, texelFetch(second, place, 0).xyz), 1.0);
}}
"""


def attributes(*values):
    return (ctypes.c_int * len(values))(*values)


class Offscreen:
    """A context of OpenGL 3.3 that draws into textures of floats; raises OSError where there is none."""

    def __init__(self):
        self.egl = ctypes.CDLL(ctypes.util.find_library("EGL") or "libEGL.so.1")
        for name in ("eglGetPlatformDisplay", "eglCreateContext", "eglGetProcAddress"):
            getattr(self.egl, name).restype = ctypes.c_void_p
        display = ctypes.c_void_p(self.egl.eglGetPlatformDisplay(SURFACELESS, None, None))
        config, count = ctypes.c_void_p(), ctypes.c_int()
        if not self.egl.eglInitialize(display, None, None) or not self.egl.eglBindAPI(OPENGL_API):
            raise OSError("EGL has no surfaceless display")
        self.egl.eglChooseConfig(display, attributes(RENDERABLE, OPENGL_BIT, NO_MORE), ctypes.byref(config), 1, ctypes.byref(count))
        context = ctypes.c_void_p(self.egl.eglCreateContext(display, config, None, attributes(*CONTEXT_3_3_CORE)))
        if not self.egl.eglMakeCurrent(display, None, None, context):
            raise OSError("EGL has no OpenGL 3.3")
        self.gl("Enable", SEAMLESS)
        array = ctypes.c_uint()
        self.gl("GenVertexArrays", 1, ctypes.byref(array))
        self.gl("BindVertexArray", array.value)

    def gl(self, name, *arguments):
        """Calls gl<name>; every argument is an int, a pointer or bytes."""
        call = ctypes.CFUNCTYPE(ctypes.c_int, *[ctypes.c_int if isinstance(a, int) else ctypes.c_char_p if isinstance(a, bytes)
                                                else ctypes.c_void_p for a in arguments])
        return call(self.egl.eglGetProcAddress(b"gl" + name.encode()))(*arguments)

    def texture(self, unit, pixels, cube=False, filtering=LINEAR):
        """Makes a texture of rows of floats or bytes, or a cube of a strip of faces, the current one of a unit."""
        kind, name = CUBE if cube else TEXTURE_2D, ctypes.c_uint()
        self.gl("GenTextures", 1, ctypes.byref(name))
        self.gl("ActiveTexture", 0x84C0 + unit)
        self.gl("BindTexture", kind, name.value)
        for parameter, value in ((0x2800, filtering), (0x2801, filtering), (0x2802, CLAMP), (0x2803, CLAMP), (0x8072, CLAMP)):
            self.gl("TexParameteri", kind, parameter, value)
        self.gl("PixelStorei", 0x0CF5, 1)
        is_float, height = pixels.dtype == np.float32, pixels.shape[0] // (6 if cube else 1)
        stored = (RGB32F if pixels.shape[2] == 3 else RGBA32F) if is_float else RGBA8
        for face in range(6 if cube else 1):
            rows = np.ascontiguousarray(pixels[face * height : (face + 1) * height])
            target = FACES + GL_FACES[face] if cube else TEXTURE_2D
            self.gl("TexImage2D", target, 0, stored, pixels.shape[1], height, 0, RGB if pixels.shape[2] == 3 else RGBA,
                    FLOAT if is_float else BYTES, rows.ctypes.data_as(ctypes.c_void_p))
        return name.value

    def compiled(self, kind, source):
        shader, text = self.gl("CreateShader", kind), ctypes.c_char_p(source.encode())
        self.gl("ShaderSource", shader, 1, ctypes.byref(text), None)
        self.gl("CompileShader", shader)
        log, length = ctypes.create_string_buffer(4096), ctypes.c_int()
        self.gl("GetShaderInfoLog", shader, 4096, ctypes.byref(length), log)
        assert not length.value, log.value.decode()
        return shader

    def shade(self, snippet, maps, first, second):
        """burnish_factored of a snippet at rows of directions; maps: sampler -> pixels, cubes where they are six times as high as wide."""
        program = self.gl("CreateProgram")
        for kind, source in ((0x8B31, VERTEX), (0x8B30, FRAGMENT.format(snippet=snippet))):
            self.gl("AttachShader", program, self.compiled(kind, source))
        self.gl("LinkProgram", program)
        self.gl("UseProgram", program)
        rows = {"first": first[None].astype(np.float32), "second": second[None].astype(np.float32)}
        for unit, (sampler, pixels) in enumerate({**rows, **maps}.items()):
            self.texture(unit, pixels, pixels.shape[0] == 6 * pixels.shape[1], NEAREST if sampler in rows else LINEAR)
            self.gl("Uniform1i", self.gl("GetUniformLocation", program, sampler.encode()), unit)
        return self.drawn(len(first))

    def drawn(self, width):
        target = self.texture(15, np.zeros((1, width, 4), np.float32), filtering=NEAREST)
        buffer, pixels = ctypes.c_uint(), np.zeros((1, width, 4), np.float32)
        self.gl("GenFramebuffers", 1, ctypes.byref(buffer))
        self.gl("BindFramebuffer", 0x8D40, buffer.value)
        self.gl("FramebufferTexture2D", 0x8D40, 0x8CE0, TEXTURE_2D, target, 0)
        self.gl("Viewport", 0, 0, width, 1)
        self.gl("DrawArrays", 4, 0, 3)
        self.gl("ReadPixels", 0, 0, width, 1, RGBA, FLOAT, pixels.ctypes.data_as(ctypes.c_void_p))
        assert self.gl("GetError") == 0
        return pixels[0, :, :3]
