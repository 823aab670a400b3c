// Surfaces and textures for the hard cases; patterns are functions of the pixel.
#pragma once

#include <burnish/input/frame.h>

namespace burnish {

/// In [0, 1]: white noise; a ramp over 600 pixels, up and down; the product of sines with a period in pixels.
float noise(int x, int y);
float ramp(int x);
float waves(int x, int y, float period);

/// Slopes to tilt normals by: white noise, 0.05 and 0.01; smooth bumps of 12 pixels, 0.3; waves of 200 pixels, 0.2; flat tiles of 24
/// pixels with bevels of two.
Vec2f noisy_slope(int x, int y);
Vec2f faint_slope(int x, int y);
Vec2f bumpy_slope(int x, int y);
Vec2f wavy_slope(int x, int y);
Vec2f tiled_slope(int x, int y);

/// Tilts every normal by slope(x, y) along two directions across it.
void tilt_normals(AovFrame& frame, Vec2f (*slope)(int x, int y));

void round_to_half(Image& image);

/// Slanted cylinders, `width` pixels thick, 24 pixels apart, over nothing.
AovFrame wire_frame(int width, int height, float thickness);
/// A floor seen at 60 degrees: one normal, many views.
AovFrame plane_frame(int width, int height);

/// A layer of the frame's size, every pixel set by value(x, y, out).
template <class Value>
Image make_layer(const AovFrame& frame, int channels, Value&& value) {
    Image layer(frame.data_window.width, frame.data_window.height, channels);
    for (int y = 0; y < layer.height; ++y)
        for (int x = 0; x < layer.width; ++x) value(x, y, layer.at(x, y));
    return layer;
}

}  // namespace burnish
