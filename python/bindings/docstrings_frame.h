// Docstrings of the compiled class that stands for a frame, numpydoc; _core.pyi has the types.
#pragma once

namespace burnish::python::docs {

inline constexpr const char* Frame = R"(A frame read once, to be shaded many times: stands for `aovs` in ``composite``.

It holds the layers that its settings ask for, and its camera.

Parameters
----------
**settings
    Settings by name: aovs, what the frame wears (material, materials, assign) and, where wanted, camera, channel, view, ...

Attributes
----------
width, height : int
    Pixels.
up : str
    "y" or "z": the up axis of the world of its renderer.

Raises
------
BadArgument
    A setting is unknown or out of range; no material is named.
ReadFailed
    The file is absent, corrupt, deep or no EXR.
MissingChannel
    A layer that the settings need is not there.)";

}  // namespace burnish::python::docs
